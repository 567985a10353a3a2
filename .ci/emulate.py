#!/usr/bin/python3
"""Runs the STM32F4's program on an emulated core, with a model of the registers that it needs, and of its display.

emulate.py PROGRAM PICTURE.ppm

Writes what the display shows after some frames. Prints the time in ms at which the last one was drawn; the mean of the
instructions for a frame; a frame's time in microseconds, at 1.5 cycles for an instruction (a band is drawn while another
one is sent, and the longer of the two counts); and the bytes of stack. The model of DMA sends a band at the last moment, when the program waits for it. So a program that draws into a band that is being
sent shows a wrong picture. The display follows the data sheets: CS selects it, and DC tells commands from data; CASET
and RASET set a window, and RAMWR writes to it. Registers have the addresses of the STM32F405's reference manual, RM0090.
Only Debian's own Python finds the packages python3-unicorn and python3-pyelftools.
"""
import collections
import struct
import sys

from elftools.elf.elffile import ELFFile
from unicorn import UC_ARCH_ARM, UC_HOOK_BLOCK, UC_HOOK_CODE, UC_MODE_MCLASS, UC_MODE_THUMB, Uc, UcError
from unicorn.arm_const import (UC_ARM_REG_LR, UC_ARM_REG_PC, UC_ARM_REG_PRIMASK, UC_ARM_REG_R0, UC_ARM_REG_R1,
                               UC_ARM_REG_R2, UC_ARM_REG_SP, UC_CPU_ARM_CORTEX_M0, UC_CPU_ARM_CORTEX_M4)

RETURN = 0x08080000  # the return address of interrupt handlers: flash that no program uses
FRAMES = 10  # one clears the display, one begins with a black band; the last but one is shown once the last begins


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
                self.frames.append(self.chip.microseconds // 1000)
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
    """A core, its memory, and registers that keep what is written to them, unless a subclass does more."""

    def __init__(self, program, model, memory, registers):
        self.core = Uc(UC_ARCH_ARM, UC_MODE_THUMB | UC_MODE_MCLASS)
        self.core.ctl_set_cpu_model(model)
        self.flash = memory[0][0]
        for start, size in memory + [(0xE0000000, 0x100000)]:  # and the core's own registers
            self.core.mem_map(start, size)
        for start, size in registers:
            self.core.mmio_map(start, size, lambda _, at, __, start: self.read(start + at) & 0xFFFFFFFF, start,
                               lambda _, at, __, value, start: self.write(start + at, value), start)
        self.registers = collections.defaultdict(int)
        self.microseconds, self.transfer = 0, None
        self.instructions, self.blocks, self.starts, self.lowest = 0, {}, [], 1 << 32
        self.core.hook_add(UC_HOOK_BLOCK, self.count)
        self.display = Display(self)
        with open(program, "rb") as file:
            for segment in ELFFile(file).iter_segments("PT_LOAD"):
                if segment["p_filesz"]:
                    self.core.mem_write(segment["p_paddr"], segment.data())  # at its address in flash

    def count(self, _, address, size, __):
        """Counts the instructions of a block that begins, and finds the deepest stack. In flash, blocks do not change."""
        self.lowest = min(self.lowest, self.core.reg_read(UC_ARM_REG_SP) or self.lowest)
        found = self.blocks.get((address, size))
        if found is None:
            code, at, found = self.core.mem_read(address, size), 0, 0
            while at < size:
                at += 4 if code[at + 1] >= 0xE8 else 2
                found += 1
            self.blocks[address, size] = found
        self.instructions += found

    def frames(self, bands):
        """The mean of the instructions for a frame and of the seconds that it takes. The first band that is sent is
        black, while the first one of a frame is drawn."""
        work = [after[0] - before[0] for before, after in zip(self.starts, self.starts[1:])]
        frames = len(work) // bands
        seconds = [max(1.5 * count / self.CLOCK_HZ, 8 * size / self.BUS_HZ)
                   for count, (_, size) in zip(work, self.starts)]
        return sum(work[: frames * bands]) / frames, sum(seconds[: frames * bands]) / frames

    def read(self, address):
        return self.registers[address]

    def write(self, address, value):
        self.registers[address] = value

    def word(self, address):
        return struct.unpack("<I", self.core.mem_read(address, 4))[0]

    def send(self):
        """Ends the transfer under way. Returns whether there was one."""
        transfer, self.transfer = self.transfer, None
        if transfer:
            start, count, size = transfer
            words = self.core.mem_read(start, count * size)
            self.display.receive(b"".join(words[at : at + size][::-1] for at in range(0, len(words), size)))
        return transfer is not None

    def run(self, vectors):
        self.vectors = vectors
        self.core.reg_write(UC_ARM_REG_SP, self.word(vectors))
        at = self.word(vectors + 4)
        while len(self.display.frames) < FRAMES:
            self.start(at)
            at = self.resume(self.core.reg_read(UC_ARM_REG_PC))

    def start(self, at):
        try:
            self.core.emu_start(at | 1, RETURN)
        except UcError as error:
            sys.exit(f"{error} at {self.core.reg_read(UC_ARM_REG_PC):#x}")

    def resume(self, at):
        """Handles a stop of the core; returns the address where it continues."""
        return at


class Stm32f4(Chip):
    """An STM32F405. The program sleeps until an interrupt says that the DMA is ready."""

    FLAGS, CONTROL, COUNT, SOURCE = 0x40026400, 0x40026458, 0x4002645C, 0x40026464  # of DMA 2 and its stream 3
    TIMER = 0x40000000
    CLOCK_HZ, BUS_HZ = 168e6, 42e6

    def __init__(self, program):
        super().__init__(program, UC_CPU_ARM_CORTEX_M4, [(0x08000000, 0x100000), (0x20000000, 0x20000)],
                         [(0x40000000, 0x80000)])
        code = bytes(self.core.mem_read(self.flash, 0x100000))
        for at in range(0, len(code), 2):
            if code[at : at + 2] in (b"\x20\xbf", b"\x30\xbf"):  # WFE, WFI
                self.core.hook_add(UC_HOOK_CODE, self.sleep, begin=self.flash + at, end=self.flash + at)
        self.asleep = self.received = False

    def sleep(self, *_):
        self.asleep = True
        self.core.emu_stop()

    def resume(self, at):
        if self.registers[self.TIMER + 0x10] and not self.core.reg_read(UC_ARM_REG_PRIMASK):
            self.interrupt(28)
        if not self.asleep:
            return at
        self.asleep = False
        if not self.send():
            sys.exit("sleeps for ever")
        self.registers[self.CONTROL] &= ~1
        self.registers[self.COUNT] = 0
        self.registers[self.FLAGS] |= 1 << 27
        self.interrupt(59)
        return at + 2

    def interrupt(self, number):
        context = self.core.context_save()
        self.core.reg_write(UC_ARM_REG_LR, RETURN | 1)
        self.start(self.word(self.vectors + 4 * (16 + number)))
        self.core.context_restore(context)

    def read(self, address):
        value = self.registers[address]
        if address in (0x40023800, 0x40023874):  # every clock that is on is ready
            return value | (value & 0x05010001) << 1
        if address == 0x40023808:  # the selected clock is in use
            return value & ~0xC | (value & 3) << 2
        if address == 0x40007004:  # the voltage is ready
            return value | 1 << 14
        if address == self.TIMER + 0x24:
            before = self.microseconds
            self.microseconds += 5137
            if before >> 15 != self.microseconds >> 15:  # interrupts in the middle and at the end of 16 bits
                self.registers[self.TIMER + 0x10] |= 1 if self.microseconds >> 15 & 1 == 0 else 2
            if self.registers[self.TIMER + 0x10]:
                self.core.emu_stop()
            return self.microseconds & 0xFFFF
        if address == 0x40013008:  # SPI: everything was sent; something was received until it is read
            return 0b10 | self.received
        if address == 0x4001300C:
            self.received = False
        return value

    def write(self, address, value):
        if address == self.TIMER + 0x10:  # writing 0 clears a flag
            value &= self.registers[address]
        self.registers[address] = value
        if address == 0x4001300C:
            self.received = True
            is_wide = self.registers[0x40013000] >> 11 & 1
            self.display.receive(value.to_bytes(4, "big")[2 if is_wide else 3 :])
        elif address == 0x40020018:  # port A: bits of the lower half set pins, bits of the upper half clear them
            self.display.pins(value >> 4 & 1, 0, high=True)
            self.display.pins(value >> 20 & 1, 0, high=False)
        elif address == 0x40020418:
            self.display.pins(0, value & 1, high=True)
            self.display.pins(0, value >> 16 & 1, high=False)
        elif address == self.CONTROL and value & 1:
            size = 1 << (value >> 13 & 3)
            self.transfer = self.registers[self.SOURCE], self.registers[self.COUNT], size
            self.starts.append((self.instructions, self.registers[self.COUNT] * size))
        elif address == self.FLAGS + 8:
            self.registers[self.FLAGS] &= ~value


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    _, program, picture = sys.argv
    chip = Stm32f4(program)
    chip.run(0x08000000)
    now_ms = chip.display.write(picture)
    count, seconds = chip.frames(bands=2 * len(chip.display.pixels) // chip.starts[0][1])
    print(now_ms, round(count), round(seconds * 1e6), chip.word(0x08000000) - chip.lowest)
