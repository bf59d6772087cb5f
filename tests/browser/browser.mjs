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
  static async open(url, [width, height]) {
    const page = new Page();
    page.profile = mkdtempSync(join(tmpdir(), "radiosity-browser-"));
    const flags = [...FLAGS, `--user-data-dir=${page.profile}`, `--window-size=${width},${height}`];
    page.process = spawn(process.env.CHROMIUM ?? "chromium", [...flags, "about:blank"], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    page.answers = new Map();
    page.requests = [];
    page.faults = [];
    page.last = 0;
    let text = "";
    page.process.stdio[4].setEncoding("utf8").on("data", (piece) => {
      const messages = (text + piece).split("\0");
      text = messages.pop();
      messages.forEach((message) => page.hear(JSON.parse(message)));
    });
    const { targetId } = await page.ask("Target.createTarget", { url: "about:blank" });
    page.session = (await page.ask("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    for (const domain of ["Page", "Network", "Runtime"]) await page.ask(`${domain}.enable`);
    await page.ask("Page.navigate", { url });
    await page.run("new Promise((done) => document.readyState === 'complete' ? done() : addEventListener('load', done))");
    return page;
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

  async close() {
    const ended = new Promise((done) => this.process.on("exit", done));
    await this.ask("Browser.close").catch(() => this.process.kill());
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
