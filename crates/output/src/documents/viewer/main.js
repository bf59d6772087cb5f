// The page: opens, draws when something changed, and offers `window.radiosity` to scripts.

/** Longest time between two frames that keys move the camera for (seconds). */
const LONGEST = 0.1;

async function open() {
  const canvas = element("picture");
  const header = JSON.parse(element("header").textContent);
  const most = context(canvas).getParameter(WebGL2RenderingContext.MAX_TEXTURE_SIZE);
  const shape = new Shape(unpackedShape(await inflated("shape"), header));
  const light = new Light(header, unpackedLight(await inflated("light"), header), most);
  if (!light.fits) throw new Error("the light of this scene is more than this graphics device holds in one texture");
  const drawing = new Drawing(canvas, header, shape, light);
  let fixed = null;
  const size = () => fixed ?? [canvas.clientWidth, canvas.clientHeight].map((side) => Math.max(1, Math.round(side * window.devicePixelRatio)));
  drawing.resize(size());
  const viewer = new Viewer(header, shape, light, drawing);
  const panel = new Panel(viewer);
  const loop = new Loop(viewer, () => drawing.resize(size()));
  const hands = new Hands(canvas, viewer, panel, () => loop.wake());
  loop.hands = hands;
  viewer.listeners.push(() => loop.wake());
  new ResizeObserver(() => loop.wake()).observe(canvas);
  loop.wake();
  const resized = (sides) => {
    fixed = sides;
    drawing.resize(size());
    loop.wake();
  };
  return api(viewer, panel, loop, resized);
}

/** Draws a frame for the screen's next one, as long as there is something to draw. */
class Loop {
  constructor(viewer, prepare) {
    Object.assign(this, { viewer, prepare, hands: null, asked: false, last: 0 });
  }

  wake() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.asked = false;
    this.prepare();
    const isMoving = this.hands.hold(Math.min((now - this.last) / 1000, LONGEST));
    this.last = now;
    if (!this.viewer.drawing.isComplete) this.viewer.draw();
    if (isMoving || !this.viewer.drawing.isComplete) this.wake();
  }
}

/** What scripts can do. */
function api(viewer, panel, loop, resized) {
  const { camera, drawing, header } = viewer;
  const moved = (move) => (...numbers) => {
    move(...numbers);
    viewer.changed();
  };
  const finish = () => {
    while (!drawing.isComplete) viewer.draw();
  };
  return {
    /** What the page is about: names of surfaces, bands, groups, the unit. */
    scene: {
      title: header.title,
      unit: header.unit,
      bands: header.bands,
      surfaces: header.surfaces.map((surface) => surface.name),
      groups: Object.keys(viewer.state.groups),
    },
    /** What is shown: mode, backs, quantity, band (index or null), falseColours, log, range, exposure (factor on the
     * quantity), tone, groups (factors by name). */
    state: () => structuredClone({ ...viewer.state, range: viewer.range() }),
    /** Changes what is named, keys as in state(). */
    set: (changes) => viewer.set(changes),
    /** Chooses exposure or scale for this view. */
    fit: () => viewer.fit(),
    /** The camera: {eye, target, fov} in the coordinates of the scene, degrees. */
    view: () => ({ eye: add(camera.eye, header.middle), target: add(camera.target, header.middle), fov: camera.fov }),
    look: moved(({ eye, target, fov } = {}) =>
      camera.look({ eye: eye && minus(eye, header.middle), target: target && minus(target, header.middle), fov })),
    /** Back to the view that the page opened with. */
    home: () => panel.home(),
    /** Goes around the target by angles to the right and up (radians). */
    orbit: moved((right, up) => camera.orbit(right, up)),
    /** Turns the view where it stands (radians). */
    turn: moved((right, up) => camera.turn(right, up)),
    /** Walks to the front, to the right and up (scene length). */
    walk: moved((front, right, up) => camera.walk(front, right, up)),
    /** Fixes the pixels of the picture, [width, height]; null: those of the window. */
    size: (sides) => resized(sides),
    /** What is at a pixel (x, y) from the upper left corner: {surface: {index, name}, position, u, v, irradiance, radiosity};
     * null where no front is. */
    at: (x, y) => viewer.at(x, y),
    /** The finished picture as the URL of a PNG. */
    picture: () => {
      finish();
      return drawing.canvas.toDataURL("image/png");
    },
    /** Mean time of a frame while the camera goes around once in `count` of them (ms). */
    frameTime: (count) => {
      const start = performance.now();
      for (let k = 0; k < count; k++) {
        camera.orbit((2 * Math.PI) / count, 0);
        drawing.restart();
        viewer.draw();
        drawing.finish();
      }
      loop.wake();
      return (performance.now() - start) / count;
    },
  };
}

/** Resolves to what scripts can do, once the page is ready. */
window.radiosity = open();
window.radiosity.catch((error) => {
  element("fault").textContent = `The scene cannot be shown: ${error.message}`;
  element("fault").hidden = false;
});
