// Light: the textures of all surfaces in one atlas, at the factors of their groups.

/** Numbers of a texel of the atlas, and the greatest: the range of half precision. */
const CHANNELS = 4;
const GREATEST = 6e4;

class Light {
  /** `planes` as unpackedLight returns them; textures stand on shelves of an atlas at most `most` texels broad. */
  constructor(header, planes, most) {
    this.header = header;
    this.planes = planes;
    this.factors = header.parts.map((part) => part.factor);
    this.place(most);
    this.atlas = new Float32Array(this.width * this.height * CHANNELS);
  }

  /** Gives each texture its place, the highest ones first. */
  place(most) {
    const sizes = this.header.surfaces.map((surface) => surface.texels);
    const area = sizes.reduce((sum, [columns, rows]) => sum + columns * rows, 0);
    const broadest = Math.max(...sizes.map(([columns]) => columns));
    this.width = Math.min(most, Math.max(broadest, Math.ceil(Math.sqrt(1.1 * area))));
    const order = sizes.map((_, surface) => surface).sort((a, b) => sizes[b][1] - sizes[a][1]);
    this.places = [];
    let [x, y, shelf] = [0, 0, 0];
    for (const surface of order) {
      const [columns, rows] = sizes[surface];
      if (x + columns > this.width) [x, y, shelf] = [0, y + shelf, 0];
      this.places[surface] = [x, y];
      x += columns;
      shelf = Math.max(shelf, rows);
    }
    this.height = y + shelf;
    this.fits = this.height <= most;
  }

  /** Where (u, v) of a surface lies in the atlas, in [0, 1]: centres of texels span [-1, 1]. */
  inAtlas(surface, u, v) {
    const [columns, rows] = this.header.surfaces[surface].texels;
    const [x, y] = this.places[surface];
    return [
      (x + 0.5 + 0.5 * (1 + u) * (columns - 1)) / this.width,
      (y + 0.5 + 0.5 * (1 + v) * (rows - 1)) / this.height,
    ];
  }

  /** E0 of a surface in a band, at the factor of its group. */
  emitted(surface, band) {
    const { part, emission } = this.header.surfaces[surface];
    return (part === null ? 1 : this.factors[part]) * emission[band];
  }

  /** Whether a surface emits at the present factors. */
  emits(surface) {
    return this.header.bands.some((_, band) => this.emitted(surface, band) > 0);
  }

  /** Fills the atlas: `quantity` is "radiosity" or "irradiance"; of three bands times `weights` come three colours, otherwise
   * the weighted sum of all bands comes three times. */
  fill(quantity, weights, isColour) {
    this.header.surfaces.forEach(({ texels, reflectance }, surface) => {
      const colours = weights.map((weight, band) => this.shown(surface, band, quantity, weight, reflectance[band]));
      const [left, top] = this.places[surface];
      const [columns, rows] = texels;
      for (let row = 0; row < rows; row++) {
        for (let column = 0; column < columns; column++) {
          const texel = row * columns + column;
          const at = CHANNELS * ((top + row) * this.width + left + column);
          if (isColour) {
            for (let k = 0; k < 3; k++) this.atlas[at + k] = Math.min(colours[k][texel], GREATEST);
          } else {
            let sum = 0;
            for (const colour of colours) sum += colour[texel];
            this.atlas[at] = this.atlas[at + 1] = this.atlas[at + 2] = Math.min(sum, GREATEST);
          }
        }
      }
    });
    return this.atlas;
  }

  /** `weight` times a quantity of a surface in a band, at all texels. */
  shown(surface, band, quantity, weight, reflectance) {
    const [factor, base] = quantity === "radiosity" ? [reflectance, this.emitted(surface, band)] : [1, 0];
    const sum = new Float32Array(this.planes[surface][0].length).fill(weight * base);
    if (weight === 0) return sum;
    this.factors.forEach((own, part) => {
      const plane = this.planes[surface][part * this.header.bands.length + band];
      const share = weight * factor * own;
      if (share !== 0) for (let texel = 0; texel < sum.length; texel++) sum[texel] += share * plane[texel];
    });
    return sum;
  }

  /** Irradiance and radiosity per band at (u, v) of a surface, bilinear between texels. */
  at(surface, u, v) {
    const { texels, reflectance } = this.header.surfaces[surface];
    const [[i, s], [j, t]] = [u, v].map((x, axis) => {
      const place = 0.5 * (1 + clamp(x, -1, 1)) * (texels[axis] - 1);
      const first = Math.min(Math.floor(place), texels[axis] - 2);
      return [first, place - first];
    });
    const bands = this.header.bands.length;
    const irradiance = this.header.bands.map((_, band) =>
      this.factors.reduce((sum, factor, part) => {
        const plane = this.planes[surface][part * bands + band];
        const row = (k) => (1 - s) * plane[k * texels[0] + i] + s * plane[k * texels[0] + i + 1];
        return sum + factor * ((1 - t) * row(j) + t * row(j + 1));
      }, 0),
    );
    const radiosity = irradiance.map((e, band) => this.emitted(surface, band) + reflectance[band] * e);
    return { irradiance, radiosity };
  }
}
