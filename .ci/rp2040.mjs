// Runs a program on an emulated RP2040, from the second-stage boot loader on, with a model of the panel on its pins.
//
//     rp2040.mjs PROGRAM PICTURE.ppm
//
// rp2040js emulates the core, clocks, timer, SPI with its FIFO, DMA with its requests, and pins; it must be installed in
// target/rp2040 (.ci/boards does it). The panel follows its data sheet: CS selects it, DC tells commands from data, CASET
// and RASET set a window, and RAMWR writes to it. A byte that is sent while CS is high is lost, and so is one that is on the
// bus when CS or DC changes: both are errors.
//
// Writes what the panel shows after two frames, and prints the time in ms at which the program drew the second one, the
// cycles from one frame to the next, and the bytes of stack that the program used.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { argv, cwd, exit } from 'node:process';

const { RP2040 } = createRequire(`${cwd()}/target/rp2040/`)('rp2040js');

const FLASH = 0x10000000, ROM_END = 0x1000;
const CS = 17, DC = 16;
const CASET = 0x2a, RASET = 0x2b, RAMWR = 0x2c;
const FRAMES = 4; // the first holds a black band; the last but one is the picture, complete when the next begins
const LIMIT = 2e9; // ns

const fail = message => { console.error(message); exit(1); };
if (argv.length !== 4) fail('rp2040.mjs PROGRAM PICTURE.ppm');
const [, , program, picture] = argv;

const chip = new RP2040();
const { core, clock, spi: [spi] } = chip;
const complaints = new Set();
function complain(part, text) {
  complaints.add(`${part}: ${text}`);
  if (complaints.size > 20) fail([...complaints].join('\n'));
}
chip.logger = { debug() {}, info() {}, warn: complain, error: complain };

// The boot ROM's functions, each at an address of its own: the first looks up the others by their names.
const rom = new Uint32Array(ROM_END / 4).fill(0x47704770); // BX LR
rom[0x14 / 4] = 0x00800080; // two tables, which no function reads
rom[0x18 / 4] = 0x101;
chip.loadBootrom(rom);
const named = { MS: 0x111, S4: 0x111, MC: 0x121, C4: 0x121, L3: 0x131 };
const functions = {
  0x100: ([, code]) => named[String.fromCharCode(code & 0xff, code >> 8)] ?? fail(`asks for ROM function ${code.toString(16)}`),
  0x110: ([to, value, count]) => { for (let i = 0; i < count; i++) chip.writeUint8(to + i, value & 0xff); return to; },
  0x120: ([to, from, count]) => { for (let i = 0; i < count; i++) chip.writeUint8(to + i, chip.readUint8(from + i)); return to; },
  0x130: ([value]) => Math.clz32(value),
};

// The program's segments, at their addresses in flash, and the end of its stack.
const elf = readFileSync(program);
for (let i = 0; i < elf.readUInt16LE(44); i++) {
  const header = elf.readUInt32LE(28) + i * elf.readUInt16LE(42);
  const [type, offset, , address, size] = [0, 4, 8, 12, 16].map(at => elf.readUInt32LE(header + at));
  if (type === 1 && size) chip.flash.set(elf.subarray(offset, offset + size), address - FLASH);
}

// What rp2040js lacks: the chip's revision register's neighbor, and the unit that protects memory.
chip.peripherals[0x40064].readUint32 = () => 0;
const [read, write, mpu] = [chip.ppb.readUint32.bind(chip.ppb), chip.ppb.writeUint32.bind(chip.ppb), new Map()];
chip.ppb.readUint32 = at => (at >= 0xd90 && at <= 0xda0 ? mpu.get(at) ?? 0 : read(at));
chip.ppb.writeUint32 = (at, value) => (at >= 0xd90 && at <= 0xda0 ? mpu.set(at, value) : write(at, value));

// When the program last asked for the time.
const timer = chip.peripherals[0x40054], readTimer = timer.readUint32.bind(timer);
let asked = 0;
timer.readUint32 = at => { asked = clock.nanos; return readTimer(at); };

// The panel.
let [selected, isData, command, data] = [false, true, null, []];
const windows = {}, frames = [], errors = [];
const changes = (name, set) => level => {
  if (spi.busy) errors.push(`${name} changed while a byte was on the bus`);
  set(level === 1);
};
chip.gpio[CS].addListener(changes('CS', high => { selected = !high; }));
chip.gpio[DC].addListener(changes('DC', high => { isData = high; }));
function execute() {
  if (command === CASET || command === RASET) {
    const [a, b, c, d] = data;
    windows[command] = [a << 8 | b, c << 8 | d];
  } else if (command === RAMWR) frames.at(-1).pixels = data;
  data = [];
}
let sent = 0;
const arrived = clock.createAlarm(() => {
  if (!selected) errors.push(`${sent.toString(16)} was sent while no panel listened`);
  else if (isData) data.push(sent);
  else {
    execute();
    command = sent;
    if (command === RAMWR) frames.push({ asked, cycles: core.cycles });
  }
  spi.completeTransmit(0xff);
});
spi.onTransmit = value => {
  sent = value;
  arrived.schedule(spi.dataBits * 1e9 / spi.clockFrequency);
};

core.PC = FLASH;
core.SP = 0x20041000;
let [top, lowest] = [0, Infinity];
while (frames.length < FRAMES) {
  if (core.waiting) {
    const next = clock.nanosToNextAlarm;
    if (!next) fail(`sleeps for ever at ${core.PC.toString(16)}`);
    clock.tick(next);
    continue;
  }
  if (core.PC < ROM_END) {
    const call = functions[core.PC & ~1] ?? fail(`runs at ${core.PC.toString(16)}`);
    core.registers[0] = call([...core.registers].slice(0, 3).map(value => value >>> 0));
    core.PC = core.registers[14] & ~1;
    continue;
  }
  clock.tick(core.executeInstruction() * 1e9 / chip.clkSys);
  const sp = core.registers[13];
  if (sp < 0x20040001 && sp > top) top = sp;
  if (top && sp < lowest) lowest = sp;
  if (clock.nanos > LIMIT) fail(`only ${frames.length} frames in ${LIMIT / 1e9} s`);
}
const [[left, right], [upper, lower]] = [CASET, RASET].map(axis => windows[axis] ?? fail('no window'));
const [width, height] = [right - left + 1, lower - upper + 1];
const shown = frames[FRAMES - 2];
if (shown.pixels.length !== 2 * width * height) errors.push(`${shown.pixels.length / 2} pixels in a window of ${width}x${height}`);
if (errors.length) fail(`${errors.length} errors on the bus: ${[...new Set(errors)].slice(0, 5).join('; ')}`);
for (const complaint of complaints) console.error(complaint);

const channel = (value, most) => Math.floor((value * 255 + (most >> 1)) / most);
const rgb = shown.pixels.flatMap((high, at) => {
  if (at % 2) return [];
  const pixel = high << 8 | shown.pixels[at + 1];
  return [channel(pixel >> 11, 31), channel(pixel >> 5 & 63, 63), channel(pixel & 31, 31)];
});
writeFileSync(picture, Buffer.concat([Buffer.from(`P6 ${width} ${height} 255\n`), Buffer.from(rgb)]));
console.log(Math.floor(shown.asked / 1e6), frames[FRAMES - 1].cycles - shown.cycles, top - lowest);
