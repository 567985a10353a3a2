"""What the models of chips share: a core that Unicorn emulates, its memory and registers, and its display.

A chip's program is run until its display has shown some frames. The model of DMA sends a band at the last moment, when
the program waits for it. So a program that draws into a band that is being sent shows a wrong picture. The display
follows the data sheets: CS selects it, and DC tells commands from data; CASET and RASET set a window, and RAMWR writes
to it.
"""
import collections
import struct
import sys

try:
    from elftools.elf.elffile import ELFFile
    from unicorn import UC_HOOK_BLOCK, UcError
except ImportError as error:
    sys.exit(f"{error} (Debian: python3-unicorn python3-pyelftools; pip: unicorn pyelftools)")

FRAMES = 10  # one clears the display, one begins with a black band; the last but one is shown once the last begins
CYCLES = 1.5  # for an instruction, as these cores need them with their programs in flash


class Display:
    def __init__(self, chip):
        self.chip, self.cs, self.dc = chip, True, True
        self.command, self.data = None, bytearray()
        self.window, self.pixels, self.frames = {}, [], []

    def pins(self, cs, dc, high):
        self.cs = high if cs else self.cs
        self.dc = high if dc else self.dc

    def receive(self, data):
        if self.cs:
            sys.exit(f"{bytes(data[:8]).hex()} was sent while no display listened")
        if self.dc:
            self.data += bytes(data)
            return
        for command in data:
            self.execute()
            self.command = command
            if command == 0x2C:
                self.frames.append(self.chip.moment(len(self.frames)))
                if len(self.frames) == FRAMES:
                    self.chip.core.emu_stop()

    def execute(self):
        """Executes the last command, which now has all of its data."""
        if self.command in (0x2A, 0x2B):
            self.window[self.command] = struct.unpack(">HH", self.data)
        elif self.command == 0x2C:
            self.pixels = struct.unpack(f">{len(self.data) // 2}H", self.data)
        self.data.clear()

    def write(self, path):
        (left, right), (top, bottom) = self.window[0x2A], self.window[0x2B]
        width, height = right - left + 1, bottom - top + 1
        if len(self.pixels) != width * height:
            sys.exit(f"{len(self.pixels)} pixels in a window of {width}x{height}")
        with open(path, "wb") as file:
            file.write(f"P6 {width} {height} 255\n".encode())
            for pixel in self.pixels:
                channels = (pixel >> 11, 31), (pixel >> 5 & 63, 63), (pixel & 31, 31)
                file.write(bytes((level * 255 + most // 2) // most for level, most in channels))
        return self.frames[-2]


class Chip:
    """A core, its memory, and registers that keep what is written to them, unless a subclass does more.

    A subclass has the core's registers STACK and PC, the clocks CLOCK_HZ and BUS_HZ, `length` of an instruction, and
    `resume`.
    """

    def __init__(self, program, core, memory, registers):
        self.core = core
        for start, size in memory:
            core.mem_map(start, size)
        for start, size in registers:
            core.mmio_map(start, size, lambda _, at, __, start: self.guard(self.read, start + at) & 0xFFFFFFFF, start,
                          lambda _, at, __, value, start: self.guard(self.write, start + at, value), start)
        self.registers = collections.defaultdict(int)
        self.microseconds, self.transfer, self.failure = 0, None, None
        self.instructions, self.blocks, self.starts, self.lowest = 0, {}, [], 1 << 32
        core.hook_add(UC_HOOK_BLOCK, self.count)
        self.display = Display(self)
        self.load(program)
        for address, data in self.segments:
            core.mem_write(address, data)

    def load(self, program):
        with open(program, "rb") as file:
            elf = ELFFile(file)
            self.entry = elf["e_entry"]
            self.segments = [(part["p_paddr"], part.data()) for part in elf.iter_segments("PT_LOAD")]
            symbols = elf.get_section_by_name(".symtab").iter_symbols()
            self.symbols = {symbol.name: symbol["st_value"] for symbol in symbols}
        self.stack = self.symbols["_stack_start"]

    def moment(self, _):
        """The time in ms of the frame with a number, which begins now."""
        return self.microseconds // 1000

    def count(self, _, address, size, __):
        """Counts the instructions of a block that begins, and finds the deepest stack. Blocks do not change."""
        self.lowest = min(self.lowest, self.core.reg_read(self.STACK) or self.lowest)
        found = self.blocks.get((address, size))
        if found is None:
            code, at, found = self.core.mem_read(address, size), 0, 0
            while at < size:
                at += self.length(code[at : at + 2])
                found += 1
            self.blocks[address, size] = found
        self.instructions += found

    def frames(self, bands):
        """The mean of the instructions for a frame and of the seconds that it takes. The first band that is sent is
        black, while the first one of a frame is drawn."""
        work = [after[0] - before[0] for before, after in zip(self.starts, self.starts[1:])]
        frames = len(work) // bands
        seconds = [max(CYCLES * count / self.CLOCK_HZ, 8 * size / self.BUS_HZ)
                   for count, (_, size) in zip(work, self.starts)]
        return sum(work[: frames * bands]) / frames, sum(seconds[: frames * bands]) / frames

    def read(self, address):
        return self.registers[address]

    def write(self, address, value):
        self.registers[address] = value

    def word(self, address):
        return struct.unpack("<I", self.core.mem_read(address, 4))[0]

    def begin(self, transfer, size):
        """Begins to send `size` bytes. Those after the second command to write are bands: the first one clears."""
        self.transfer = transfer
        if len(self.display.frames) > 1 and self.display.dc and size > 64:
            self.starts.append((self.instructions, size))

    def send(self):
        """Ends the transfer under way. Returns whether there was one."""
        transfer, self.transfer = self.transfer, None
        if transfer:
            self.display.receive(transfer())
        return transfer is not None

    def run(self, at):
        """Runs the program until the display has shown all frames."""
        while len(self.display.frames) < FRAMES:
            self.start(at)
            at = self.resume(self.core.reg_read(self.PC))

    def start(self, at, until=0):
        try:
            self.core.emu_start(at, until)
        except UcError as error:
            sys.exit(f"{error} at {self.core.reg_read(self.PC):#x}")
        if self.failure:
            raise self.failure

    def guard(self, access, *arguments):
        """Reads or writes a register. Unicorn ignores exceptions there, so `start` raises them."""
        try:
            return access(*arguments)
        except BaseException as failure:
            self.failure = self.failure or failure
            self.core.emu_stop()
            return 0

    def report(self, picture):
        """Writes the picture and prints the results."""
        now_ms = self.display.write(picture)
        count, seconds = self.frames(bands=2 * len(self.display.pixels) // self.starts[0][1])
        print(now_ms, round(count), round(seconds * 1e6), self.stack - self.lowest)
