// The crate's WebAssembly and the page's model of errors, under Node. PAGE is the folder with the page, SIMULATOR the
// program that draws on the host.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { checksum, crate, page, view } from "./page.mjs";

const { MODES } = await page("module.js");
const SCENES = ["floor", "cube", "sphere", "sphere-flat", "lighthouse"];

test("the measured scenes have the simulator's checksums", () => {
  const folder = mkdtempSync(join(tmpdir(), "playground-"));
  for (const [index, id] of SCENES.entries()) {
    // The simulator has no Compact.
    for (const [mode, name] of MODES.slice(0, 4).entries()) {
      const scene = id === "lighthouse" ? [] : ["--scene", id];
      const options = ["--mode", name.toLowerCase(), ...scene, "--crc", "--out", join(folder, "picture.png")];
      const told = execFileSync(process.env.SIMULATOR, options, { encoding: "utf8", stdio: "pipe" });
      assert.equal(checksum(view(index, { mode })), /^crc (.*)$/m.exec(told)[1], `${id}, ${name}`);
    }
  }
  rmSync(folder, { recursive: true });
});

test("each format of a display has a checksum of its own, of what is shown", () => {
  const found = [0, 1, 2, 3, 4, 5].map((format) => {
    const settings = view(4, { format, size: "128x64" });
    const told = checksum(settings);
    if (format === 0) return told;
    const { data } = crate.image("show", settings, 0);
    const bytes = data.filter((_, at) => at % 4 !== 3);
    let crc = -1;
    for (const byte of bytes) {
      crc ^= byte;
      for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (0xedb88320 & -(crc & 1));
    }
    assert.equal(told, (~crc >>> 0).toString(16).padStart(8, "0"));
    return told;
  });
  assert.equal(new Set(found).size, 6);
});

test("errors are those that modes promise", () => {
  for (const scene of [0, 1, 2, 4]) {
    // In texels (guide to modes): Exact and Compact a thousandth, Newton 1/32 more, Fast its tolerance and 2^-13 of the
    // texture.
    // Affine bends the cube.
    const side = scene === 4 ? 128 : 64;
    const most = { Exact: 0.001, Newton: 1 / 32 + 0.001, Fast: 0.25 + side / 2 ** 13, Compact: 0.001, Affine: Infinity };
    for (const [mode, name] of MODES.entries()) {
      const { max, pixels } = crate.ask("errors", crate.ask("measure", view(scene, { mode })));
      const least = name === "Affine" && scene === 1 ? 5 : 0;
      assert.ok(max >= least && max <= most[name], `${SCENES[scene]} in mode ${name}: ${max} texels`);
      assert.ok(pixels >= 20000, `${SCENES[scene]} in mode ${name}: ${pixels} pixels`);
    }
  }
});
