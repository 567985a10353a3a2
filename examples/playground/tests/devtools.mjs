// Chromium without a window, by its DevTools protocol over a pipe.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

/** Longest wait for a condition: that of a machine that does much else. */
const PATIENCE = 60_000;
const KEYS = { " ": "Space", "+": "Equal", "-": "Minus" };

/** A browser with one page. */
export class Page {
  #profile = mkdtempSync(join(tmpdir(), "playground-"));
  #calls = new Map();
  #last = 0;
  /** Addresses of all requests, and what went wrong in scripts. */
  requests = [];
  errors = [];

  static async open() {
    const page = new Page();
    const { targetId } = await page.send("Target.createTarget", { url: "about:blank" });
    page.session = (await page.send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    for (const domain of ["Page", "Runtime", "Network", "Log"]) await page.send(`${domain}.enable`);
    return page;
  }

  constructor() {
    const options = ["disable-gpu", "disable-quic", "disable-background-networking", "disable-component-update"];
    const flags = ["headless", "hide-scrollbars", "no-sandbox", "no-first-run", "disable-sync", "remote-debugging-pipe", ...options];
    this.process = spawn("chromium", [...flags.map((flag) => `--${flag}`), `--user-data-dir=${this.#profile}`], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    let text = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (data) => {
      const messages = (text + data).split("\0");
      text = messages.pop();
      messages.forEach((message) => this.#receive(JSON.parse(message)));
    });
  }

  async close() {
    const ended = new Promise((resume) => this.process.on("exit", resume));
    this.send("Browser.close").catch(() => {});
    await ended;
    rmSync(this.#profile, { recursive: true, force: true, maxRetries: 5 });
  }

  #receive({ id, result, error, method, params }) {
    const call = this.#calls.get(id);
    this.#calls.delete(id);
    if (error) call?.reject(new Error(error.message));
    else call?.resolve(result);
    if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    if (method === "Runtime.exceptionThrown") this.errors.push(params.exceptionDetails.exception?.description);
    if (method === "Log.entryAdded" && params.entry.level === "error") this.errors.push(params.entry.text);
  }

  send(method, params = {}) {
    const id = ++this.#last;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.session })}\0`);
    return new Promise((resolve, reject) => this.#calls.set(id, { resolve, reject }));
  }

  /** The value of an expression in the page. */
  async evaluate(expression) {
    const options = { awaitPromise: true, returnByValue: true };
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, ...options });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description}`);
    return result.value;
  }

  /** Waits until an expression in the page has a value, or one that is not empty. */
  async until(expression, wanted) {
    const start = Date.now();
    for (;;) {
      const value = await this.evaluate(expression).catch((error) => error.message);
      if (wanted === undefined ? value : value === wanted) return value;
      if (Date.now() - start > PATIENCE) throw new Error(`${expression} is ${value}, not ${wanted ?? "there"}`);
      await sleep(30);
    }
  }

  /** The place of an element, scrolled into view. */
  box(selector) {
    return this.evaluate(`(() => {
      const element = document.querySelector(${JSON.stringify(selector)});
      element.scrollIntoView({ block: "center" });
      const { left, top, width, height } = element.getBoundingClientRect();
      return { left, top, width, height };
    })()`);
  }

  /** Moves the pointer with its button down along points. */
  async drag(...points) {
    const mouse = (type, [x, y], buttons) =>
      this.send("Input.dispatchMouseEvent", { type, x, y, buttons, button: "left", clickCount: 1 });
    await mouse("mousePressed", points[0], 1);
    for (const point of points.slice(1)) await mouse("mouseMoved", point, 1);
    await mouse("mouseReleased", points.at(-1), 0);
  }

  async click(selector) {
    const { left, top, width, height } = await this.box(selector);
    await this.drag([left + width / 2, top + height / 2]);
  }

  async press(key) {
    const text = key.length === 1 ? key : key === "Enter" ? "\r" : undefined;
    const code = KEYS[key] ?? key;
    const virtual = { Tab: 9, End: 35, Home: 36, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, " ": 32 };
    const common = { key, code, windowsVirtualKeyCode: virtual[key] };
    await this.send("Input.dispatchKeyEvent", { type: text ? "keyDown" : "rawKeyDown", text, ...common });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...common });
  }

  /** Chooses an option by its place in the list, with keys. */
  async choose(selector, index) {
    await this.evaluate(`document.querySelector("${selector}").focus()`);
    await this.press("Home");
    for (let at = 0; at < index; at++) await this.press("ArrowDown");
    await this.until(`document.querySelector("${selector}").selectedIndex`, index);
  }

  /** Drops files on an element. */
  async drop(selector, files) {
    const { left, top, width, height } = await this.box(selector);
    const place = { x: left + width / 2, y: top + height / 2 };
    const data = { items: [], files, dragOperationsMask: 1 };
    for (const type of ["dragEnter", "dragOver", "drop"]) await this.send("Input.dispatchDragEvent", { type, data, ...place });
  }

  size(width, height) {
    return this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
  }

  /** Limits what arrives from the network, in bits a second, and how soon, in milliseconds; without limits by default. */
  network(bits = -8, latency = 0) {
    const [downloadThroughput, uploadThroughput] = [bits / 8, bits / 8];
    return this.send("Network.emulateNetworkConditions", { offline: false, latency, downloadThroughput, uploadThroughput });
  }

  theme(value) {
    return this.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
  }

  /** A picture of the whole page, as PNG. */
  async screenshot() {
    const { cssContentSize } = await this.send("Page.getLayoutMetrics");
    const clip = { ...cssContentSize, x: 0, y: 0, scale: 1 };
    const { data } = await this.send("Page.captureScreenshot", { captureBeyondViewport: true, clip });
    return Buffer.from(data, "base64");
  }
}
