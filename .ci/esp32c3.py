#!/usr/bin/env python3
"""Runs the ESP32-C3's program on an emulated core, with a model of the registers that it needs, and of its display.

esp32c3.py PROGRAM PICTURE.ppm

Writes what the display shows after some frames, and prints the same figures as stm32f4.py. Registers have the
addresses of Espressif's technical reference manual. The core begins where the second bootloader would jump to. The core
knows only RISC-V's standard registers: Espressif's own registers read as 0, and memory has no protection.
"""
import struct
import sys

from chip import Chip  # first, because it says what is missing

from unicorn import UC_ARCH_RISCV, UC_HOOK_CODE, UC_HOOK_INTR, UC_MODE_RISCV32, Uc
from unicorn.riscv_const import (UC_RISCV_REG_A0, UC_RISCV_REG_A1, UC_RISCV_REG_A2, UC_RISCV_REG_A3, UC_RISCV_REG_PC,
                                 UC_RISCV_REG_SP, UC_RISCV_REG_X0)

ROM = 0x40000000
# Functions in ROM that the program may call. Here they do nothing, and return their first argument.
ROM_IGNORED = ["rtc_get_reset_reason", "ets_delay_us", "ets_update_cpu_frequency", "rom_i2c_readReg",
               "rom_i2c_writeReg", "esp_rom_regi2c_read", "esp_rom_regi2c_write"]
GPIO_SET, GPIO_CLEAR = 0x60004008, 0x6000400C
DC, CS = 1 << 4, 1 << 10
SPI = 0x60024000  # SPI 2
SPI_CLOCK, SPI_BITS, SPI_DMA, SPI_CLEAR, SPI_DONE, SPI_DATA = (SPI + at for at in (12, 0x1C, 0x30, 0x38, 0x3C, 0x98))
DMA_LINK = 0x6003F0E0  # of channel 0
TIMER, TIMER_HIGH, TIMER_LOW = 0x60023004, 0x60023040, 0x60023044  # the first unit of the system's timer, of 16 MHz
CALIBRATION, CALIBRATED = 0x6001F068, 0x6001F06C


class Esp32c3(Chip):
    """An ESP32-C3. The program polls, and a transfer ends when the program looks."""

    STACK, PC = UC_RISCV_REG_SP, UC_RISCV_REG_PC
    CLOCK_HZ = 160e6

    @property
    def BUS_HZ(self):
        clock = self.registers[SPI_CLOCK]
        return 80e6 if clock >> 31 else 80e6 / ((clock >> 18 & 15) + 1) / ((clock >> 12 & 63) + 1)

    def __init__(self, program):
        core = Uc(UC_ARCH_RISCV, UC_MODE_RISCV32)
        # Flash for data and for code, RAM for data and for code, ROM, and RAM that stays powered.
        memory = [(0x3C000000, 0x800000), (0x42000000, 0x800000), (0x3FC80000, 0x60000), (0x4037C000, 0x64000),
                  (ROM, 0x60000), (0x50000000, 0x2000)]
        super().__init__(program, core, memory, [(0x60000000, 0xD1000)])
        core.mem_write(ROM, b"\x82\x80" * 0x30000)  # every function returns at once
        core.hook_add(UC_HOOK_CODE, self.rom, begin=ROM, end=ROM + 0x5FFFF)
        self.functions = {address: name for name, address in self.symbols.items() if ROM <= address < ROM + 0x60000}
        core.hook_add(UC_HOOK_INTR, self.trap)
        for start, code in self.segments:
            for at in range(0, len(code) - 3, 2):
                instruction = struct.unpack_from("<I", code, at)[0]
                # The core would obey writes to the registers of memory protection, so they are replaced.
                if instruction & 0x7F == 0x73 and instruction >> 12 & 7 and 0x3A0 <= instruction >> 20 < 0x3F0:
                    core.mem_write(start + at, struct.pack("<I", 0x13))  # NOP
        self.cause = self.unknown = None

    @staticmethod
    def length(code):
        return 4 if code[0] & 3 == 3 else 2

    def rom(self, core, address, *_):
        registers = [UC_RISCV_REG_A0, UC_RISCV_REG_A1, UC_RISCV_REG_A2, UC_RISCV_REG_A3]
        a0, a1, a2, a3 = (core.reg_read(register) for register in registers)
        name = self.functions.get(address)
        if name == "memset":
            core.mem_write(a0, bytes([a1 & 0xFF]) * a2)
        elif name == "memcpy":
            core.mem_write(a0, bytes(core.mem_read(a1, a2)))
        elif name == "__udivdi3":
            quotient = (a1 << 32 | a0) // (a3 << 32 | a2)
            core.reg_write(UC_RISCV_REG_A0, quotient & 0xFFFFFFFF)
            core.reg_write(UC_RISCV_REG_A1, quotient >> 32)
        elif name not in ROM_IGNORED:
            self.unknown = f"calls {name or hex(address)} in ROM"
            core.emu_stop()

    def trap(self, core, cause, _):
        self.cause = cause
        core.emu_stop()

    def resume(self, at):
        if self.unknown:
            sys.exit(self.unknown)
        cause, self.cause = self.cause, None
        instruction = self.word(at)
        if cause == 2 and instruction & 0x7F == 0x73:  # a register that the core does not know
            if target := instruction >> 7 & 31:
                self.core.reg_write(UC_RISCV_REG_X0 + target, 0)
            return at + 4
        if cause is not None:
            sys.exit(f"exception {cause} at {at:#x}")
        return at

    def begin_transfer(self):
        count = (self.registers[SPI_BITS] + 1) // 8
        if not self.registers[SPI_DMA] >> 28 & 1:
            data = b"".join(struct.pack("<I", self.registers[SPI_DATA + 4 * at] & 0xFFFFFFFF) for at in range(16))
            self.transfer = lambda: data[:count]
            return
        link = 0x3FC00000 | self.registers[DMA_LINK] & 0xFFFFF
        self.begin(lambda: self.gather(link, count), count)

    def gather(self, link, count):
        """Returns the bytes to which a list of descriptors points."""
        data = b""
        while link and len(data) < count:
            flags, source, following = struct.unpack("<III", self.core.mem_read(link, 12))
            data += self.core.mem_read(source, flags >> 12 & 0xFFF)
            link = 0 if flags >> 30 & 1 else following
        if len(data) < count:
            sys.exit(f"DMA has {len(data)} bytes where SPI sends {count}")
        return data[:count]

    def send(self):
        if super().send():
            self.registers[SPI_DONE] |= 1 << 12

    def read(self, address):
        if address in (SPI, SPI_DONE):
            self.send()
        value = self.registers[address]
        if address == CALIBRATION:
            return value | 1 << 15
        if address == CALIBRATED:
            return 1024 * 294 << 7  # cycles of 40 MHz in 1,024 of the slow clock's
        if address == TIMER:
            return value | 1 << 29
        if address in (TIMER_HIGH, TIMER_LOW):
            ticks = self.microseconds * 16
            return ticks >> 32 if address == TIMER_HIGH else ticks & 0xFFFFFFFF
        if address == SPI:
            return value & ~(3 << 23)
        return value

    def write(self, address, value):
        if address == SPI_CLEAR:
            self.registers[SPI_DONE] &= ~value
            return
        self.registers[address] = value
        if address == TIMER:
            self.microseconds += 5137
        elif address in (GPIO_SET, GPIO_CLEAR):
            self.display.pins(value & CS, value & DC, high=address == GPIO_SET)
        elif address == SPI and value >> 24 & 1:
            if self.transfer:
                sys.exit("a transfer began while another one was under way")
            self.begin_transfer()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    chip = Esp32c3(sys.argv[1])
    chip.core.reg_write(chip.STACK, chip.stack)
    chip.run(chip.entry)
    chip.report(sys.argv[2])
