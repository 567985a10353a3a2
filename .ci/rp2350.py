#!/usr/bin/env python3
"""Runs a program of the Pico 2 on two emulated cores, with a model of the registers that it needs, and of its display.

rp2350.py PROGRAM PICTURE.ppm [--slow CORE] [--panic]

The program is an ELF file or a UF2. Writes what the display shows after some frames, and prints what stm32f4.py prints,
with the stack of each core that runs. The instructions of a frame are the time in which a core works, not the sum of
both. With --slow, a core takes three times as long, so that the cores finish their bands in another order. With --panic,
frames are on their way when a core reads another number of its own than 0 and 1, once, which rp235x-hal answers with a
panic. Then writes what the display shows, and prints the times in ms for which the LED is on, off, on, ... until a
pause, and the stack of core 0.

Registers have the addresses of the RP2350's data sheet. Core 0 begins where the chip's boot ROM would jump to, if the
program has the block that the boot ROM looks for. Each core has its own time, counted in instructions, and the one that
is behind runs. That the cores wait for each other at the memory is left out. DMA sends a band once the bus had time for
it and a core sleeps, which is the last moment at which a program can wait for it.
"""
import argparse
import collections
import ctypes
import itertools
import mmap
import struct
import sys

from chip import CYCLES, FRAMES, Chip, Module  # first, because it says what is missing

from unicorn import UC_ARCH_ARM, UC_HOOK_CODE, UC_MODE_MCLASS, UC_MODE_THUMB, UC_PROT_ALL, Uc
from unicorn.arm_const import (UC_ARM_REG_LR, UC_ARM_REG_PC, UC_ARM_REG_PRIMASK, UC_ARM_REG_SP, UC_CPU_ARM_CORTEX_M33)

FLASH, FLASH_SIZE = 0x10000000, 0x400000
RAM, RAM_SIZE = 0x20000000, 0x82000
RETURN = FLASH + FLASH_SIZE - 4  # the return address of interrupt handlers: flash that no program uses
FAMILY = 0xE48BFF59  # of UF2s for the secure state of the Arm cores
BLOCK = (0xFFFFDED3, 0x10210142, 0x1FF, 0, 0xAB123579)  # a program for these cores, and no other block
MODEL, MAGIC = 0x10040000, 0x6D786966  # where a model begins in flash, and its first word
WFE, SEV = b"\x20\xbf", b"\x40\xbf"
CS, DC, SCK, DATA, LIGHT, LED = 17, 16, 18, 19, 21, 25
FUNCTION_SPI, FUNCTION_SIO = 1, 5
CRYSTAL_HZ = 12e6

SLICE = 1000  # a core runs at most so many instructions before the other one gets its turn

POWER_OFF, CORE_1 = 0x40018004, 1 << 24
RESETS, RESETS_DONE = 0x40020000, 0x40020008
REFERENCE, SYSTEM, PERIPHERAL = 0x40010030, 0x4001003C, 0x40010048  # clocks; what is selected is 8 behind
PINS, PADS = 0x40028004, 0x40038004
XOSC, XOSC_STATUS = 0x40048000, 0x40048004
PLLS = 0x40050000, 0x40058000
SPI = 0x40080000
SPI_FORMAT, SPI_ENABLE, SPI_DATA, SPI_STATUS, SPI_PRESCALE, SPI_DMA = (SPI + at for at in (0, 4, 8, 12, 16, 36))
TIMER_HIGH, TIMER_LOW = 0x400B0024, 0x400B0028
# Channel 0 of the DMA, and two of its registers at other addresses, of which the second one triggers.
DMA_READ, DMA_WRITE, DMA_COUNT, DMA_CONTROL = (0x50000000 + at for at in (0, 4, 8, 12))
DMA_CONTROL_1, DMA_WRITE_2 = 0x50000010, 0x5000002C
DMA_RAW, DMA_ENABLE, DMA_STATUS, DMA_TRIGGER = 0x50000400, 0x50000404, 0x5000040C, 0x50000450
DMA_INTERRUPT, SPI_REQUEST = 10, 24
SIO = 0xD0000000
SIO_SET, SIO_CLEAR, SIO_LOCKS = SIO + 0x18, SIO + 0x20, SIO + 0x100
FIFO_STATUS, FIFO_WRITE, FIFO_READ = SIO + 0x50, SIO + 0x54, SIO + 0x58
# The cores' own registers. What the cores write there is the same, or only one of them uses it.
TICKS, TICKS_RELOAD, ENABLED_INTERRUPTS, VECTORS = 0xE000E010, 0xE000E014, 0xE000E100, 0xE000ED08
REGISTERS = [(0x40000000, 0x170000), (0x50000000, 0x4000), (SIO, 0x1000), (0xE000E000, 0x1000)]
PAUSE_MS = 700  # the LED blinked


class Core:
    """One of the two cores. Its time is in instructions."""

    def __init__(self, number, memory):
        self.number, self.time, self.pace, self.limit = number, 0, 1, 0
        self.runs, self.asleep, self.event = number == 0, False, False
        self.at, self.interrupted = 0, None
        self.top, self.lowest = 0, 1 << 32
        self.words = collections.deque()  # from the other core
        self.emulator = Uc(UC_ARCH_ARM, UC_MODE_THUMB | UC_MODE_MCLASS)
        self.emulator.ctl_set_cpu_model(UC_CPU_ARM_CORTEX_M33)
        for start, shared in memory:
            address = ctypes.addressof(ctypes.c_char.from_buffer(shared))
            self.emulator.mem_map_ptr(start, len(shared), UC_PROT_ALL, address)

    def begin(self, stack, at):
        self.runs, self.top, self.at = True, stack, at
        self.emulator.reg_write(UC_ARM_REG_SP, stack)

    def wake(self, time):
        self.asleep, self.time = False, max(self.time, time)

    def signal(self, time):
        """An event wakes a core that waits for one, or keeps the core from waiting for the next one."""
        if self.asleep:
            self.wake(time)
        else:
            self.event = True


class Rp2350(Chip):
    """An RP2350 with an ST7789 or an ILI9341. The program sleeps until an interrupt says that the DMA is ready."""

    STACK, PC = UC_ARM_REG_SP, UC_ARM_REG_PC

    def __init__(self, program):
        self.memory = [(FLASH, mmap.mmap(-1, FLASH_SIZE)), (RAM, mmap.mmap(-1, RAM_SIZE))]
        self.cores = [Core(number, self.memory) for number in range(2)]
        self.running, second = self.cores
        self.launch, self.idle, self.requested, self.times, self.ready = [], 0, False, [], 0
        self.seeds, self.ticks, self.blinks = 0, 0, []
        super().__init__(program, self.running.emulator, [], REGISTERS)
        self.connect(second.emulator, [], REGISTERS)
        code = self.core.mem_read(FLASH, 0x40000)
        self.registers[VECTORS] = FLASH
        for core in self.cores:
            for at in range(0, len(code), 2):
                if code[at : at + 2] in (WFE, SEV):
                    core.emulator.hook_add(UC_HOOK_CODE, self.sleep, begin=FLASH + at, end=FLASH + at)
        self.registers[RESETS] = (1 << 29) - 1
        for pin in range(48):
            self.registers[PADS + 4 * pin] = 0x116  # isolated
        self.locks, self.queue, self.received, self.asked = set(), b"", 0, []
        self.bits, self.clock_is_high, self.data_is_high = "", False, False
        if self.word(MODEL) == MAGIC:
            # Word by word as the package flash-model states.
            words = struct.unpack("<24I", self.core.mem_read(MODEL, 96))
            flags = map(bool, words[12:15])
            self.display.module = Module(words[5:7], words[7:9], words[11], *flags, 62.5e6, words[9:11])
        self.is_lit = self.was_high_half = False
        self.check_block()
        self.cores[0].begin(self.word(FLASH), self.word(FLASH + 4))

    def load(self, program):
        self.core.mem_write(FLASH, b"\xff" * FLASH_SIZE)  # erased
        with open(program, "rb") as file:
            data = file.read()
        if not data.startswith(b"UF2\n"):
            return super().load(program)
        self.segments, count = [], len(data) // 512
        for number in range(count):
            block = data[512 * number : 512 * number + 512]
            first, second, flags, address, *rest = struct.unpack_from("<8I", block)
            found = [first, second, flags, *rest, *struct.unpack_from("<I", block, 508)]
            if found != [0x0A324655, 0x9E5D5157, 0x2000, 256, number, count, FAMILY, 0x0AB16F30] or address % 256:
                sys.exit(f"{program}: block {number} of {count} is {' '.join(map(hex, found))}, at {address:#x}")
            self.segments.append((address, block[32 : 32 + 256]))

    def check_block(self):
        """The boot ROM starts a program only if a block in the first 4 KiB of flash says for which cores it is."""
        words = struct.unpack("<1024I", self.core.mem_read(FLASH, 4096))
        if BLOCK not in zip(*(words[at:] for at in range(len(BLOCK)))):
            sys.exit("the boot ROM finds no program for its Arm cores")

    @staticmethod
    def length(code):
        return 4 if code[1] >= 0xE8 else 2

    def run(self):
        """Runs the core that is behind, of those that do not sleep, until the display has shown all frames, or the LED
        has blinked."""
        while len(self.display.frames) < FRAMES and not (self.blinks and self.now_ms() > self.blinks[-1] + PAUSE_MS):
            core = min((core for core in self.cores if core.runs and not core.asleep), key=lambda core: core.time,
                       default=None)
            end = self.end()
            if end is not None and (core is None or core.time >= end):
                self.sent(end)
            elif core is None:
                sys.exit("sleeps for ever")
            else:
                self.step(core, core.time + SLICE if end is None else min(core.time + SLICE, end))

    def end(self):
        """The time at which the transfer under way ends, if that is known."""
        sleeping = [core.time for core in self.cores if core.asleep]
        return max(self.ready, min(sleeping)) if self.transfer and sleeping else None

    def sent(self, end):
        """A transfer ends. The last of its bytes are still in the queue of the bus."""
        running, first = [core for core in self.cores if core.runs], self.cores[0]
        if all(core.asleep for core in running):
            self.idle += end - max(core.time for core in running)
        self.send()
        self.registers[DMA_RAW] |= 1
        self.requested = bool(self.registers[DMA_ENABLE] & 1)
        if self.requested and not self.registers[ENABLED_INTERRUPTS] >> DMA_INTERRUPT & 1:
            sys.exit(f"interrupt {DMA_INTERRUPT} is not enabled")
        if first.asleep and self.is_due(first):
            first.wake(end)

    def is_due(self, core):
        """Whether a core is to handle the DMA's interrupt now."""
        return (self.requested and core.number == 0 and not core.interrupted
                and not core.emulator.reg_read(UC_ARM_REG_PRIMASK))

    def step(self, core, limit):
        """Runs a core until a time, or until it sleeps, or begins or ends to handle the interrupt."""
        self.running, self.core, core.limit = core, core.emulator, limit
        if self.is_due(core):
            core.interrupted = core.emulator.context_save(), core.at
            # The core saves eight registers.
            core.emulator.reg_write(UC_ARM_REG_SP, core.emulator.reg_read(UC_ARM_REG_SP) - 32)
            core.emulator.reg_write(UC_ARM_REG_LR, RETURN | 1)
            core.at = self.word(FLASH + 4 * (16 + DMA_INTERRUPT))
        at, core.at = core.at | 1, None
        self.start(at, RETURN)
        if core.at is None:
            core.at = core.emulator.reg_read(UC_ARM_REG_PC)
        if core.at == RETURN:
            (context, core.at), core.interrupted = core.interrupted, None
            core.emulator.context_restore(context)
            if self.registers[DMA_RAW]:
                sys.exit(f"the handler of interrupt {DMA_INTERRUPT} does not withdraw its request")

    def count(self, emulator, address, size, _):
        core = self.running
        if core.time >= core.limit or self.is_due(core):
            core.at = address  # before this block; older versions of Unicorn still have another PC then
            emulator.emu_stop()
        else:
            core.lowest = min(core.lowest, emulator.reg_read(UC_ARM_REG_SP))
            core.time += core.pace * self.block(address, size)

    @property
    def instructions(self):
        return self.running.time - self.idle

    def now_ms(self):
        """The time by the cores' own timers."""
        return 1000 * self.ticks / self.CLOCK_HZ

    def stacks(self):
        return [core.top - core.lowest for core in self.cores if core.runs]

    def sleep(self, emulator, address, *_):
        """WFE waits for an event, unless there was one since the last WFE. SEV is one, for both cores."""
        core = self.running
        if emulator.mem_read(address, 2) == SEV:
            for other in self.cores:
                other.signal(core.time)
        else:
            core.asleep, core.event, core.at = not core.event, False, address + 2
            emulator.emu_stop()

    def write_fifo(self, value):
        """A word for the other core. The boot ROM of core 1 returns each one. After 0, 0, 1 come the core's vectors, its
        stack and its program."""
        core, other = self.running, self.cores[1 - self.running.number]
        if other.runs:
            other.words.append(value)
            return
        self.launch = (self.launch + [value])[-6:]
        core.words.append(value)
        core.signal(core.time)
        if len(self.launch) == 6 and self.launch[:3] == [0, 0, 1]:
            other.begin(*self.launch[4:])
            other.time = core.time

    def moment(self, number):
        """The program asks for the time of a frame before it draws the frame. The first frame only clears."""
        return self.asked[:number][-1] if number else 0

    def begin(self, transfer, size):
        super().begin(transfer, size)
        self.times.append(self.running.time)
        self.ready = self.running.time + 8 * size / self.BUS_HZ * self.BUS_GAPS * self.CLOCK_HZ / CYCLES

    def send(self):
        transfer, self.transfer = self.transfer, None
        self.queue += transfer()

    def frames(self, bands):
        """The mean of the instructions for a frame and of the seconds from one to the next."""
        frames = (len(self.starts) - 1) // bands
        times = self.times[-len(self.starts) :]
        counts = [count for count, _ in self.starts]
        count, time = ((of[frames * bands] - of[0]) / frames for of in (counts, times))
        return count, CYCLES * time / self.CLOCK_HZ

    def band(self, source, count, size):
        """The bytes of a band. SPI sends the more significant byte of a word first."""
        words = self.core.mem_read(source, count * size)
        return b"".join(words[at : at + size][::-1] for at in range(0, len(words), size))

    def word_bytes(self):
        """The bytes of a word on the bus, once bus and pins are ready."""
        functions = [self.registers[PINS + 8 * pin] & 31 for pin in (CS, DC, SCK, DATA)]
        isolated = [self.registers[PADS + 4 * pin] >> 8 & 1 for pin in (CS, DC, SCK, DATA)]
        if functions != 2 * [FUNCTION_SIO] + 2 * [FUNCTION_SPI] or any(isolated) or self.registers[RESETS] >> 18 & 1:
            sys.exit(f"pins have functions {functions}, isolated {isolated}; resets {self.registers[RESETS]:#x}")
        if not self.registers[SPI_ENABLE] & 2:
            sys.exit("the bus is off")
        return ((self.registers[SPI_FORMAT] & 15) + 1) // 8

    def trigger(self):
        if self.transfer:
            sys.exit("a transfer began while another one was under way")
        control, source, count = (self.registers[at] for at in (DMA_CONTROL, DMA_READ, DMA_COUNT))
        size = 1 << (control >> 2 & 3)
        # Enabled, its source advances and its target does not, at the request of the bus.
        if (control & 0x7E00F1, self.registers[DMA_WRITE]) != (SPI_REQUEST << 17 | 0x11, SPI_DATA):
            sys.exit(f"DMA has control {control:#x}, target {self.registers[DMA_WRITE]:#x}")
        if size != self.word_bytes() or not self.registers[SPI_DMA] & 2:
            sys.exit(f"DMA writes {size} bytes at a time; SPI requests {self.registers[SPI_DMA]}")
        reference, feedback, dividers = (self.registers[PLLS[0] + at] for at in (0, 8, 12))
        self.CLOCK_HZ = CRYSTAL_HZ * feedback / (reference & 63) / (dividers >> 16 & 7) / (dividers >> 12 & 7)
        self.BUS_HZ = self.CLOCK_HZ / self.registers[SPI_PRESCALE] / ((self.registers[SPI_FORMAT] >> 8) + 1)
        # In modes 0 and 2, it rests for two of its clocks after each word.
        self.BUS_GAPS = 1 if self.registers[SPI_FORMAT] & 0x80 else (8 * size + 2) / (8 * size)
        self.begin(lambda: self.band(source, count, size), count * size)

    def read(self, address):
        value = self.registers[address]
        if address == RESETS_DONE:
            return ~self.registers[RESETS]
        if address in (REFERENCE + 8, SYSTEM + 8):
            return 1 << (self.registers[address - 8] & 3)
        if address == PERIPHERAL + 8:
            return 1
        if address == XOSC_STATUS:
            return (self.registers[XOSC] >> 12 == 0xFAB) << 31
        if address in PLLS:  # locked once it has power
            return value | (not self.registers[address + 4] & 0x21) << 31
        if address == TIMER_HIGH:
            self.was_high_half = True
            return self.microseconds >> 32
        if address == TIMER_LOW:
            # A frame asks for both halves of the time; delays ask for the lower one, again and again.
            self.microseconds += 750_000 if self.was_high_half else 5137
            if self.was_high_half:
                self.asked.append(self.microseconds // 1000)
            self.was_high_half = False
            return self.microseconds
        if address == SPI_STATUS:
            is_busy, queue, self.queue = self.queue != b"", self.queue, b""
            if is_busy:  # everything is sent, and for each word one is received, of which eight are kept
                self.display.receive(queue)
                self.received = min(self.received + len(queue) // self.word_bytes(), 8)
            return is_busy << 4 | (self.received > 0) << 2 | 0b11
        if address == SPI_DATA:
            self.received -= 1
        if address == DMA_CONTROL:
            return value | (self.transfer is not None) << 26
        if address == SIO:
            is_seed = self.seeds > 0 and len(self.display.frames) > 2
            self.seeds -= is_seed
            return 2 if is_seed else self.running.number
        if address == TICKS and value & 1:  # the program waits until the counter is 0, or is about to write
            self.ticks += self.registers[TICKS_RELOAD] + 1
            return value | 1 << 16
        if address == FIFO_STATUS:
            return 0b10 | bool(self.running.words)
        if address == FIFO_READ:
            return self.running.words.popleft()
        if address == DMA_STATUS:
            return self.registers[DMA_RAW] & self.registers[DMA_ENABLE]
        if SIO_LOCKS <= address < SIO_LOCKS + 128:  # 0 if it is taken already
            was_free = address not in self.locks
            self.locks.add(address)
            return was_free
        return value

    def write(self, address, value):
        if address < SIO:  # three more addresses of a register change some of its bits
            change, address = address >> 12 & 3, address & ~0x3000
            value = [value, self.registers[address] ^ value, self.registers[address] | value,
                     self.registers[address] & ~value][change]
        if address == DMA_STATUS:
            self.registers[DMA_RAW] &= ~value
            self.requested = bool(self.registers[DMA_RAW] & self.registers[DMA_ENABLE] & 1)
        elif address == TICKS:
            self.ticks -= (self.registers[TICKS] & 1) * (self.registers[TICKS_RELOAD] + 1)
            self.registers[TICKS] = value & 7
        elif address == FIFO_WRITE:
            self.write_fifo(value)
        elif address == POWER_OFF:
            if self.registers[POWER_OFF] & ~value & CORE_1:
                self.cores[0].words.append(0)  # the boot ROM of core 1 says that it is there
            self.registers[POWER_OFF] = value
        elif address == DMA_CONTROL_1:
            self.registers[DMA_CONTROL] = value
        elif address == DMA_WRITE_2:
            self.registers[DMA_WRITE] = value
            self.trigger()
        elif address == DMA_TRIGGER:
            self.trigger()
        elif address == SPI_DATA:
            self.queue += value.to_bytes(4, "big")[-self.word_bytes() :]
        elif address in (SIO_SET, SIO_CLEAR):
            self.pins(value, high=address == SIO_SET)
        elif SIO_LOCKS <= address < SIO_LOCKS + 128:
            self.locks.discard(address)
        else:
            self.registers[address] = value

    def pins(self, value, high):
        if value >> DATA & 1:
            self.data_is_high = high
        if value >> SCK & 1:
            # While the display is set up, the program sets the clock itself: each rising edge is a bit.
            if high and not self.clock_is_high and self.registers[PINS + 8 * SCK] & 31 == FUNCTION_SIO:
                self.bits += str(int(self.data_is_high))
            self.clock_is_high = high
            if len(self.bits) == 8:
                self.display.receive(bytes([int(self.bits, 2)]))
                self.bits = ""
        cs, dc = value >> CS & 1, value >> DC & 1
        if cs and high:  # the display forgets the bits of an incomplete byte
            self.bits = ""
        if (cs or dc) and self.queue:
            sys.exit(f"a pin changed before the last {len(self.queue)} bytes were on the bus")
        self.display.pins(cs, dc, high)
        # After a panic, from the first time on at which the LED is on, every change counts.
        if value >> LED & 1 and self.ticks and high != len(self.blinks) % 2:
            self.blinks.append(self.now_ms())
        if value >> LIGHT & 1:
            if high and not self.display.frames:
                sys.exit("the backlight is on before the display is cleared")
            self.is_lit = high


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("picture")
    parser.add_argument("--slow", type=int, choices=[0, 1])
    parser.add_argument("--panic", action="store_true")
    options = parser.parse_args()
    chip = Rp2350(options.program)
    if options.slow is not None:
        chip.cores[options.slow].pace = 3
    chip.seeds = int(options.panic)
    chip.run()
    if not chip.is_lit:
        sys.exit("the backlight is off")
    if options.panic:
        chip.display.execute()
        chip.display.write(options.picture)
        times = (round(after - before) for before, after in zip(chip.blinks, chip.blinks[1:]))
        print(*itertools.takewhile(lambda time: time <= PAUSE_MS, times), chip.stacks()[0])
    else:
        chip.report(options.picture)
