#!/usr/bin/env python3
"""Runs the STM32F4's program on an emulated core, with a model of the registers that it needs, and of its display.

stm32f4.py PROGRAM PICTURE.ppm

Writes what the display shows after some frames. Prints the time in ms at which the last frame was drawn; the mean
of the instructions for a frame; a frame's time in microseconds, at 1.5 cycles for an instruction (a band is drawn while
another one is sent, and the longer of the two counts); and the bytes of stack. Registers have the addresses of the
STM32F405's reference manual, RM0090.
"""
import sys

from chip import ILI9341, Chip  # first, because it says what is missing

from unicorn import UC_ARCH_ARM, UC_HOOK_CODE, UC_MODE_MCLASS, UC_MODE_THUMB, Uc
from unicorn.arm_const import (UC_ARM_REG_LR, UC_ARM_REG_PC, UC_ARM_REG_PRIMASK, UC_ARM_REG_SP, UC_CPU_ARM_CORTEX_M4)

FLASH = 0x08000000
RETURN = 0x08080000  # the return address of interrupt handlers: flash that no program uses


class Stm32f4(Chip):
    """An STM32F405. The program sleeps until an interrupt says that the DMA is ready."""

    FLAGS, CONTROL, COUNT, SOURCE = 0x40026400, 0x40026458, 0x4002645C, 0x40026464  # of DMA 2 and its stream 3
    TIMER = 0x40000000
    STACK, PC = UC_ARM_REG_SP, UC_ARM_REG_PC
    CLOCK_HZ = 168e6
    BUS_HZ = property(lambda self: 84e6 / (2 << (self.registers[0x40013000] >> 3 & 7)))

    def __init__(self, program):
        core = Uc(UC_ARCH_ARM, UC_MODE_THUMB | UC_MODE_MCLASS)
        core.ctl_set_cpu_model(UC_CPU_ARM_CORTEX_M4)
        # Flash, RAM, and the core's own registers.
        memory = [(FLASH, 0x100000), (0x20000000, 0x20000), (0xE0000000, 0x100000)]
        super().__init__(program, core, memory, [(0x40000000, 0x80000)])
        code = bytes(core.mem_read(FLASH, 0x100000))
        for at in range(0, len(code), 2):
            if code[at : at + 2] in (b"\x20\xbf", b"\x30\xbf"):  # WFE, WFI
                core.hook_add(UC_HOOK_CODE, self.sleep, begin=FLASH + at, end=FLASH + at)
        self.asleep = self.received = False
        self.display.module = ILI9341

    @staticmethod
    def length(code):
        return 4 if code[1] >= 0xE8 else 2

    def sleep(self, *_):
        self.asleep = True
        self.core.emu_stop()

    def resume(self, at):
        if self.registers[self.TIMER + 0x10] and not self.core.reg_read(UC_ARM_REG_PRIMASK):
            self.interrupt(28)
        if not self.asleep:
            return at | 1
        self.asleep = False
        if not self.send():
            sys.exit("sleeps for ever")
        self.registers[self.CONTROL] &= ~1
        self.registers[self.COUNT] = 0
        self.registers[self.FLAGS] |= 1 << 27
        self.interrupt(59)
        return at + 2 | 1

    def interrupt(self, number):
        context = self.core.context_save()
        self.core.reg_write(UC_ARM_REG_LR, RETURN | 1)
        self.start(self.word(FLASH + 4 * (16 + number)), RETURN)
        self.core.context_restore(context)

    def band(self, source, count, size):
        """Returns the bytes of a band. SPI sends the more significant byte of a word first."""
        words = self.core.mem_read(source, count * size)
        return b"".join(words[at : at + size][::-1] for at in range(0, len(words), size))

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
            if before >> 15 != self.microseconds >> 15:  # the timer interrupts in the middle and at the end of 16 bits
                self.registers[self.TIMER + 0x10] |= 1 if self.microseconds >> 15 & 1 == 0 else 2
            if self.registers[self.TIMER + 0x10]:
                self.core.emu_stop()
            return self.microseconds & 0xFFFF
        if address == 0x40013008:  # SPI: sending has ended; a received word is there until it is read
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
            source, count, size = self.registers[self.SOURCE], self.registers[self.COUNT], 1 << (value >> 13 & 3)
            self.begin(lambda: self.band(source, count, size), count * size)
        elif address == self.FLAGS + 8:
            self.registers[self.FLAGS] &= ~value


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    chip = Stm32f4(sys.argv[1])
    chip.core.reg_write(chip.STACK, chip.word(FLASH))
    chip.run(chip.word(FLASH + 4) | 1)
    chip.report(sys.argv[2])
