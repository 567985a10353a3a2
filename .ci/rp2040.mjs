// Runs a program on an emulated RP2040, from the second-stage boot loader on, with a model of the panel on its pins:
// examples/boards/emulator/pico.js. .ci/install.py installs rp2040js there.
//
//     rp2040.mjs PROGRAM PICTURE.ppm [--bus gaps|instant] [--landscape] [--no-cs] [--short] [--slow CORE]
//         [--fault NAME] [--panic] [--profile FILE]
//
// The program is an ELF file or a UF2.
//
// Writes what the panel shows after some frames, and prints the time in ms at which the program drew the last of them,
// the mean of the cycles from one frame to the next, the bus's frequency in kHz, a 1 or a 0 for each frame for which
// the LED was on or off, and the bytes of stack that each core used.
//
// --panic    a frame is on its way when a core reads another number of its own than 0 and 1, once, which rp2040-hal
//            answers with a panic. Writes what the panel shows then. Prints the times in ms for which the LED is on,
//            off, on, ... until a pause, and the bytes of stack.
// --bus      gaps: the bus rests for two of its clocks after each word, as the chip's bus does in mode 0;
//            instant: the bus takes no time, so that only the processors' time remains
// --landscape  the panel is an ST7789 of 240x320 pixels, turned to 320x240
// --no-cs    the panel's CS is tied low, and the program's pin is not wired
// --short    measures only one frame
// --slow     this core takes three times as long, so that the cores finish their bands in another order
// --fault    makes a mistake that a program could make; the run must then fail, or show another picture (see `faults`)
// --profile  writes the cycles of core 0 at each address, as JSON
import { readFileSync, writeFileSync } from 'node:fs';
import { exit } from 'node:process';
import { parseArgs } from 'node:util';
import { Pico, ST7789 } from '../examples/boards/emulator/pico.js';

const RAM = 0x20000000, RAM_END = 0x20042000;

const fail = message => { console.error(message); exit(1); };
const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    bus: { type: 'string' }, landscape: { type: 'boolean' }, 'no-cs': { type: 'boolean' },
    short: { type: 'boolean' }, slow: { type: 'string' }, fault: { type: 'string' }, panic: { type: 'boolean' },
    profile: { type: 'string' },
  },
});
// The longest run, in ns.
const LIMIT = options.panic ? 4e9 : 2e9;
// From frame FIRST on, PERIODS frames are measured. The picture is the last one.
const FIRST = options.short ? 1 : 2;
const PERIODS = options.short ? 1 : options.fault || options['no-cs'] || options.slow ? 3 : 8;
const LAST = FIRST + PERIODS;
if (positionals.length !== 2) fail('rp2040.mjs PROGRAM PICTURE.ppm [OPTION ...]');
const [program, picture] = positionals;
const changes = {
  ...(options.landscape && { size: [240, 320], rotation: 1 }),
  ...(options['no-cs'] && { pins: { ...ST7789.pins, cs: undefined } }),
};

const pico = new Pico(readFileSync(program), changes);
const { chip, panel } = pico;
const { bus: spi, module } = panel;
const { clock, dma } = chip;
pico.clocks = { gaps: bits => bits + 2, instant: () => 0 }[options.bus] ?? pico.clocks;
// The time advances by 750 ms for each frame, so that a few frames show all of an animation.
const STEP_MS = 750;
pico.time = () => {
  // By now, the program has set the LED for the last frame.
  levels.push(isLedOn);
  return STEP_MS * (pico.asked.length + 1) * 1000;
};
// The LED on the board: whether it is on, and was at the end of each frame.
let isLedOn = 0;
const levels = [];
// When the LED changed after a panic, in ns, from the time on at which it was first on.
const blinks = [];
chip.gpio[25].addListener(level => {
  const isOn = Number(level === 1);
  if (isOn !== isLedOn && isSeeded && (isOn || blinks.length)) blinks.push(clock.nanos);
  isLedOn = isOn;
});
// The first frame only clears the panel.
const frames = [];
panel.onFrame = frame => frames.push(frame);

// Records the instructions that the cores execute, and the stack that they use.
const profile = new Map();
const stacks = pico.cores.map(({ core, number }) => {
  const stack = { top: 0, lowest: RAM_END };
  const execute = core.executeInstruction.bind(core);
  core.executeInstruction = () => {
    const pc = core.PC, cycles = execute(), sp = core.registers[13];
    if (options.profile && number === 0 && frames.length > FIRST) profile.set(pc, (profile.get(pc) ?? 0) + cycles);
    if (sp > RAM && sp < RAM_END) {
      // The boot loader's stack is above this address, and does not count.
      if (sp > stack.top && sp <= 0x20040000) stack.top = sp;
      if (stack.top && sp < stack.lowest) stack.lowest = sp;
    }
    return options.slow === String(number) ? 3 * cycles : cycles;
  };
  return stack;
});

// Mistakes that a program could make, as the chip would see them.
const frequency = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(spi), 'clockFrequency').get;
const scale = factor => Object.defineProperty(spi, 'clockFrequency', { get: () => frequency.call(spi) * factor });
const readSpi = spi.readUint32.bind(spi), [channel] = dma.channels;
const faults = {
  // The bus is not flushed before a pin changes.
  flush: () => { spi.readUint32 = at => readSpi(at) & ~(at === 0x0c ? 0x10 : 0); },
  // DMA does not wait until the bus has room.
  request: () => { Object.defineProperty(channel, 'treqValue', { get: () => 0x3f, set() {} }); },
  // The bytes of a pixel are exchanged.
  order: () => { channel.transfer16 = channel.transferSwap16; },
  // The program draws into memory that is being sent, because each transfer seems to have ended at once.
  wait: () => {
    const [begin, readChannel] = [channel.start.bind(channel), channel.readUint32.bind(channel)];
    channel.start = () => { begin(); dma.intRaw |= 1; dma.checkInterrupts(); };
    channel.readUint32 = at => readChannel(at) & ~(1 << 24);
  },
  // The panel is not selected.
  select: () => { chip.gpio[17].addListener(() => { panel.isSelected = false; }); },
  // The clock rises once more after the reset, as it does when the bus is set up again.
  edge: () => { chip.gpio[20].addListener(level => { if (level === 1) panel.disturb(); }); },
  // The bus has half of its frequency, or twice as much.
  half: () => scale(0.5),
  fast: () => scale(2),
  // The program takes the panel for another: its picture is mirrored, negative, or has red for blue.
  mirror: () => { module.isMirrored = !module.isMirrored; },
  invert: () => { module.isInverted = !module.isInverted; },
  colors: () => { module.isBlueFirst = !module.isBlueFirst; },
};
// The panic, and how long a run waits for blinks after the last one.
const PAUSE = 7e8; // ns
let isSeeded = false;
const readSio = chip.sio.readUint32;
chip.sio.readUint32 = at => {
  if (at !== 0 || !options.panic || isSeeded || frames.length <= FIRST) return readSio(at);
  isSeeded = true;
  return 2;
};
if (options.fault) (faults[options.fault] ?? fail(`faults: ${Object.keys(faults).join(', ')}`))();

const isDone = () => (options.panic
  ? blinks.length && clock.nanos - blinks.at(-1) > PAUSE
  : frames.length > LAST);
try {
  while (!isDone()) {
    pico.step();
    if (clock.nanos > LIMIT) fail(`only ${frames.length} frames and ${blinks.length} blinks in ${LIMIT / 1e9} s`);
  }
  panel.check();
} catch (error) {
  fail(error.message);
}
if (!panel.isLit) fail('the backlight is off');
for (const complaint of pico.complaints) console.error(complaint);
const [width, height] = panel.size();
const shown = options.panic ? frames.at(-1) : frames[LAST - 1];
writeFileSync(picture, Buffer.concat([Buffer.from(`P6 ${width} ${height} 255\n`), shown.pixels]));
if (options.profile) writeFileSync(options.profile, JSON.stringify([...profile]));
const used = pico.cores.filter(({ runs }) => runs).map(({ number }) => stacks[number].top - stacks[number].lowest);
if (options.panic) {
  const times = blinks.slice(1).map((at, i) => Math.round((at - blinks[i]) / 1e6));
  console.log(...times, used[0]);
} else {
  const cycles = (frames[LAST].at - frames[FIRST].at) / PERIODS * chip.clkSys / 1e9;
  console.log(pico.asked[LAST - 2] / 1000, Math.round(cycles), panel.busHz / 1000, levels.slice(1).join(''), ...used);
}
