// Makes dist/emulator.js, the one file of worker.js and all that it imports, for the playground.
import { readFileSync } from "node:fs";
import { build } from "esbuild";

const license = readFileSync("node_modules/rp2040js/LICENSE", "utf8");
const banner = { js: `/* Contains rp2040js:\n\n${license}*/` };
await build({ entryPoints: ["worker.js"], bundle: true, minify: true, banner, outfile: "dist/emulator.js" });
