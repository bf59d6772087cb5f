// The panel: controls that change what the viewer shows, the legend, and the reading under the pointer.

/** Greatest factor of a group that its slider offers, at the least. */
const BRIGHTEST = 2;

const element = (id) => document.getElementById(id);

class Panel {
  constructor(viewer) {
    this.viewer = viewer;
    this.header = viewer.header;
    this.offerChoices();
    this.offerGroups();
    this.listen();
    viewer.listeners.push(() => this.update());
    this.update();
  }

  offerChoices() {
    const { bands, irradiance, unit } = this.header;
    const option = (value, text) => Object.assign(document.createElement("option"), { value, textContent: text });
    element("quantity").append(option("radiosity", "radiosity B"), option("irradiance", `${irradiance} E`));
    const all = bands.length === 1 ? bands[0] : bands.length === 3 ? "all bands" : "mean of bands";
    element("band").append(option("", all));
    if (bands.length > 1) element("band").append(...bands.map((band, index) => option(index, band)));
    element("unit").textContent = unit;
  }

  offerGroups() {
    const groups = Object.entries(this.viewer.state.groups);
    element("groups").hidden = groups.length === 0;
    this.sliders = groups.map(([group, factor]) => {
      const slider = Object.assign(document.createElement("input"), { type: "range", min: 0, step: 0.01 });
      slider.max = Math.max(BRIGHTEST, 2 * factor);
      slider.setAttribute("aria-label", `Factor of light group ${group}`);
      const name = Object.assign(document.createElement("span"), { className: "name", textContent: group, title: group });
      const shown = document.createElement("output");
      const label = Object.assign(document.createElement("label"), { className: "row" });
      label.append(name, slider, shown);
      element("groups").append(label);
      slider.addEventListener("input", () => this.viewer.set({ groups: { [group]: slider.valueAsNumber } }));
      return { group, slider, shown };
    });
  }

  listen() {
    const { viewer } = this;
    const on = (id, event, act) => element(id).addEventListener(event, act);
    on("panel", "change", ({ target }) => {
      if (target.name === "mode") viewer.set({ mode: target.value, backs: target.value === "walk" });
      if (target.name === "style") viewer.set({ falseColours: target.value === "falseColours" });
    });
    document.querySelector("form").addEventListener("submit", (event) => event.preventDefault());
    on("start", "click", () => this.home());
    on("backs", "change", ({ target }) => viewer.set({ backs: target.checked }));
    on("quantity", "change", ({ target }) => viewer.set({ quantity: target.value }));
    on("band", "change", ({ target }) => viewer.set({ band: target.value === "" ? null : Number(target.value) }));
    on("exposure", "input", ({ target }) => viewer.set({ exposure: this.header.automatic * 2 ** target.valueAsNumber }));
    on("shoulder", "change", ({ target }) => viewer.set({ tone: target.checked ? "shoulder" : "linear" }));
    on("log", "change", ({ target }) => viewer.set({ log: target.checked }));
    for (const id of ["expose", "fit"]) on(id, "click", () => viewer.fit());
    for (const id of ["low", "high"]) on(id, "change", ({ target }) => this.rescale(target));
  }

  /** Takes the ends of the scale as typed. */
  rescale(input) {
    input.setCustomValidity("");
    try {
      this.viewer.set({ range: [element("low").valueAsNumber, element("high").valueAsNumber] });
    } catch (error) {
      input.setCustomValidity(error.message);
      input.reportValidity();
    }
  }

  /** Back to the view that the page opened with. */
  home() {
    this.viewer.camera.look(this.header.camera);
    this.viewer.changed();
  }

  /** Shows what the viewer shows. */
  update() {
    const { state } = this.viewer;
    document.querySelector(`[name="mode"][value="${state.mode}"]`).checked = true;
    const style = state.falseColours ? "falseColours" : "photograph";
    document.querySelector(`[name="style"][value="${style}"]`).checked = true;
    element("photograph").hidden = state.falseColours;
    element("colours").hidden = element("legend").hidden = !state.falseColours;
    element("backs").checked = state.backs;
    element("quantity").value = state.quantity;
    element("band").value = state.band ?? "";
    const stops = Math.log2(state.exposure / this.header.automatic);
    element("exposure").value = stops;
    element("stops").textContent = `${stops < 0 ? "−" : "+"}${Math.abs(stops).toFixed(1)}`;
    element("shoulder").checked = state.tone === "shoulder";
    for (const { group, slider, shown } of this.sliders) {
      slider.value = state.groups[group];
      shown.textContent = digits(state.groups[group], 3);
    }
    if (state.falseColours) this.updateScale();
  }

  updateScale() {
    const { header, viewer } = this;
    const { log, band, quantity } = viewer.state;
    const range = viewer.range();
    element("log").checked = log;
    [element("low").value, element("high").value] = range.map((x) => digits(x, 6));
    const name = quantity === "radiosity" ? quantity : header.irradiance;
    const bands = header.bands.length === 1 ? [] : [band === null ? "mean of bands" : header.bands[band]];
    drawLegend(element("legend"), { lines: [name, ...bands, header.unit], range, isLog: log, gradient: header.gradient });
  }

  /** Writes what is under the pointer. */
  read(reading) {
    if (!reading) {
      element("reading").textContent = "No front of a surface is here.";
      return;
    }
    const { bands, unit } = this.header;
    const { surface, u, v, position, irradiance, radiosity } = reading;
    const list = (values) => values.map((x, k) => (bands.length > 1 ? `${bands[k]} ${digits(x, 4)}` : digits(x, 4))).join(", ");
    element("reading").textContent =
      `${surface.name}   (u, v) = (${u.toFixed(3)}, ${v.toFixed(3)})   ` +
      `(x, y, z) = (${position.map((x) => digits(x, 5)).join(", ")})\n` +
      `E = ${list(irradiance)} ${unit}\nB = ${list(radiosity)} ${unit}`;
  }
}
