"""What the models of chips share: a core that Unicorn emulates, its memory and registers, and its display.

A chip's program is run until its display has shown some frames. The model of DMA sends a band at the last moment, when
the program waits for it. So a program that draws into a band that is being sent shows a wrong picture. The display
follows the data sheets: CS selects it, and DC tells commands from data; CASET and RASET set a window, and RAMWR writes
to it. MADCTL and the inversion say what becomes of the pixels on the glass of the chip's module.
"""
import collections
import struct
import sys
from typing import NamedTuple

try:
    from elftools.elf.elffile import ELFFile
    from unicorn import UC_HOOK_BLOCK, UcError
except ImportError as error:
    sys.exit(f"{error} (Debian: python3-unicorn python3-pyelftools; pip: unicorn pyelftools)")

FRAMES = 10  # one clears the display, one begins with a black band; the last but one is shown once the last begins
CYCLES = 1.5  # for an instruction, as these cores need them with their programs in flash


class Module(NamedTuple):
    """How a module's glass differs from others: its columns and rows before a rotation, those of the controller's
    memory, the turns by 90 degrees that the program is to make, and whether the glass is mirrored, has blue for red,
    and shows a negative unless the controller inverts. The limit of its bus is the usual one. The glass begins at an
    offset in memory."""
    size: tuple
    memory: tuple
    rotation: int
    is_mirrored: bool
    is_blue_first: bool
    is_inverted: bool
    limit_hz: float
    offset: tuple = (0, 0)


ST7789 = Module((240, 240), (240, 320), 0, False, False, True, 62.5e6)
ILI9341 = Module((240, 320), (240, 320), 1, True, True, False, 42e6)


class Display:
    def __init__(self, chip):
        self.chip, self.cs, self.dc = chip, True, True
        self.module, self.mode, self.is_inverted = ST7789, 0, False
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
        elif self.command == 0x36:
            self.mode = self.data[0]
        elif self.command in (0x20, 0x21):
            self.is_inverted = self.command == 0x21
        elif self.command == 0x2C:
            self.pixels = struct.unpack(f">{len(self.data) // 2}H", self.data)
        self.data.clear()

    def cell(self, column, row):
        """The place in the controller's memory of the program's column and row."""
        (width, height), mode = self.module.memory, self.mode
        x, y = (row, column) if mode & 0x20 else (column, row)
        return width - 1 - x if mode & 0x40 else x, height - 1 - y if mode & 0x80 else y

    def seen(self, column, row):
        """The place in memory of what somebody sees who has turned the module so that the picture is upright."""
        width, height = self.module.size
        x, y = [(column, row), (width - 1 - row, column), (width - 1 - column, height - 1 - row),
                (row, height - 1 - column)][self.module.rotation]
        left, top = self.module.offset
        return left + (width - 1 - x if self.module.is_mirrored else x), top + y

    def write(self, path):
        (left, right), (top, bottom) = self.window[0x2A], self.window[0x2B]
        width, height = right - left + 1, bottom - top + 1
        if len(self.pixels) != width * height:
            sys.exit(f"{len(self.pixels)} pixels in a window of {width}x{height}")
        if self.chip.BUS_HZ > self.module.limit_hz:
            sys.exit(f"the bus has {self.chip.BUS_HZ} Hz, but the controller only {self.module.limit_hz}")
        memory = {}
        for at, pixel in enumerate(self.pixels):
            memory[self.cell(left + at % width, top + at // width)] = pixel
        columns, rows = self.module.size[:: -1 if self.module.rotation & 1 else 1]
        with open(path, "wb") as file:
            file.write(f"P6 {columns} {rows} 255\n".encode())
            for row in range(rows):
                file.write(bytes(level for column in range(columns)
                                 for level in self.color(memory.get(self.seen(column, row), 0))))
        return self.frames[-2]

    def color(self, pixel):
        """Red, green and blue of a pixel."""
        channels = [(pixel >> 11, 31), (pixel >> 5 & 63, 63), (pixel & 31, 31)]
        levels = [(level * 255 + most // 2) // most for level, most in channels]
        if bool(self.mode & 8) != self.module.is_blue_first:
            levels.reverse()
        return levels if self.is_inverted == self.module.is_inverted else [255 - level for level in levels]


class Chip:
    """A core, its memory, and registers that keep what is written to them, unless a subclass does more.

    A subclass has the core's registers STACK and PC, the clocks CLOCK_HZ and BUS_HZ, `length` of an instruction, and
    `resume`, which `run` calls.
    """

    instructions = 0  # that were executed
    BUS_GAPS = 1  # a band's time on the bus is longer by this factor

    def __init__(self, program, core, memory, registers):
        self.core = core
        self.registers = collections.defaultdict(int)
        self.microseconds, self.transfer, self.failure = 0, None, None
        self.blocks, self.starts, self.lowest = {}, [], 1 << 32
        self.connect(core, memory, registers)
        self.display = Display(self)
        self.load(program)
        for address, data in self.segments:
            core.mem_write(address, data)

    def connect(self, core, memory, registers):
        """Gives a core its memory and the chip's registers, and counts what it does."""
        for start, size in memory:
            core.mem_map(start, size)
        for start, size in registers:
            core.mmio_map(start, size, lambda _, at, __, start: self.guard(self.read, start + at) & 0xFFFFFFFF, start,
                          lambda _, at, __, value, start: self.guard(self.write, start + at, value), start)
        core.hook_add(UC_HOOK_BLOCK, self.count)

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
        """Counts the instructions of a block that begins, and finds the deepest stack."""
        self.lowest = min(self.lowest, self.core.reg_read(self.STACK) or self.lowest)
        self.instructions += self.block(address, size)

    def block(self, address, size):
        """The instructions of a block. Blocks do not change."""
        found = self.blocks.get((address, size))
        if found is None:
            code, at, found = self.core.mem_read(address, size), 0, 0
            while at < size:
                at += self.length(code[at : at + 2])
                found += 1
            self.blocks[address, size] = found
        return found

    def frames(self, bands):
        """The mean of the instructions for a frame and of the seconds that it takes. The first band that is sent is
        black, while the first one of a frame is drawn."""
        work = [after[0] - before[0] for before, after in zip(self.starts, self.starts[1:])]
        frames = len(work) // bands
        seconds = [max(CYCLES * count / self.CLOCK_HZ, 8 * size / self.BUS_HZ * self.BUS_GAPS)
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

    def stacks(self):
        """The bytes of each stack that is used."""
        return [self.stack - self.lowest]

    def report(self, picture):
        """Writes the picture and prints the results."""
        now_ms = self.display.write(picture)
        count, seconds = self.frames(bands=2 * len(self.display.pixels) // self.starts[0][1])
        print(now_ms, round(count), round(self.BUS_HZ / 1000), round(seconds * 1e6), *self.stacks())
