// An emulated Raspberry Pi Pico with a panel on its pins: .ci/rp2040.mjs checks programs with it, and worker.js runs
// them in a page.
//
// rp2040js emulates a core, clocks, timer, SPI with its FIFO, DMA with its requests, and pins. The second core is added
// here, and so is the panel.
import { RP2040 } from "rp2040js";

const FLASH = 0x10000000, ROM_END = 0x1000;
const CS = 17, DC = 16, BACKLIGHT = 21;
const NOP = 0x00, CASET = 0x2a, RASET = 0x2b, RAMWR = 0x2c;
/** More mistakes than these end a run. */
const MISTAKES = 20;

/** Halves of the microseconds, at the addresses of the timer's registers. */
const TIMER = { 0x08: 1, 0x0c: 0, 0x24: 1, 0x28: 0 };
const DIVIDER = ["divDividend", "divDivisor", "divQuotient", "divRemainder", "divCSR"];

/**
 * The panel follows its data sheet: CS selects it, DC tells commands from data, CASET and RASET set a window, and RAMWR
 * writes to it. A byte that is sent while CS is high is lost, and so is one that is on the bus when CS or DC changes:
 * both are errors.
 */
class Panel {
  isSelected = false;
  isLit = false;
  /** The bytes that were received. */
  received = 0;
  /** How many frames were begun, and how many of them are complete. */
  begun = 0;
  complete = 0;
  errors = [];
  /** Is called as a frame begins. The one before has its pixels by then: two bytes each, row by row. */
  onFrame = () => {};
  #isData = true;
  #command = NOP;
  #data = [];
  #windows = {};
  #frame;

  constructor({ gpio, clock, spi: [spi] }) {
    const changes = (name, set) => (level) => {
      if (spi.busy) this.errors.push(`${name} changed while a byte was on the bus`);
      set(level === 1);
    };
    this.now = () => clock.nanos;
    gpio[CS].addListener(changes("CS", (isHigh) => { this.isSelected = !isHigh; }));
    gpio[DC].addListener(changes("DC", (isHigh) => { this.#isData = isHigh; }));
    gpio[BACKLIGHT].addListener((level) => {
      this.#execute();
      if (level === 1 && !this.complete) this.errors.push("the backlight is on before the panel is cleared");
      this.isLit = level === 1;
    });
  }

  /** Columns and rows of the window. */
  size() {
    return [CASET, RASET].map((axis) => {
      if (!this.#windows[axis]) throw new Error("no window");
      const [first, last] = this.#windows[axis];
      return last - first + 1;
    });
  }

  receive(byte) {
    this.received++;
    if (!this.isSelected) this.errors.push(`${byte.toString(16)} was sent while no panel listened`);
    else if (this.#isData) this.#data.push(byte);
    else {
      this.#execute();
      this.#command = byte;
      if (byte === RAMWR) this.#begin();
    }
    if (this.errors.length > MISTAKES) this.check();
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
    if (command === CASET || command === RASET) this.#windows[command] = [a << 8 | b, c << 8 | d];
    if (command === RAMWR) {
      const [width, height] = this.size();
      this.#frame.pixels = data;
      if (data.length === 2 * width * height) this.complete++;
      else this.errors.push(`${data.length} bytes in a window of ${width}x${height} pixels`);
    }
    [this.#command, this.#data] = [NOP, []];
  }

  /** Throws the errors, if there were any. */
  check() {
    if (!this.errors.length) return;
    throw new Error(`${this.errors.length} errors on the bus: ${[...new Set(this.errors)].slice(0, 5).join("; ")}`);
  }
}

/** A pixel of two bytes as red, green and blue from 0 to 255. */
export function rgb(high, low) {
  const channel = (value, most) => Math.floor((value * 255 + (most >> 1)) / most);
  const pixel = high << 8 | low;
  return [channel(pixel >> 11, 31), channel(pixel >> 5 & 63, 63), channel(pixel & 31, 31)];
}

/** The board, from the second-stage boot loader on. */
export class Pico {
  chip = new RP2040();
  panel = new Panel(this.chip);
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

  /** A board with a program in its flash, which is an ELF file or a UF2. */
  constructor(program) {
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

  /**
   * Adds what rp2040js lacks: the core's voltage (1.1 V, as after a reset), the ring oscillator's registers, the
   * register that aborts transfers (Embassy reads it, and no abort lasts), and the unit that protects memory.
   */
  #complete() {
    const { peripherals, dma, ppb } = this.chip;
    peripherals[0x40064].readUint32 = (at) => (at === 0x00 ? 0xb1 : 0);
    peripherals[0x40060].writeUint32 = () => {};
    const readDma = dma.readUint32.bind(dma);
    dma.readUint32 = (at) => (at === 0x444 ? 0 : readDma(at));
    const [read, write, mpu] = [ppb.readUint32.bind(ppb), ppb.writeUint32.bind(ppb), new Map()];
    ppb.readUint32 = (at) => (at >= 0xd90 && at <= 0xda0 ? mpu.get(at) ?? 0 : read(at));
    ppb.writeUint32 = (at, value) => (at >= 0xd90 && at <= 0xda0 ? mpu.set(at, value) : write(at, value));
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
    const { panel, chip: { clock, spi: [spi] } } = this;
    let sent = 0;
    const arrived = clock.createAlarm(() => {
      if (spi.dataBits === 16) panel.receive(sent >> 8);
      panel.receive(sent & 0xff);
      spi.completeTransmit(0xff);
    });
    spi.onTransmit = (value) => {
      sent = value;
      arrived.schedule(this.clocks(spi.dataBits) * 1e9 / spi.clockFrequency);
    };
  }
}
