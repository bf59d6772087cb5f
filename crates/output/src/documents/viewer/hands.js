// Hands: pointers, the wheel and keys move the camera.

/** Radians of a turn for each pixel of a drag; seconds to cross the scene on foot. */
const TURN = 0.005;
const CROSSING = 6;

/** Factor on the distance for each pixel of the wheel. */
const WHEEL = 1.001;

class Hands {
  /** `wake` is called whenever there is something to draw. */
  constructor(canvas, viewer, panel, wake) {
    Object.assign(this, { canvas, viewer, panel, wake, pointers: new Map(), keys: new Set() });
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const name of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(name, (event) => this.pointers.delete(event.pointerId));
    }
    canvas.addEventListener("wheel", (event) => this.roll(event), { passive: false });
    canvas.addEventListener("dblclick", (event) => this.pivot(event));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    window.addEventListener("keydown", (event) => this.key(event));
    window.addEventListener("keyup", (event) => this.keys.delete(event.code));
    window.addEventListener("blur", () => this.keys.clear());
  }

  get isOrbit() {
    return this.viewer.state.mode === "orbit";
  }

  /** Pixels of the picture for the place of an event. */
  place({ clientX, clientY }) {
    const scale = this.canvas.width / this.canvas.clientWidth;
    return [clientX * scale, clientY * scale];
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus();
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      this.panel.read(this.viewer.at(...this.place(event)));
      return;
    }
    const spread = this.spread();
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const [right, down] = [event.clientX - before[0], event.clientY - before[1]];
    if (this.pointers.size > 1) this.pinch(right, down, this.spread() / spread);
    else if (event.buttons & 2 || event.shiftKey) this.pan(right, down);
    else this.turn(right, down);
    this.moved();
  }

  turn(right, down) {
    const { camera } = this.viewer;
    if (this.isOrbit) camera.orbit(TURN * right, -TURN * down);
    else camera.turn(-TURN * right, TURN * down);
  }

  pan(right, down) {
    const { camera } = this.viewer;
    const pixel = (2 * camera.distance * camera.tangents(this.viewer.drawing.size)[1]) / this.canvas.clientHeight;
    camera.pan(-pixel * right, pixel * down);
  }

  /** Two fingers: `right` and `down` of one of them, and the factor on their distance. */
  pinch(right, down, factor) {
    const { camera } = this.viewer;
    if (this.isOrbit) {
      this.pan(0.5 * right, 0.5 * down);
      camera.approach(1 / clamp(factor, 0.5, 2));
    } else {
      const pixel = this.viewer.shape.diagonal / 1000;
      camera.walk(-pixel * down, -pixel * right, 0);
    }
  }

  /** The distance of the first two pointers. */
  spread() {
    const [a, b] = [...this.pointers.values()];
    return b ? Math.max(Math.hypot(a[0] - b[0], a[1] - b[1]), 1) : 1;
  }

  roll(event) {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1);
    const { camera, shape } = this.viewer;
    if (this.isOrbit) camera.approach(WHEEL ** pixels);
    else camera.walk((-pixels * shape.diagonal) / 4000, 0, 0);
    this.moved();
  }

  /** The point under the pointer becomes the one that the camera goes around. */
  pivot(event) {
    const reading = this.viewer.at(...this.place(event));
    if (!reading) return;
    this.viewer.camera.look({ target: minus(reading.position, this.viewer.header.middle) });
    this.moved();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("select, input:not([type=checkbox])")) return;
    const { viewer } = this;
    const { state } = viewer;
    const acts = {
      KeyO: () => viewer.set({ mode: "orbit", backs: false }),
      KeyV: () => viewer.set({ mode: "walk", backs: true }),
      KeyR: () => this.panel.home(),
      KeyF: () => viewer.set({ falseColours: !state.falseColours }),
      KeyX: () => viewer.fit(),
      KeyH: () => (element("panel").open = element("help").open = !element("help").open),
    };
    if (event.key === "+" || event.key === "=") viewer.set({ exposure: state.exposure * 2 ** 0.25 });
    else if (event.key === "-") viewer.set({ exposure: state.exposure / 2 ** 0.25 });
    else if (event.code in acts) acts[event.code]();
    else {
      if (event.code.startsWith("Arrow")) event.preventDefault();
      this.keys.add(event.code);
    }
    this.isFast = event.shiftKey;
    this.wake();
  }

  /** Moves by the keys that are held for so many seconds; whether any was. */
  hold(seconds) {
    const held = (...codes) => (codes.some((code) => this.keys.has(code)) ? 1 : 0);
    const front = held("KeyW", "ArrowUp") - held("KeyS", "ArrowDown");
    const aside = held("KeyD") - held("KeyA");
    const turn = held("ArrowRight") - held("ArrowLeft");
    const up = held("KeyE") - held("KeyQ");
    if (!front && !aside && !turn && !up) return false;
    const { camera, shape } = this.viewer;
    const step = (seconds * shape.diagonal * (this.isFast ? 3 : 1)) / CROSSING;
    if (this.isOrbit) {
      camera.orbit(seconds * (turn + aside), seconds * up);
      camera.approach(Math.exp(-seconds * front));
    } else {
      camera.turn(1.5 * seconds * turn, 0);
      camera.walk(step * front, step * aside, step * up);
    }
    this.viewer.drawing.restart();
    return true;
  }

  moved() {
    this.viewer.drawing.restart();
    this.wake();
  }
}
