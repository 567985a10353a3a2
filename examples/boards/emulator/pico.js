// An emulated Raspberry Pi Pico with a panel on its pins: .ci/rp2040.mjs checks programs with it, and worker.js runs
// them in a page.
//
// rp2040js emulates a core, clocks, timer, SPI with its FIFO, DMA with its requests, and pins. The second core is added
// here, and so is the panel.
import { RP2040 } from "rp2040js";

const FLASH = 0x10000000, ROM_END = 0x1000;
/** Where a model begins in flash, its first word, and the version of its format. */
const MODEL = 0x40000, MAGIC = 0x6d786966, VERSION = 4;
const SPI_FUNCTION = 1, SIO_FUNCTION = 5, NO_FUNCTION = 31;
/** The bit that resets the functions of the pins. */
const IO_RESET = 5;
const NOP = 0x00, SWRESET = 0x01, SLPOUT = 0x11, INVOFF = 0x20, INVON = 0x21, DISPON = 0x29;
const CASET = 0x2a, RASET = 0x2b, RAMWR = 0x2c, MADCTL = 0x36, COLMOD = 0x3a;
/** More mistakes than these end a run. */
const MISTAKES = 20;

/** Halves of the microseconds, at the addresses of the timer's registers. */
const TIMER = { 0x08: 1, 0x0c: 0, 0x24: 1, 0x28: 0 };
const DIVIDER = ["divDividend", "divDivisor", "divQuotient", "divRemainder", "divCSR"];

/**
 * A module with a panel: how its glass and its wires differ from others of the same controller, and which pins of the
 * Pico it is wired to. Sizes are columns and rows before a rotation.
 */
export const ST7789 = {
  /** The most that is usual for the controller's bus. */
  limitHz: 62.5e6,
  size: [240, 240],
  memory: [240, 320],
  /** Where the glass begins in the controller's memory. */
  offset: [0, 0],
  /** Clockwise turns by 90 degrees that the program is to make. */
  rotation: 0,
  /** The glass shows the memory's last column first. */
  isMirrored: false,
  /** The glass has blue where the controller has red. */
  isBlueFirst: false,
  /** The glass shows a negative unless the controller inverts. */
  isInverted: true,
  /** The backlight is on while its pin is low. */
  isLightLow: false,
  /** Where nothing is wired, a pin is undefined. A module without CS has it tied low. */
  pins: { clock: 18, data: 19, cs: 17, dc: 16, reset: 20, light: 21 },
};

/** The highest usual frequencies of the controllers' buses, by the numbers that the model's header has for them. */
const LIMITS = [62.5e6, 40e6, 62.5e6, 15.2e6, 27e6];

/** The module of a model's header: word by word as the package flash-model states. */
function recorded(word) {
  const pair = (at) => [word(at), word(at + 1)];
  const pin = (at) => (word(at) === 0xffffffff ? undefined : word(at));
  const [clock, data, dc, cs, reset, light] = [17, 18, 19, 20, 21, 22].map(pin);
  return {
    limitHz: LIMITS[word(4)], size: pair(5), memory: pair(7), offset: pair(9), rotation: word(11),
    isMirrored: word(12) === 1, isBlueFirst: word(13) === 1, isInverted: word(14) === 1,
    pins: { clock, data, dc, cs, reset, light }, isLightLow: word(23) === 1,
  };
}

/**
 * The panel follows its data sheet, bit by bit: at a rising edge of the clock, a bit arrives if CS is low; with the
 * eighth, DC says whether the byte is a command or data. Only CS and the reset clear the count of bits. CASET and RASET
 * set a window, RAMWR writes to it, and MADCTL, COLMOD and the inversion say what becomes of the pixels.
 *
 * What is sent while CS is high is lost, and so is what is on the bus when CS or DC changes: both are errors. So is a
 * clock that is faster than the controller's limit.
 */
class Panel {
  isSelected;
  isLit = false;
  isAwake = false;
  isOn = false;
  /** The bytes that were received. */
  received = 0;
  /** How many frames were begun, and how many of them are complete. */
  begun = 0;
  complete = 0;
  errors = [];
  /** The bus's frequency when it last sent a word. */
  busHz = 0;
  /** Is called as a frame begins. The one before has its pixels by then: red, green and blue from 0 to 255. */
  onFrame = () => {};
  #isData = true;
  /** Whether the clock is high, and the bits of the byte that arrives: unknown until CS or the reset clears them. */
  #isHigh = false;
  #bits = [3, 0];
  #command = NOP;
  #data = [];
  #windows = {};
  #mode = 0;
  #isInverted = false;
  #bytesOfPixel = 3;
  #frame;

  constructor({ gpio, clock, spi, peripherals: { [0x4000c]: resets } }, module) {
    const { pins } = module;
    // Of each 16 pins, the first eight belong to SPI 0.
    const block = pins.clock >> 3 & 1;
    this.now = () => clock.nanos;
    this.module = module;
    [this.gpio, this.bus] = [gpio, spi[block]];
    this.memory = new Int32Array(module.memory[0] * module.memory[1]).fill(-1);
    const changes = (name, set) => (level) => {
      if (this.bus.busy && this.#isWired()) this.errors.push(`${name} changed while a byte was on the bus`);
      set(level === 1);
    };
    const listen = (pin, listener) => pin !== undefined && gpio[pin].addListener(listener);
    this.isSelected = pins.cs === undefined;
    // Modules without a pin for the backlight are always lit.
    this.isLit = pins.light === undefined;
    listen(pins.cs, changes("CS", (isHigh) => {
      this.isSelected = !isHigh;
      this.#bits = [0, 0];
    }));
    listen(pins.dc, changes("DC", (isHigh) => { this.#isData = isHigh; }));
    listen(pins.reset, (level) => this.#reset(level === 1));
    listen(pins.light, (level) => this.#light(level === (module.isLightLow ? 0 : 1)));
    // The clock's level changes with its pin, and as the bus is reset and set up.
    listen(pins.clock, () => this.#clock());
    const [writeBus, writeResets] = [this.bus.writeUint32.bind(this.bus), resets.writeUint32.bind(resets)];
    this.bus.writeUint32 = (at, value) => { writeBus(at, value); if (at === 0) this.#clock(); };
    resets.writeUint32 = (at, value) => {
      writeResets(at, value);
      if (resets.reset >> IO_RESET & 1) {
        for (const pin of gpio) pin.ctrl = NO_FUNCTION;
        for (const pin of gpio) pin.checkForUpdates();
      }
      if (resets.reset >> 16 + block & 1) [this.bus.control0, this.bus.control1] = [0, 0];
      this.#clock();
    };
  }

  /** Columns and rows of the picture that is shown. */
  size() {
    const [width, height] = this.module.size;
    return this.module.rotation & 1 ? [height, width] : [width, height];
  }

  /** The level of the clock between words: the program's pin, or where the bus rests. */
  #clock() {
    const { outputValue, outputEnable, functionSelect } = this.gpio[this.module.pins.clock];
    const bySpi = functionSelect === SPI_FUNCTION && this.bus.control0 & 0x40;
    const isHigh = Boolean(bySpi) || (functionSelect === SIO_FUNCTION && outputEnable && outputValue);
    if (isHigh && !this.#isHigh) this.#edge(Number(this.gpio[this.module.pins.data].outputValue));
    this.#isHigh = isHigh;
  }

  /** An edge that nobody wanted. */
  disturb() {
    this.#edge(0);
  }

  #edge(bit) {
    if (!this.isSelected || this.isReset) return;
    const [count, bits] = this.#bits;
    this.#bits = count < 7 ? [count + 1, bits << 1 | bit] : [0, 0];
    if (count >= 7) this.#receive((bits << 1 | bit) & 0xff);
  }

  /** Whether the bus is on its pins. */
  #isWired() {
    const { gpio, module: { pins } } = this;
    return [pins.clock, pins.data].every((pin) => gpio[pin].functionSelect === SPI_FUNCTION);
  }

  /** The bus has sent a word of so many bits, which arrives if the bus is on its pins. */
  word(value, count) {
    const { bus, module: { limitHz } } = this;
    if (!this.#isWired()) return;
    this.busHz = bus.clockFrequency;
    if (this.busHz > limitHz) this.errors.push(`the bus has ${this.busHz} Hz, but the controller only ${limitHz}`);
    if ((bus.control0 >> 6 ^ bus.control0 >> 7) & 1) this.errors.push("the bus is in mode 1 or 2");
    if (!this.isSelected) this.errors.push(`${value.toString(16)} was sent while no panel listened`);
    // Whole bytes are the usual case.
    for (let left = count - 8; left >= 0; left -= 8) {
      const byte = value >> left & 0xff;
      if (!this.isSelected || this.isReset) continue;
      if (this.#bits[0] === 0) this.#receive(byte);
      else for (let bit = 7; bit >= 0; bit--) this.#edge(byte >> bit & 1);
    }
    if (this.errors.length > MISTAKES) this.check();
  }

  #reset(isHigh) {
    if (isHigh && this.module.pins.cs === undefined && !this.#isHigh) {
      // Such modules are known to work in mode 3 only.
      this.errors.push("there is no CS, and the clock is low as the reset ends");
    }
    this.isReset = !isHigh;
    this.#bits = [0, 0];
    this.#restart();
  }

  #restart() {
    [this.isAwake, this.isOn, this.#isInverted, this.#mode, this.#bytesOfPixel] = [false, false, false, 0, 3];
    [this.#command, this.#data] = [NOP, []];
  }

  #light(isLit) {
    if (isLit) {
      this.#execute();
      if (this.#isNoisy()) this.errors.push("the backlight is on before the panel is cleared");
    }
    this.isLit = isLit;
  }

  /** Whether the glass shows memory that was never written. */
  #isNoisy() {
    const { memory, module: { size: [width, height], memory: [stride], offset: [left, top] } } = this;
    const row = (y) => memory.subarray((top + y) * stride + left).subarray(0, width);
    return [...Array(height).keys()].some((y) => row(y).includes(-1));
  }

  #receive(byte) {
    this.received++;
    if (this.#isData) this.#data.push(byte);
    else {
      if (byte === SWRESET) this.#restart();
      else this.#execute();
      this.#command = byte;
      if (byte === RAMWR) this.#begin();
    }
  }

  #begin() {
    this.begun++;
    this.#frame = { at: this.now(), received: this.received };
    this.onFrame(this.#frame);
  }

  /** The data of a command are complete when the next command comes. */
  #execute() {
    const [command, data] = [this.#command, this.#data];
    const [a, b, c, d] = data;
    [this.#command, this.#data] = [NOP, []];
    switch (command) {
      case SLPOUT: this.isAwake = true; break;
      case DISPON: this.isOn = true; break;
      case INVOFF: this.#isInverted = false; break;
      case INVON: this.#isInverted = true; break;
      case MADCTL: this.#mode = a; break;
      case COLMOD: this.#bytesOfPixel = (a & 7) === 5 ? 2 : 3; break;
      case CASET: case RASET: this.#windows[command] = [a << 8 | b, c << 8 | d]; break;
      case RAMWR: this.#write(data); break;
    }
  }

  #write(data) {
    if (!this.#windows[CASET] || !this.#windows[RASET]) throw new Error("no window");
    const [left, right] = this.#windows[CASET];
    const [top, bottom] = this.#windows[RASET];
    const [width, height, step] = [right - left + 1, bottom - top + 1, this.#bytesOfPixel];
    if (data.length !== step * width * height) {
      this.errors.push(`${data.length} bytes in a window of ${width}x${height} pixels`);
      return;
    }
    for (let row = top, at = 0; row <= bottom; row++) {
      for (let column = left; column <= right; column++, at += step) {
        const cell = this.#cell(column, row);
        if (cell === undefined) { this.errors.push("the window is larger than the memory"); return; }
        const upper = data[at] << 8 | data[at + 1];
        this.memory[cell] = step === 2 ? upper : upper << 8 | data[at + 2];
      }
    }
    if (!this.isAwake || !this.isOn) this.errors.push("a frame was sent to a panel that sleeps or is off");
    this.complete++;
    this.#frame.pixels = this.#picture();
  }

  /** The place in memory of the program's column and row. */
  #cell(column, row) {
    const [width, height] = this.module.memory;
    let [x, y] = this.#mode & 0x20 ? [row, column] : [column, row];
    if (this.#mode & 0x40) x = width - 1 - x;
    if (this.#mode & 0x80) y = height - 1 - y;
    return x >= 0 && x < width && y >= 0 && y < height ? y * width + x : undefined;
  }

  /** What somebody sees who has turned the module so that the picture is upright. */
  #picture() {
    const { memory, module: { size: [width, height], memory: [stride], offset, rotation, isMirrored } } = this;
    const [columns, rows] = this.size();
    const pixels = new Uint8Array(3 * columns * rows);
    for (let row = 0, at = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++, at += 3) {
        const [x, y] = [
          [column, row], [width - 1 - row, column], [width - 1 - column, height - 1 - row], [row, height - 1 - column],
        ][rotation];
        const cell = (offset[1] + y) * stride + offset[0] + (isMirrored ? width - 1 - x : x);
        pixels.set(this.#color(memory[cell]), at);
      }
    }
    return pixels;
  }

  /** Red, green and blue of a pixel. */
  #color(pixel) {
    const levels = this.#bytesOfPixel === 2
      ? [of(pixel >> 11, 31), of(pixel >> 5 & 63, 63), of(pixel & 31, 31)]
      : [five(pixel >> 18 & 63), of(pixel >> 10 & 63, 63), five(pixel >> 2 & 63)];
    const isExchanged = Boolean(this.#mode & 8) !== this.module.isBlueFirst;
    const seen = isExchanged ? levels.reverse() : levels;
    return this.#isInverted === this.module.isInverted ? seen : seen.map((level) => 255 - level);
  }

  /** Throws the errors, if there were any. */
  check() {
    if (!this.errors.length) return;
    throw new Error(`${this.errors.length} errors on the bus: ${[...new Set(this.errors)].slice(0, 5).join("; ")}`);
  }
}

/** A level of six bits that was made of five, as one of 255; another one is wrong. */
const five = (level) => (level & 1) === level >> 5 ? of(level >> 1, 31) : 0;

/** A level of `most` as one of 255. */
function of(level, most) {
  return Math.floor((level * 255 + (most >> 1)) / most);
}

/** The board, from the second-stage boot loader on. */
export class Pico {
  chip = new RP2040();
  panel;
  /** What the chip found wrong. */
  complaints = new Set();
  /** The cores. Each has its own time, its number, its queue of words from the other one, and its divider. */
  cores = [this.chip.core, new this.chip.core.constructor(this.chip)].map((core, number) => ({
    core, number, at: 0, runs: number === 0, words: [], divider: DIVIDER.map((name) => this.chip.sio[name]),
  }));
  /** The times in microseconds that the program asked for once it drew frames, one for each frame. */
  asked = [];
  /** The time in microseconds when the program asks for it. */
  time = () => Math.floor(this.chip.clock.nanos / 1000);
  /** The clocks that the display's bus takes for a word of so many bits. */
  clocks = (bits) => bits;
  #active = this.cores[0];
  #functions;

  /**
   * A board with a program in its flash, which is an ELF file or a UF2, and a module on its pins: by default the one
   * that the model in flash is for. `changes` are differences of the module.
   */
  constructor(program, changes = {}) {
    const complain = (part, text) => {
      this.complaints.add(`${part}: ${text}`);
      if (this.complaints.size > MISTAKES) throw new Error([...this.complaints].join("\n"));
    };
    const info = (_, text) => { if (text === "SEV") this.#event(); };
    this.chip.logger = { debug() {}, info, warn: complain, error: complain };
    this.#interrupts();
    this.#secondCore();
    this.#rom();
    this.#load(program);
    this.panel = new Panel(this.chip, { ...this.#wanted(), ...changes });
    this.#complete();
    this.#timer();
    this.#bus();
    const { core } = this.cores[0];
    [core.PC, core.SP] = [FLASH, 0x20041000];
  }

  /** Runs one instruction, or lets the time pass until something happens. */
  step() {
    const { chip } = this;
    const { clock } = chip;
    const active = this.#next();
    if (!active) {
      const next = clock.nanosToNextAlarm;
      if (!next) throw new Error("all cores wait for ever");
      clock.tick(next);
      return;
    }
    this.#activate(active);
    const { core } = active;
    if (active.at < clock.nanos) active.at = clock.nanos;
    else clock.tick(active.at - clock.nanos);
    if (core.PC < ROM_END) {
      this.#call(core);
      return;
    }
    const cycles = core.executeInstruction(); // which may change the time, too
    active.at += (cycles * 1e9) / chip.clkSys;
  }

  /** The core that is behind, of those that do not wait. */
  #next() {
    const first = this.cores[0];
    const second = this.cores[1];
    const isFirst = !first.core.waiting;
    if (second.runs && !second.core.waiting) return isFirst && first.at <= second.at ? first : second;
    return isFirst ? first : undefined;
  }

  #activate(next) {
    const [{ chip }, active] = [this, this.#active];
    if (next === active) return;
    DIVIDER.forEach((name, at) => { active.divider[at] = chip.sio[name]; chip.sio[name] = next.divider[at]; });
    this.#active = next;
    chip.core = next.core;
  }

  /** An event wakes a core that waits for one, or keeps the other from waiting. */
  #event() {
    for (const { core } of this.cores) {
      core.eventRegistered = !core.waiting;
      core.waiting = false;
    }
  }

  /**
   * An interrupt is requested by a peripheral for as long as it wants, or once by the program. rp2040js takes the
   * second for the first.
   */
  #interrupts() {
    let lines = 0;
    this.chip.setInterrupt = (irq, isHigh) => {
      lines = isHigh ? lines | 1 << irq : lines & ~(1 << irq);
      for (const { core } of this.cores) core.setInterrupt(irq, isHigh);
    };
    for (const { core } of this.cores) {
      const enter = core.exceptionEntry.bind(core);
      core.exceptionEntry = (exception) => {
        if (exception >= 16) core.pendingInterrupts &= ~(1 << exception - 16) | lines;
        enter(exception);
      };
    }
  }

  #secondCore() {
    const { cores, chip: { sio, clock } } = this;
    const [read, write] = [sio.readUint32.bind(sio), sio.writeUint32.bind(sio)];
    const start = [];
    sio.readUint32 = (at) => {
      const { number, words } = this.#active;
      switch (at) {
        case 0x00: return number;
        case 0x50: return 2 | (words.length ? 1 : 0);
        case 0x58: return words.shift() ?? 0;
        default: return read(at);
      }
    };
    sio.writeUint32 = (at, value) => {
      if (at === 0x50) return;
      if (at !== 0x54) { write(at, value); return; }
      const [, second] = cores;
      if (second.runs) cores[1 - this.#active.number].words.push(value);
      else {
        // The second core's boot ROM returns each word. After 0, 0, 1 come its vectors, its stack and its program.
        cores[0].words.push(value);
        if (value !== [0, 0, 1][start.length] && start.length < 3) start.length = 0;
        else if (start.push(value >>> 0) === 6) {
          [, , , second.core.VTOR, second.core.SP] = start;
          second.core.PC = start[5] & ~1;
          [second.runs, second.at] = [true, clock.nanos];
        }
      }
      this.#event();
    };
  }

  /** The boot ROM's functions have addresses of their own: the first looks up the others by their names. */
  #rom() {
    const { chip } = this;
    const rom = new Uint32Array(ROM_END / 4).fill(0x47704770); // BX LR
    rom[0x14 / 4] = 0x00800080; // two tables, which no function reads
    rom[0x18 / 4] = 0x101;
    chip.loadBootrom(rom);
    const named = { MS: 0x111, S4: 0x111, MC: 0x121, C4: 0x121, L3: 0x131 };
    const takes = (cycles) => { this.#active.at += ((20 + cycles) * 1e9) / chip.clkSys; }; // by a word at a time
    this.#functions = {
      0x100: ([, code]) => {
        const found = named[String.fromCharCode(code & 0xff, code >> 8)];
        if (!found) throw new Error(`asks for ROM function ${code.toString(16)}`);
        return found;
      },
      0x110: ([to, value, count]) => {
        for (let i = 0; i < count; i++) chip.writeUint8(to + i, value & 0xff);
        takes(count / 3);
        return to;
      },
      0x120: ([to, from, count]) => {
        for (let i = 0; i < count; i++) chip.writeUint8(to + i, chip.readUint8(from + i));
        takes((count * 2) / 3);
        return to;
      },
      0x130: ([value]) => Math.clz32(value),
    };
  }

  #call(core) {
    const call = this.#functions[core.PC & ~1];
    if (!call) throw new Error(`runs at ${core.PC.toString(16)}`);
    core.registers[0] = call([...core.registers].slice(0, 3).map((value) => value >>> 0));
    core.PC = core.registers[14] & ~1;
  }

  /** Puts the program's segments, or the blocks of a UF2, at their addresses in flash. */
  #load(program) {
    const file = new DataView(program.buffer, program.byteOffset, program.length);
    const word = (at) => file.getUint32(at, true);
    const put = (offset, size, address) => {
      this.chip.flash.set(program.subarray(offset, offset + size), address - FLASH);
    };
    if (word(0) === 0x0a324655) {
      for (let at = 0; at < program.length; at += 512) put(at + 32, word(at + 16), word(at + 12));
      return;
    }
    for (let i = 0; i < file.getUint16(44, true); i++) {
      const header = word(28) + i * file.getUint16(42, true);
      const [type, offset, , address, size] = [0, 4, 8, 12, 16].map((at) => word(header + at));
      if (type === 1 && size) put(offset, size, address);
    }
  }

  /** The module that the header of a model names. */
  #wanted() {
    const { flash } = this.chip;
    const word = (at) => new DataView(flash.buffer, flash.byteOffset).getUint32(MODEL + 4 * at, true);
    return word(0) === MAGIC && word(1) === VERSION ? recorded(word) : ST7789;
  }

  /**
   * Adds what rp2040js lacks: the core's voltage (1.1 V, as after a reset), the ring oscillator's registers, the
   * register that aborts transfers (Embassy reads it, and no abort lasts), and the unit that protects memory. A write
   * to the value of SysTick starts a whole period; rp2040js ends a period at once. A program that asks whether the
   * period is over does nothing but wait: time passes faster.
   */
  #complete() {
    const { peripherals, dma, ppb } = this.chip;
    peripherals[0x40064].readUint32 = (at) => (at === 0x00 ? 0xb1 : 0);
    peripherals[0x40060].writeUint32 = () => {};
    const readDma = dma.readUint32.bind(dma);
    dma.readUint32 = (at) => (at === 0x444 ? 0 : readDma(at));
    const [read, write, mpu] = [ppb.readUint32.bind(ppb), ppb.writeUint32.bind(ppb), new Map()];
    ppb.readUint32 = (at) => {
      if (at === 0x10) for (const core of this.cores) core.at += 1e4;
      return at >= 0xd90 && at <= 0xda0 ? mpu.get(at) ?? 0 : read(at);
    };
    ppb.writeUint32 = (at, value) => {
      if (at === 0x18) ppb.systickTimer.set(ppb.systickReload);
      else if (at >= 0xd90 && at <= 0xda0) mpu.set(at, value);
      else write(at, value);
    };
  }

  /** For each frame, the program asks once for the time, by several reads. They see the same time. */
  #timer() {
    const { panel, chip: { clock, peripherals: { [0x40054]: timer } } } = this;
    const read = timer.readUint32.bind(timer);
    let last = 0;
    timer.readUint32 = (at) => {
      let us = Math.floor(clock.nanos / 1000);
      // Until the panel is set up, the program does nothing but wait: time passes faster.
      if (!panel.begun) this.#active.at += 1e5;
      else {
        if (clock.nanos - last > 1000) this.asked.push(this.time());
        last = clock.nanos;
        us = this.asked.at(-1);
      }
      if (!(at in TIMER)) return read(at);
      return TIMER[at] ? 0 : us;
    };
  }

  #bus() {
    const { panel, chip: { clock } } = this;
    const { bus } = panel;
    let sent = 0;
    const arrived = clock.createAlarm(() => {
      panel.word(sent, bus.dataBits);
      bus.completeTransmit(0xff);
    });
    bus.onTransmit = (value) => {
      sent = value;
      arrived.schedule(this.clocks(bus.dataBits) * 1e9 / bus.clockFrequency);
    };
  }
}
