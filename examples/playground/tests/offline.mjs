// The published page without a network, and after a newer version was published. PAGE is the folder with the page.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import test, { after } from "node:test";
import { Page } from "./devtools.mjs";

const KINDS = { html: "text/html", css: "text/css", js: "text/javascript" };
const digest = (bytes) => createHash("sha256").update(bytes).digest("hex");

/** What the server has: contents by names. */
const old = Object.fromEntries(readdirSync(process.env.PAGE).map((name) => [name, readFileSync(join(process.env.PAGE, name))]));
let published = old;
/** What the browser has. */
let used;
/** The names that it was asked for. */
const asked = [];
function answer(request, response) {
  const name = request.url.replace("/fixel/", "").replace(/[?#].*/, "") || "index.html";
  asked.push(name);
  const content = name === "doc/page.html" ? `guide ${published === old}` : published[name];
  response.writeHead(content ? 200 : 404, { Connection: "close", "Content-Type": KINDS[name.split(".").at(-1)] ?? "application/octet-stream" });
  response.end(content);
}
/** Starts a server. */
const listen = (port) =>
  new Promise((resume) => {
    const server = createServer(answer);
    server.listen(port, "127.0.0.1", () => resume(server));
  });
/** Ends a server, with all its connections. */
function end(server) {
  const ended = new Promise((resume) => server.close(resume));
  server.closeAllConnections();
  return ended;
}
let server = await listen(0);
const { port } = server.address();
const ADDRESS = `http://127.0.0.1:${port}/fixel/`;

const page = await Page.open();
after(async () => {
  await page.close();
  await end(server);
});
const REGISTRATION = "navigator.serviceWorker.getRegistration()";
/** Closes the page, and opens it again after some milliseconds. */
const visit = async (pause = 0) => {
  await page.send("Page.navigate", { url: "about:blank" });
  await new Promise((resume) => setTimeout(resume, pause));
  await page.send("Page.navigate", { url: ADDRESS });
  await page.until(`document.querySelector("main")?.inert === false`);
};
/** The digests of files as the page gets them. */
const found = (...names) =>
  page.evaluate(`Promise.all(${JSON.stringify(names)}.map(async (name) => {
    const bytes = await crypto.subtle.digest("SHA-256", await (await fetch(name)).arrayBuffer());
    return Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, "0")).join("");
  }))`);
const digests = (version, ...names) => names.map((name) => digest(version[name]));

/** A newer version: two files are others, and the script has their digests. */
function renewed(version, name) {
  const files = { ...version };
  let script = String(version["offline.js"]);
  for (const name of ["style.css", "globe.ply"]) {
    files[name] = Buffer.concat([version[name], Buffer.from("\n")]);
    assert.ok(script.includes(digest(version[name])));
    script = script.replace(digest(version[name]), digest(files[name]));
  }
  files["offline.js"] = Buffer.from(script.replace(/VERSION, FILES\] = \["\w+"/, `VERSION, FILES] = ["${name}"`));
  assert.ok(files["offline.js"].includes(`["${name}", {`));
  return files;
}

test("no page gets files of two versions", async () => {
  const names = ["style.css", "globe.ply", "main.js"];
  await visit();
  await page.until(`navigator.serviceWorker.ready.then(({ active }) => active.state)`, "activated");
  await visit();
  await page.until(`Boolean(navigator.serviceWorker.controller)`);

  // A newer version is published. The page that is open stays what it was, and the guide is always the server's.
  const newer = renewed(old, "newer");
  used = newer;
  published = newer;
  // The browser may wait for a minute before it asks for the script again.
  await page.evaluate(`${REGISTRATION}.then((found) => found.update()).then(() => {})`);
  await page.until(`${REGISTRATION}.then(({ waiting }) => Boolean(waiting))`);
  assert.deepEqual(await found(...names), digests(old, ...names));
  assert.equal(await page.evaluate(`fetch("doc/page.html").then((response) => response.text())`), "guide false");
  // Once that page is closed, the browser takes a moment to change.
  for (let pause = 0; ; pause += 500) {
    await visit(pause);
    const seen = await found(...names);
    if (seen[0] === digest(newer["style.css"])) {
      assert.deepEqual(seen, digests(newer, ...names));
      break;
    }
    assert.deepEqual(seen, digests(old, ...names));
    assert.ok(pause < 10_000, "the new version is never seen");
  }
  await page.until(`caches.keys().then((keys) => keys.filter((key) => !key.endsWith(" newer")).length)`, 0);

  // A server that has the newest script already, but still an old file: its version is never used.
  published = { ...renewed(newer, "newest"), "globe.ply": newer["globe.ply"] };
  const before = asked.length;
  while (!asked.slice(before).includes("globe.ply")) {
    await page.evaluate(`${REGISTRATION}.then((found) => void found.update().catch(() => {}))`);
    await new Promise((resume) => setTimeout(resume, 100));
  }
  await visit(2000);
  assert.deepEqual(await found(...names), digests(newer, ...names));
  assert.equal(await page.evaluate(`${REGISTRATION}.then(({ waiting }) => waiting)`), null);
});

// The last test: after a network was missing, the browser asks for no update for a while.
test("a reload without a network has the whole page", async () => {
  await end(server);
  try {
    await page.send("Page.reload");
    await page.until(`Boolean(navigator.serviceWorker.controller)`);
    await page.until(`document.querySelector("#numbers")?.textContent.includes("Pictures a second")`);
    const names = Object.keys(used).filter((name) => name !== "offline.js");
    assert.ok(names.length > 25);
    assert.deepEqual(await found(...names), digests(used, ...names));
  } finally {
    server = await listen(port); // which `after` ends
  }
});
