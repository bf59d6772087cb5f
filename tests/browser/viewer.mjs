// The page of a walk-through: every control, pictures against those of `radiosity render`, values against `radiosity probe`.
//
//     node viewer.mjs RADIOSITY WORK PICTURES

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { Page } from "./browser.mjs";

const [radiosity, work, pictures] = process.argv.slice(2);
const groups = new URL("groups.toml", import.meta.url).pathname;
const shapes = new URL("../data/every-shape.toml", import.meta.url).pathname;
const file = (name) => join(work, name);
const command = (...args) => execFileSync(radiosity, [...args, "--quiet"], { encoding: "utf8" });
const near = (a, b, error, what) => assert.ok(Math.abs(a - b) <= error * Math.abs(b), `${what}: ${a}, expected ${b}`);

/** Largest size of the page of the Cornell box, in bytes. */
const LARGEST = 3e6;
/** Frames per second at 640x360 below which something is wrong, on any machine; and those that are wanted of two quiet cores. */
const [FLOOR, WANTED] = [5, 30];

/** Prints what holds. */
const told = (text) => console.log(`ok: ${text}`);

function write() {
  const render = (solution, output, ...options) =>
    command("render", file(solution), "--read", "gather", ...options, "-o", file(output));
  command("solve", "cornell-box", "-o", file("box.json"));
  render("box.json", "box.html");
  render("box.json", "box.png");
  render("box.json", "exposed.png", "--exposure", "3");
  render("box.json", "false.png", "--false-colour", "--show", "irradiance");
  command("solve", groups, "-o", file("groups.json"));
  render("groups.json", "groups.html");
  render("groups.json", "groups.png");
  command("solve", shapes, "-o", file("shapes.json"));
  for (const name of ["shapes.html", "shapes.png"]) {
    command("render", file("shapes.json"), "--read", "basis", "--size", "400x300", "-o", file(name));
  }
}

/** Root mean square of the difference of two pictures' codes, over 255; of the second only its left part counts. */
async function difference(page, name) {
  const png = `data:image/png;base64,${readFileSync(file(name)).toString("base64")}`;
  return page.call(async (viewer, png) => {
    const pixels = async (url, size) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      const canvas = new OffscreenCanvas(...(size ?? [image.width, image.height]));
      const pen = canvas.getContext("2d");
      pen.drawImage(image, 0, 0);
      return pen.getImageData(0, 0, canvas.width, canvas.height);
    };
    const own = await pixels(viewer.picture());
    const other = await pixels(png, [own.width, own.height]);
    const sum = own.data.reduce((sum, code, k) => sum + (code - other.data[k]) ** 2, 0);
    return Math.sqrt(sum / (own.width * own.height * 3)) / 255;
  }, png);
}

/** Readings at pixels of surfaces of known normals, against gathered light at the same points. */
async function probed(page, solution, normals, settings = []) {
  const readings = (await page.call((viewer) => {
    const places = Array.from({ length: 100 }, (_, k) => [(k % 10) * 31.3 + 9, Math.floor(k / 10) * 23.7 + 7]);
    return places.map(([x, y]) => viewer.at(x, y));
  })).filter((reading) => reading && reading.surface.name in normals);
  assert.ok(readings.length > 20, `${readings.length} readings`);
  const rows = readings.map(({ surface, position }) => [...position, ...normals[surface.name]].join(","));
  writeFileSync(file("points.csv"), ["x,y,z,nx,ny,nz", ...rows].join("\n"));
  const sets = settings.flatMap((setting) => ["--set", setting]);
  const table = command("probe", file(solution), "--points", file("points.csv"), ...sets).trim().split("\n");
  const columns = table[0].split(",");
  const bands = readings[0].irradiance.length;
  const errors = [];
  table.slice(1).forEach((row, k) => {
    const values = row.split(",");
    assert.equal(values[columns.indexOf("surface")], readings[k].surface.name);
    near(Number(values[columns.indexOf("u")]) + 2, readings[k].u + 2, 1e-3, "u");
    const start = columns.findIndex((name) => name.startsWith("E_"));
    const end = columns.findIndex((name) => name.startsWith("B_"));
    for (let band = 0; band < bands; band++) {
      const [e, b] = [Number(values[start + band]), Number(values[end + band])];
      errors.push(Math.abs(readings[k].irradiance[band] / e - 1), Math.abs(readings[k].radiosity[band] / b - 1));
    }
  });
  errors.sort((a, b) => a - b);
  const [median, most, worst] = [0.5, 0.95, 1].map((part) => errors[Math.floor((errors.length - 1) * part)]);
  // Shadows have edges between texels, and probes read doubtful places anew, with noise of 0.7 %.
  assert.ok(median < 0.003 && most < 0.025 && worst < 0.2, `values differ by ${median} (median), ${most} (95 %), ${worst}`);
  const percent = (x) => `${(100 * x).toFixed(2)} %`;
  return `${errors.length} values differ from probe by ${percent(median)} (median), ${percent(most)} (95 of 100), ${percent(worst)} (largest)`;
}

/** Chooses a control of the panel as a user does: a click, or a value with its events. */
const use = (page, selector, value) =>
  page.call(async (_, [selector, value]) => {
    const control = document.querySelector(selector);
    if (value === null) return control.click();
    control.value = value;
    for (const name of ["input", "change"]) control.dispatchEvent(new Event(name, { bubbles: true }));
  }, [selector, value ?? null]);

const state = (page) => page.call((viewer) => viewer.state());
const view = (page) => page.call((viewer) => viewer.view());
const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

async function drag(page, [x, y], [right, down], button = "left") {
  const event = (type, at, buttons) =>
    page.ask("Input.dispatchMouseEvent", { type, x: at[0], y: at[1], button, buttons, clickCount: 1 });
  const buttons = button === "left" ? 1 : 2;
  await event("mousePressed", [x, y], buttons);
  await event("mouseMoved", [x + right, y + down], buttons);
  await event("mouseReleased", [x + right, y + down], 0);
}

async function press(page, key, code, milliseconds = 0) {
  await page.ask("Input.dispatchKeyEvent", { type: "keyDown", key, code, text: key.length === 1 ? key : undefined });
  await new Promise((done) => setTimeout(done, milliseconds));
  await page.ask("Input.dispatchKeyEvent", { type: "keyUp", key, code });
}

async function cornell(page) {
  const size = statSync(file("box.html")).size;
  assert.ok(size <= LARGEST, `${size} bytes`);
  const text = readFileSync(file("box.html"), "utf8");
  assert.doesNotMatch(text, /https?:|\bsrc=|\bhref=|@import|url\(/, "the page names no address");
  told(`${size} bytes, no address`);

  await page.call((viewer) => viewer.size([512, 512]));
  const same = await difference(page, "box.png");
  assert.ok(same < 0.01, `the picture differs by ${same}`);
  told(`the picture differs from that of render by ${(100 * same).toFixed(2)} % (rms)`);

  await page.call((viewer) => viewer.set({ exposure: 3, tone: "linear" }));
  const exposed = await difference(page, "exposed.png");
  assert.ok(exposed < 0.01, `exposed, the picture differs by ${exposed}`);
  told(`at the exposure 3 it differs by ${(100 * exposed).toFixed(2)} %`);

  await page.call((viewer) => viewer.set({ quantity: "irradiance", falseColours: true }));
  const colours = await difference(page, "false.png");
  const legend = await page.call(() => [...document.querySelectorAll(".ticks span")].map((mark) => mark.textContent));
  assert.ok(colours < 0.02, `false colours differ by ${colours}`);
  assert.ok(legend.length >= 3 && legend[0] === "0", `legend: ${legend}`);
  told(`false colours differ by ${(100 * colours).toFixed(2)} %, legend ${legend.join(" ")}`);

  await page.call((viewer) => viewer.set({ falseColours: false, quantity: "radiosity", band: 1 }));
  assert.ok(await page.call(async (viewer) => {
    const image = new Image();
    image.src = viewer.picture();
    await image.decode();
    const pen = new OffscreenCanvas(512, 512).getContext("2d");
    pen.drawImage(image, 0, 0);
    const { data } = pen.getImageData(0, 0, 512, 512);
    return data.every((code, k) => k % 4 === 3 || code === data[k - (k % 4)]) && data.some((code, k) => k % 4 === 0 && code > 50);
  }), "one band is grey");
  told("one band is a grey picture");

  await page.call((viewer) => viewer.set({ band: null, tone: "shoulder" }));
  await page.call((viewer) => viewer.size([320, 240]));
  const normals = { floor: [0, 1, 0], ceiling: [0, -1, 0], back_wall: [0, 0, -1] };
  told(await probed(page, "box.json", normals));

  const frame = await page.call((viewer) => {
    viewer.size([640, 360]);
    viewer.frameTime(10);
    return viewer.frameTime(60);
  });
  console.log(`640x360 by the processor: ${(1000 / frame).toFixed(1)} frames/s (wanted: ${WANTED} on two quiet cores)`);
  assert.ok(1000 / frame > FLOOR, `${1000 / frame} frames/s`);
  await page.call((viewer) => viewer.home());
  await page.call((viewer) => viewer.size(null));
  await controls(page);
  assert.deepEqual(page.faults, []);
  assert.ok(page.requests.every((url) => /^(file|blob|data):/.test(url)), `requests: ${page.requests}`);
}

async function everyShape(page) {
  await page.call((viewer) => viewer.size([400, 300]));
  const same = await difference(page, "shapes.png");
  assert.ok(same < 0.02, `the picture differs by ${same}`);
  told(`every shape: the picture differs by ${(100 * same).toFixed(2)} %`);
  assert.deepEqual(page.faults, []);
}

async function controls(page) {
  const start = await view(page);
  await drag(page, [300, 300], [60, 10]);
  const around = await view(page);
  near(distance(around.eye, around.target), distance(start.eye, start.target), 1e-6, "distance in orbit");
  assert.ok(distance(around.eye, start.eye) > 10 && distance(around.target, start.target) < 1e-3, "a drag orbits");
  await drag(page, [300, 300], [40, 0], "right");
  assert.ok(distance((await view(page)).target, around.target) > 10, "the right button moves");
  const before = await view(page);
  await page.ask("Input.dispatchMouseEvent", { type: "mouseWheel", x: 300, y: 300, deltaX: 0, deltaY: -200 });
  await new Promise((done) => setTimeout(done, 100));
  const closer = await view(page);
  assert.ok(distance(closer.eye, closer.target) < 0.9 * distance(before.eye, before.target), "the wheel approaches");
  await use(page, "#start");
  assert.ok(distance((await view(page)).eye, start.eye) < 1e-6, "the start view comes back");

  await use(page, '[name="mode"][value="walk"]');
  assert.equal((await state(page)).mode, "walk");
  await press(page, "w", "KeyW", 300);
  await new Promise((done) => setTimeout(done, 100));
  const walked = await view(page);
  assert.ok(walked.eye[2] > start.eye[2] + 1 && Math.abs(walked.eye[1] - start.eye[1]) < 1e-6, "W walks on the level");
  await drag(page, [300, 300], [50, 0]);
  const turned = await view(page);
  assert.ok(distance(turned.eye, walked.eye) < 1e-9 && distance(turned.target, walked.target) > 10, "a drag looks around");
  await page.call((viewer) => viewer.walk(0, 5, 2));
  near(distance((await view(page)).eye, turned.eye), Math.hypot(5, 2), 1e-6, "a step");
  await press(page, "r", "KeyR");

  await use(page, "#exposure", 1);
  const { exposure } = await state(page);
  await press(page, "+", "Equal");
  near((await state(page)).exposure, exposure * 2 ** 0.25, 1e-9, "exposure by key");
  await use(page, "#expose");
  assert.notEqual((await state(page)).exposure, exposure);
  await use(page, "#shoulder");
  assert.equal((await state(page)).tone, "linear");
  await use(page, "#backs");
  assert.equal((await state(page)).backs, false);
  await use(page, "#quantity", "irradiance");
  await use(page, "#band", "2");
  await use(page, '[name="style"][value="falseColours"]');
  await use(page, "#log");
  const scaled = await state(page);
  assert.ok(scaled.quantity === "irradiance" && scaled.band === 2 && scaled.falseColours && scaled.log && scaled.range[0] > 0);
  await use(page, "#low", scaled.range[0] * 2);
  near((await state(page)).range[0], scaled.range[0] * 2, 1e-6, "the lower end");
  await use(page, "#fit");
  assert.deepEqual((await state(page)).range, scaled.range);
  await press(page, "f", "KeyF");
  assert.equal((await state(page)).falseColours, false);
  for (const [changes, message] of [
    ["{ band: 7 }", "index below 3"], ["{ exposure: -1 }", "above 0"], ["{ colour: 1 }", "known are mode"],
    ["{ range: [2, 1] }", "ascend"], ["{ groups: { moon: 1 } }", "known are none"],
    ["{ band: 'length' }", "index below 3"], ["{ band: 0.5 }", "index below 3"], ["{ range: 5 }", "ascend"],
    ["{ range: [1, 2, 3] }", "ascend"], ["{ toString: 1 }", "known are mode"], ["{ groups: { toString: 1 } }", "known are none"],
    ["{ groups: null }", "names of groups"],
  ]) {
    const heard = await page.run(`window.radiosity.then((viewer) => { try { viewer.set(${changes}); return "taken"; } catch (error) { return error.message; } })`);
    assert.ok(heard.includes(message), `${changes}: ${heard}`);
  }
  await page.ask("Input.dispatchMouseEvent", { type: "mouseMoved", x: 400, y: 500 });
  const reading = await page.call(() => document.querySelector("#reading").textContent);
  assert.match(reading, /\(u, v\)[^]*E = R_620nm [\d.]+, .* W\/m²\nB = /);
  told("every control of camera, picture, exposure and scale; the reading under the pointer");
}

async function lamps(page) {
  assert.equal(await page.call(() => document.title), "Two <lamps> & a window");
  await page.call((viewer) => viewer.size([320, 240]));
  const same = await difference(page, "groups.png");
  assert.ok(same < 0.01, `the picture differs by ${same}`);
  const normals = {
    "room-bottom": [0, 0, 1], "room-top": [0, 0, -1], "room-back": [0, -1, 0], "room-left": [1, 0, 0], "room-right": [-1, 0, 0],
    "table-top": [0, 0, 1], "table-front": [0, -1, 0],
  };
  told(`groups: the picture differs by ${(100 * same).toFixed(2)} %; ${await probed(page, "groups.json", normals)}`);
  assert.deepEqual(await page.call((viewer) => viewer.scene.groups.sort()), ["lamps", "spot"]);
  await use(page, '[aria-label="Factor of light group lamps"]', 0.3);
  await use(page, '[aria-label="Factor of light group spot"]', 2);
  assert.deepEqual((await state(page)).groups, { lamps: 0.3, spot: 2 });
  told(`dimmed: ${await probed(page, "groups.json", normals, ["lamps=0.3", "spot=2"])}`);
  await page.call((viewer) => viewer.size(null));
  await page.call((viewer) => viewer.set({ quantity: "irradiance", falseColours: true, groups: { lamps: 1 } }));
  await page.ask("Input.dispatchMouseEvent", { type: "mouseMoved", x: 430, y: 330 });
  await page.call((viewer) => viewer.picture());
  writeFileSync(join(pictures, "viewer.png"), await page.screenshot());
  assert.deepEqual(page.faults, []);
}

write();
for (const [name, act] of [["box.html", cornell], ["groups.html", lamps], ["shapes.html", everyShape]]) {
  await Page.within(pathToFileURL(file(name)).href, [900, 600], act);
}
