// Runs a program on an emulated RP2040, from the second-stage boot loader on, with a model of the panel on its pins.
//
//     rp2040.mjs PROGRAM PICTURE.ppm [--bus gaps|instant] [--fault NAME] [--profile FILE]
//
// The program is an ELF file or a UF2.
//
// rp2040js emulates a core, clocks, timer, SPI with its FIFO, DMA with its requests, and pins; it must be installed in
// target/rp2040 (.ci/boards does it). The second core is added here. The panel follows its data sheet: CS selects it, DC
// tells commands from data, CASET and RASET set a window, and RAMWR writes to it. A byte that is sent while CS is high is
// lost, and so is one that is on the bus when CS or DC changes: both are errors.
//
// Writes what the panel shows after some frames, and prints the time in ms at which the program drew the last of them, the
// mean of the cycles from one frame to the next, and the bytes of stack that each core used.
//
// --bus      gaps: it rests for two of its clocks after each word, as the chip's does in mode 0; instant: it takes no time,
//            so that what remains is the processors' time
// --fault    makes a mistake that a program could make; the run must then fail, or show another picture (see `faults`)
// --profile  writes the cycles of core 0 at each address, as JSON
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { cwd, exit } from 'node:process';
import { parseArgs } from 'node:util';

const require = createRequire(`${cwd()}/target/rp2040/`);
const { RP2040 } = require('rp2040js');

const FLASH = 0x10000000, ROM_END = 0x1000, RAM = 0x20000000, RAM_END = 0x20042000;
const CS = 17, DC = 16, BACKLIGHT = 21;
const NOP = 0x00, CASET = 0x2a, RASET = 0x2b, RAMWR = 0x2c;
const FIRST = 2, PERIODS = 8; // from this frame on, so many are measured; the picture is the last of them
const LIMIT = 2e9; // ns

const fail = message => { console.error(message); exit(1); };
const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: { bus: { type: 'string' }, fault: { type: 'string' }, profile: { type: 'string' } },
});
if (positionals.length !== 2) fail('rp2040.mjs PROGRAM PICTURE.ppm [--bus gaps|instant] [--fault NAME] [--profile FILE]');
const [program, picture] = positionals;

const chip = new RP2040();
const { clock, sio, dma, spi: [spi] } = chip;
const complaints = new Set();
function complain(part, text) {
  complaints.add(`${part}: ${text}`);
  if (complaints.size > 20) fail([...complaints].join('\n'));
}

// The cores. Each has its own time, its number, its queue of words from the other one, and its divider.
const DIVIDER = ['divDividend', 'divDivisor', 'divQuotient', 'divRemainder', 'divCSR'];
const cores = [chip.core, new chip.core.constructor(chip)].map((core, number) => (
  { core, number, at: 0, runs: number === 0, words: [], top: 0, lowest: RAM_END, divider: DIVIDER.map(name => sio[name]) }
));
let active = cores[0];
function activate(next) {
  if (next === active) return;
  DIVIDER.forEach((name, at) => { active.divider[at] = sio[name]; sio[name] = next.divider[at]; });
  active = next;
  chip.core = next.core;
}
// An event wakes a core that waits for one, or keeps the other from waiting.
function event() {
  for (const { core } of cores) {
    core.eventRegistered = !core.waiting;
    core.waiting = false;
  }
}
chip.logger = { debug() {}, info(_, text) { if (text === 'SEV') event(); }, warn: complain, error: complain };
// An interrupt is requested by a peripheral for as long as it wants, or once by the program. rp2040js takes the second
// for the first.
let lines = 0;
chip.setInterrupt = (irq, isHigh) => {
  lines = isHigh ? lines | 1 << irq : lines & ~(1 << irq);
  for (const { core } of cores) core.setInterrupt(irq, isHigh);
};
for (const { core } of cores) {
  const enter = core.exceptionEntry.bind(core);
  core.exceptionEntry = exception => {
    if (exception >= 16) core.pendingInterrupts &= ~(1 << exception - 16) | lines;
    enter(exception);
  };
}
const [readSio, writeSio] = [sio.readUint32.bind(sio), sio.writeUint32.bind(sio)];
const start = [];
sio.readUint32 = at => {
  switch (at) {
    case 0x00: return active.number;
    case 0x50: return 2 | (active.words.length ? 1 : 0);
    case 0x58: return active.words.shift() ?? 0;
    default: return readSio(at);
  }
};
sio.writeUint32 = (at, value) => {
  if (at === 0x50) return;
  if (at !== 0x54) { writeSio(at, value); return; }
  const [, second] = cores;
  if (second.runs) cores[1 - active.number].words.push(value);
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
  event();
};

// The boot ROM's functions, each at an address of its own: the first looks up the others by their names.
const rom = new Uint32Array(ROM_END / 4).fill(0x47704770); // BX LR
rom[0x14 / 4] = 0x00800080; // two tables, which no function reads
rom[0x18 / 4] = 0x101;
chip.loadBootrom(rom);
const named = { MS: 0x111, S4: 0x111, MC: 0x121, C4: 0x121, L3: 0x131 };
const takes = cycles => { active.at += (20 + cycles) * 1e9 / chip.clkSys; }; // by a word at a time
const functions = {
  0x100: ([, code]) => named[String.fromCharCode(code & 0xff, code >> 8)] ?? fail(`asks for ROM function ${code.toString(16)}`),
  0x110: ([to, value, count]) => {
    for (let i = 0; i < count; i++) chip.writeUint8(to + i, value & 0xff);
    takes(count / 3);
    return to;
  },
  0x120: ([to, from, count]) => {
    for (let i = 0; i < count; i++) chip.writeUint8(to + i, chip.readUint8(from + i));
    takes(count * 2 / 3);
    return to;
  },
  0x130: ([value]) => Math.clz32(value),
};

// The program's segments, or the blocks of a UF2, at their addresses in flash.
const file = readFileSync(program);
const put = (offset, size, address) => chip.flash.set(file.subarray(offset, offset + size), address - FLASH);
if (file.toString('latin1', 0, 4) === 'UF2\n') {
  for (let at = 0; at < file.length; at += 512) put(at + 32, file.readUInt32LE(at + 16), file.readUInt32LE(at + 12));
} else {
  for (let i = 0; i < file.readUInt16LE(44); i++) {
    const header = file.readUInt32LE(28) + i * file.readUInt16LE(42);
    const [type, offset, , address, size] = [0, 4, 8, 12, 16].map(at => file.readUInt32LE(header + at));
    if (type === 1 && size) put(offset, size, address);
  }
}

// What rp2040js lacks: the core's voltage (1.1 V, as after a reset), the ring oscillator's registers, the register that
// aborts transfers (Embassy reads it, and no abort lasts), and the unit that protects memory.
chip.peripherals[0x40064].readUint32 = at => (at === 0x00 ? 0xb1 : 0);
chip.peripherals[0x40060].writeUint32 = () => {};
const readDma = dma.readUint32.bind(dma);
dma.readUint32 = at => (at === 0x444 ? 0 : readDma(at));
const [read, write, mpu] = [chip.ppb.readUint32.bind(chip.ppb), chip.ppb.writeUint32.bind(chip.ppb), new Map()];
chip.ppb.readUint32 = at => (at >= 0xd90 && at <= 0xda0 ? mpu.get(at) ?? 0 : read(at));
chip.ppb.writeUint32 = (at, value) => (at >= 0xd90 && at <= 0xda0 ? mpu.set(at, value) : write(at, value));

// The timer. Once frames are drawn, each frame has a time of its own, so that a few frames show all of an animation.
// The program asks once for each of them, by several reads.
const STEP_MS = 750, TIMER = { 0x08: 1, 0x0c: 0, 0x24: 1, 0x28: 0 }; // halves of the microseconds, at the registers' addresses
const asked = [];
const timer = chip.peripherals[0x40054], readTimer = timer.readUint32.bind(timer);
let lastRead = 0;
timer.readUint32 = at => {
  let us = Math.floor(clock.nanos / 1000);
  // Until the panel is set up, the program does nothing but wait: time passes faster.
  if (!frames.length) active.at += 1e5;
  else {
    if (clock.nanos - lastRead > 1000) asked.push(STEP_MS * (asked.length + 1));
    lastRead = clock.nanos;
    us = asked.at(-1) * 1000;
  }
  if (!(at in TIMER)) return readTimer(at);
  return TIMER[at] ? 0 : us;
};

// The panel.
let [selected, isData, command, data, isLit] = [false, true, NOP, [], false];
const windows = {}, frames = [], errors = [];
const changes = (name, set) => level => {
  if (spi.busy) errors.push(`${name} changed while a byte was on the bus`);
  set(level === 1);
};
chip.gpio[CS].addListener(changes('CS', high => { selected = !high; }));
chip.gpio[DC].addListener(changes('DC', high => { isData = high; }));
chip.gpio[BACKLIGHT].addListener(level => {
  execute();
  const [cleared] = frames;
  if (level === 1 && !isComplete(cleared)) errors.push('the backlight is on before the panel is cleared');
  isLit = level === 1;
});
const size = () => [CASET, RASET].map(axis => windows[axis] ?? fail('no window')).map(([first, last]) => last - first + 1);
function isComplete(frame) {
  const [width, height] = size();
  return frame?.pixels.length === 2 * width * height;
}
// The data of a command are complete when the next command comes.
function execute() {
  const [a, b, c, d] = data;
  if (command === CASET || command === RASET) windows[command] = [a << 8 | b, c << 8 | d];
  if (command === RAMWR) {
    frames.at(-1).pixels = data;
    if (!isComplete(frames.at(-1))) errors.push(`${data.length} bytes in a window of ${size().join('x')} pixels`);
  }
  [command, data] = [NOP, []];
}
function receive(byte) {
  if (!selected) errors.push(`${byte.toString(16)} was sent while no panel listened`);
  else if (isData) data.push(byte);
  else {
    execute();
    command = byte;
    if (command === RAMWR) frames.push({ at: clock.nanos });
  }
  if (errors.length > 20) finish();
}
let sent = 0;
const arrived = clock.createAlarm(() => {
  if (spi.dataBits === 16) receive(sent >> 8);
  receive(sent & 0xff);
  spi.completeTransmit(0xff);
});
spi.onTransmit = value => {
  sent = value;
  const clocks = { gaps: spi.dataBits + 2, instant: 0 }[options.bus] ?? spi.dataBits;
  arrived.schedule(clocks * 1e9 / spi.clockFrequency);
};

// What a program could do wrong, as the chip would see it.
const readSpi = spi.readUint32.bind(spi), [channel] = dma.channels;
const faults = {
  // The bus is not flushed before a pin changes.
  flush: () => { spi.readUint32 = at => readSpi(at) & ~(at === 0x0c ? 0x10 : 0); },
  // DMA does not wait until the bus has room.
  request: () => { Object.defineProperty(channel, 'treqValue', { get: () => 0x3f, set() {} }); },
  // The bytes of a pixel are exchanged.
  order: () => { channel.transfer16 = channel.transferSwap16; },
  // Memory is drawn into while it is being sent: each transfer seems to have ended at once.
  wait: () => {
    const [begin, readChannel] = [channel.start.bind(channel), channel.readUint32.bind(channel)];
    channel.start = () => { begin(); dma.intRaw |= 1; dma.checkInterrupts(); };
    channel.readUint32 = at => readChannel(at) & ~(1 << 24);
  },
  // The panel is not selected.
  select: () => { chip.gpio[CS].addListener(() => { selected = false; }); },
};
if (options.fault) (faults[options.fault] ?? fail(`faults: ${Object.keys(faults).join(', ')}`))();

function finish() {
  if (errors.length) fail(`${errors.length} errors on the bus: ${[...new Set(errors)].slice(0, 5).join('; ')}`);
  if (!isLit) fail('the backlight is off');
  for (const complaint of complaints) console.error(complaint);
  const last = FIRST + PERIODS;
  const cycles = (frames[last].at - frames[FIRST].at) / PERIODS * chip.clkSys / 1e9;
  const shown = last - 1;
  const [width, height] = size();
  const channel = (value, most) => Math.floor((value * 255 + (most >> 1)) / most);
  const bytes = frames[shown].pixels;
  const rgb = bytes.flatMap((high, at) => {
    if (at % 2) return [];
    const pixel = high << 8 | bytes[at + 1];
    return [channel(pixel >> 11, 31), channel(pixel >> 5 & 63, 63), channel(pixel & 31, 31)];
  });
  writeFileSync(picture, Buffer.concat([Buffer.from(`P6 ${width} ${height} 255\n`), Buffer.from(rgb)]));
  if (options.profile) writeFileSync(options.profile, JSON.stringify([...profile]));
  // The first frame only clears the panel.
  console.log(asked[shown - 1], Math.round(cycles), ...cores.filter(({ runs }) => runs).map(({ top, lowest }) => top - lowest));
  exit();
}

const profile = new Map();
cores[0].core.PC = FLASH;
cores[0].core.SP = 0x20041000;
for (;;) {
  const ready = cores.filter(({ runs, core }) => runs && !core.waiting);
  if (!ready.length) {
    const next = clock.nanosToNextAlarm;
    if (!next) fail('all cores wait for ever');
    clock.tick(next);
    continue;
  }
  activate(ready.length > 1 && ready[1].at < ready[0].at ? ready[1] : ready[0]);
  const { core } = active;
  if (active.at < clock.nanos) active.at = clock.nanos;
  else clock.tick(active.at - clock.nanos);
  if (core.PC < ROM_END) {
    const call = functions[core.PC & ~1] ?? fail(`runs at ${core.PC.toString(16)}`);
    core.registers[0] = call([...core.registers].slice(0, 3).map(value => value >>> 0));
    core.PC = core.registers[14] & ~1;
    continue;
  }
  const pc = core.PC, cycles = core.executeInstruction();
  active.at += cycles * 1e9 / chip.clkSys;
  if (options.profile && frames.length > FIRST) profile.set(pc, (profile.get(pc) ?? 0) + cycles);
  const sp = core.registers[13];
  if (sp > RAM && sp < RAM_END) {
    // The boot loader's stack is elsewhere.
    if (sp > active.top && sp <= 0x20040000) active.top = sp;
    if (active.top && sp < active.lowest) active.lowest = sp;
  }
  if (frames.length > FIRST + PERIODS) finish();
  if (clock.nanos > LIMIT) fail(`only ${frames.length} frames in ${LIMIT / 1e9} s`);
}
