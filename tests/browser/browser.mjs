// Chromium without a window, driven by the DevTools protocol over a pipe (https://chromedevtools.github.io/devtools-protocol/).

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const FLAGS = [
  "--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--hide-scrollbars", "--remote-debugging-pipe",
  // Pictures by the processor alone, the same on every machine.
  "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
];

/** A page in a browser of its own. */
export class Page {
  /** Opens an address, has `act` work on its page, and closes the browser whatever happens. */
  static async within(url, size, act) {
    const page = new Page();
    page.profile = mkdtempSync(join(tmpdir(), "radiosity-browser-"));
    try {
      await page.start(size);
      await page.open(url);
      await act(page);
    } finally {
      await page.close();
      rmSync(page.profile, { recursive: true, force: true, maxRetries: 5 });
    }
  }

  /** Starts the browser, with a window of so many pixels. */
  async start([width, height]) {
    Object.assign(this, { answers: new Map(), requests: [], faults: [], last: 0 });
    const flags = [...FLAGS, `--user-data-dir=${this.profile}`, `--window-size=${width},${height}`];
    this.process = spawn(process.env.CHROMIUM ?? "chromium", [...flags, "about:blank"], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    this.ended = new Promise((done) => this.process.on("exit", done));
    this.ended.then(() => this.answers.forEach(([, fail]) => fail(new Error("the browser has ended"))));
    this.process.stdio[3].on("error", () => {});
    await new Promise((done, fail) => this.process.on("spawn", done).on("error", fail));
    let text = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (piece) => {
      const messages = (text + piece).split("\0");
      text = messages.pop();
      messages.forEach((message) => this.hear(JSON.parse(message)));
    });
  }

  async open(url) {
    const { targetId } = await this.ask("Target.createTarget", { url: "about:blank" });
    this.session = (await this.ask("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    for (const domain of ["Page", "Network", "Runtime"]) await this.ask(`${domain}.enable`);
    await this.ask("Page.navigate", { url });
    await this.run("new Promise((done) => document.readyState === 'complete' ? done() : addEventListener('load', done))");
  }

  hear({ id, result, error, method, params }) {
    if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    if (method === "Runtime.exceptionThrown") this.faults.push(params.exceptionDetails.exception?.description ?? "?");
    const answer = this.answers.get(id);
    this.answers.delete(id);
    if (error) answer?.[1](new Error(error.message));
    else answer?.[0](result);
  }

  /** The answer to a command of the protocol. */
  ask(method, params = {}) {
    const id = ++this.last;
    const message = JSON.stringify({ id, method, params, sessionId: this.session });
    this.process.stdio[3].write(`${message}\0`);
    return new Promise((...answer) => this.answers.set(id, answer));
  }

  /** The value of an expression in the page, promises awaited. */
  async run(expression) {
    const { result, exceptionDetails } = await this.ask("Runtime.evaluate", {
      expression, awaitPromise: true, returnByValue: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Calls a function of the page's script with an argument: its value. */
  call(act, argument) {
    return this.run(`(async () => (${act})(await window.radiosity, ${JSON.stringify(argument ?? null)}))()`);
  }

  /** A picture of the whole window, as PNG. */
  async screenshot() {
    return Buffer.from((await this.ask("Page.captureScreenshot")).data, "base64");
  }

  /** Ends the browser, if it was started. */
  async close() {
    if (this.process?.pid === undefined) return;
    this.ask("Browser.close").catch(() => this.process.kill());
    await this.ended;
  }
}
