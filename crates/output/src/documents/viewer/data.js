// The numbers of the page, as src/output/viewer/packing.rs writes them.

/** The bytes that a script element holds, deflated and in Base64. */
async function inflated(id) {
  const text = atob(document.getElementById(id).textContent.trim());
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Response(stream).arrayBuffer();
}

/** The number that the 16 bits of IEEE 754 half precision stand for, at least 0. */
function half(bits) {
  const exponent = bits >> 10;
  const fraction = bits & 0x3ff;
  return exponent === 0 ? fraction * 2 ** -24 : (1024 + fraction) * 2 ** (exponent - 25);
}

/** Irradiance of each surface: one array for each pair of a part and a band, part by part. */
function unpackedLight(bytes, { surfaces, parts, bands, scale }) {
  const all = new Uint8Array(bytes);
  const count = all.length / 2;
  let next = 0;
  const plane = ([columns, rows]) => {
    const values = new Float32Array(columns * rows);
    let first = 0;
    for (let row = 0; row < rows; row++) {
      let before = first;
      for (let column = 0; column < columns; column++, next++) {
        before = (before + all[next] + 256 * all[count + next]) & 0xffff;
        if (column === 0) first = before;
        values[row * columns + column] = scale * half(before);
      }
    }
    return values;
  };
  return surfaces.map(({ texels }) => Array.from({ length: parts.length * bands.length }, () => plane(texels)));
}

/** Corners of all triangles: positions, parameters, and for each surface the triangles' corners, counted over all. */
function unpackedShape(bytes, { surfaces }) {
  const corners = surfaces.reduce((sum, surface) => sum + surface.corners, 0);
  const triangles = surfaces.reduce((sum, surface) => sum + surface.triangles, 0);
  const positions = new Float32Array(bytes, 0, 3 * corners);
  const parameters = new Float32Array(bytes, 12 * corners, 2 * corners);
  const indices = new Uint32Array(bytes, 20 * corners, 3 * triangles);
  let [corner, index] = [0, 0];
  const ranges = surfaces.map((surface) => {
    const range = { corner, index, corners: surface.corners, indices: 3 * surface.triangles };
    for (let k = 0; k < range.indices; k++) indices[index + k] += corner;
    corner += range.corners;
    index += range.indices;
    return range;
  });
  return { positions, parameters, indices, ranges };
}
