// The viewer: what is shown, from where, and what is read.

/** Rays across and down that tell what a view holds. */
const SURVEY = [64, 40];

class Viewer {
  constructor(header, shape, light, drawing) {
    Object.assign(this, { header, shape, light, drawing, listeners: [] });
    this.camera = new Camera(header.camera, shape);
    this.state = {
      mode: shape.holds(header.camera.eye) ? "walk" : "orbit",
      backs: true,
      quantity: header.quantity,
      band: header.colours?.band ?? null,
      falseColours: header.colours !== null,
      log: header.colours?.log ?? false,
      range: header.colours?.range ?? null,
      exposure: header.exposure ?? header.automatic,
      tone: header.exposure === null ? "shoulder" : "linear",
      groups: Object.fromEntries(header.parts.filter((part) => part.group !== null).map((part) => [part.group, part.factor])),
    };
    this.refill();
  }

  /** Changes what is shown; keys as in `state`. Groups that are not named keep their factors. */
  set(changes) {
    for (const [key, value] of Object.entries(changes)) check(this, key, value);
    const groups = { ...this.state.groups, ...changes.groups };
    const { range, log } = { ...this.state, ...changes };
    if (changes.range && log && range[0] <= 0) throw new Error(`range: there is no logarithm of ${range[0]}`);
    const rescaled = ["quantity", "band", "falseColours", "log"].some((key) => key in changes);
    Object.assign(this.state, changes, { groups });
    if (rescaled && !changes.range) this.state.range = null;
    if (["quantity", "band", "falseColours", "groups"].some((key) => key in changes)) this.refill();
    this.changed();
  }

  /** Takes the light at the present factors of groups into the picture. */
  refill() {
    const { header, light, state } = this;
    header.parts.forEach((part, k) => {
      if (part.group !== null) light.factors[k] = state.groups[part.group];
    });
    const [weights, isColour] = this.weights();
    this.drawing.take(light.fill(state.quantity, weights.map((weight) => weight * header.automatic), isColour));
  }

  /** Factors on the bands, and whether three colours come of them. */
  weights() {
    const { bands, balance } = this.header;
    const { band, falseColours } = this.state;
    if (band !== null) return [bands.map((_, k) => (k === band ? 1 : 0)), false];
    if (bands.length === 3 && !falseColours) return [balance, true];
    return [bands.map(() => 1 / bands.length), false];
  }

  /** How numbers become colours. The light of the atlas is 1 where the automatic exposure makes it white. */
  look() {
    const { state, header } = this;
    const style = state.falseColours ? (state.log ? 3 : 2) : state.tone === "shoulder" ? 1 : 0;
    const range = this.range().map((x) => x * header.automatic);
    return { style, range, exposure: state.exposure / header.automatic, backs: state.backs, falseColours: state.falseColours };
  }

  /** The ends of the scale; chosen for the view where none are given. */
  range() {
    if (!this.state.falseColours) return [0, 1];
    if (!this.state.range) this.state.range = this.fitted();
    return this.state.range;
  }

  /** What the view holds: readings of its surfaces. */
  survey() {
    const size = this.drawing.size;
    const places = Array.from({ length: SURVEY[0] * SURVEY[1] }, (_, k) => [
      ((k % SURVEY[0]) + 0.5) * (size[0] / SURVEY[0]),
      (Math.floor(k / SURVEY[0]) + 0.5) * (size[1] / SURVEY[1]),
    ]);
    return places.map(([x, y]) => this.at(x, y)).filter(Boolean);
  }

  /** The range of a scale for this view: emitters count where there is nothing else. */
  fitted() {
    const [weights] = this.weights();
    const all = this.survey();
    const others = all.filter(({ surface }) => !this.light.emits(surface.index));
    const values = (others.length ? others : all).map((reading) =>
      reading[this.state.quantity].reduce((sum, x, band) => sum + weights[band] * x, 0),
    );
    return rangeFor(values.length ? percentiles(values, [0.02, 0.98]) : [0, 0], this.state.log);
  }

  /** Chooses the exposure, or the ends of the scale, for this view. */
  fit() {
    if (this.state.falseColours) return this.set({ range: this.fitted() });
    const [weights, isColour] = this.weights();
    const levels = (readings) => readings.map((reading) => {
      const colours = reading[this.state.quantity].map((x, band) => weights[band] * x);
      return isColour ? Math.max(...colours) : colours.reduce((sum, x) => sum + x, 0);
    }).filter((level) => level > 0);
    const all = this.survey();
    const others = levels(all.filter(({ surface }) => !this.light.emits(surface.index)));
    const lit = others.length ? others : levels(all);
    return this.set({ exposure: lit.length ? 1 / percentiles(lit, [0.98])[0] : this.header.automatic });
  }

  /** What is seen at a point of the picture, in pixels from its upper left corner; null where no front is. */
  at(x, y) {
    const direction = this.camera.ray([x, y], this.drawing.size);
    const hit = this.shape.nearest(this.camera.eye, direction, this.state.backs);
    if (!hit || !hit.front) return null;
    const surface = { index: hit.surface, name: this.header.surfaces[hit.surface].name };
    const position = add(hit.position, this.header.middle);
    return { surface, position, u: hit.u, v: hit.v, ...this.light.at(hit.surface, hit.u, hit.v) };
  }

  /** Tells all who listen, and begins the picture anew. */
  changed() {
    this.drawing.restart();
    this.listeners.forEach((listener) => listener());
  }

  /** Draws one more sample. */
  draw() {
    this.drawing.draw(this.camera, this.look());
  }
}

/** Refuses what cannot be shown. */
function check({ state, header }, key, value) {
  const refuse = (expected) => {
    throw new Error(`${key}: expected ${expected}, not ${JSON.stringify(value)}`);
  };
  const isNumber = (x) => typeof x === "number" && Number.isFinite(x);
  const choices = { mode: ["orbit", "walk"], quantity: ["radiosity", "irradiance"], tone: ["shoulder", "linear"] };
  if (!Object.hasOwn(state, key)) throw new Error(`${key}: known are ${Object.keys(state).join(", ")}`);
  if (Object.hasOwn(choices, key) && !choices[key].includes(value)) refuse(choices[key].join(" or "));
  if (["backs", "falseColours", "log"].includes(key) && typeof value !== "boolean") refuse("true or false");
  if (key === "exposure" && !(isNumber(value) && value > 0)) refuse("a number above 0");
  const { bands } = header;
  const isBand = Number.isInteger(value) && value >= 0 && value < bands.length;
  if (key === "band" && value !== null && !isBand) refuse(`null or an index below ${bands.length}`);
  const isRange = Array.isArray(value) && value.length === 2 && value.every(isNumber) && value[0] < value[1];
  if (key === "range" && value !== null && !isRange) refuse("null or two numbers that ascend");
  if (key !== "groups") return;
  if (typeof value !== "object" || value === null || Array.isArray(value)) refuse("factors by the names of groups");
  for (const [group, factor] of Object.entries(value)) {
    if (!Object.hasOwn(state.groups, group)) throw new Error(`groups: known are ${Object.keys(state.groups).join(", ") || "none"}`);
    if (!(isNumber(factor) && factor >= 0)) refuse("factors of 0 or more");
  }
}
