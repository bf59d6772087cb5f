// Shapes: the triangles of all surfaces, and what a ray meets first.

class Shape {
  constructor(unpacked) {
    Object.assign(this, unpacked);
    this.boxes = this.ranges.map(({ corner, corners }) => {
      const box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
      for (let k = corner; k < corner + corners; k++) {
        for (let axis = 0; axis < 3; axis++) {
          box.low[axis] = Math.min(box.low[axis], this.positions[3 * k + axis]);
          box.high[axis] = Math.max(box.high[axis], this.positions[3 * k + axis]);
        }
      }
      return box;
    });
    const filled = this.boxes.filter((box) => box.low[0] <= box.high[0]);
    this.low = [0, 1, 2].map((axis) => Math.min(...filled.map((box) => box.low[axis])));
    this.high = [0, 1, 2].map((axis) => Math.max(...filled.map((box) => box.high[axis])));
    this.diagonal = length(minus(this.high, this.low));
  }

  /** Whether a point lies in the box around the scene. */
  holds(point) {
    return point.every((x, axis) => x > this.low[axis] && x < this.high[axis]);
  }

  corner(index) {
    return [this.positions[3 * index], this.positions[3 * index + 1], this.positions[3 * index + 2]];
  }

  /** The nearest front or, where backs are shown, back that a ray meets: {distance, surface, front, u, v, position}. */
  nearest(origin, direction, showsBacks) {
    let best = null;
    this.ranges.forEach(({ index, indices }, surface) => {
      if (!meetsBox(this.boxes[surface], origin, direction)) return;
      for (let k = index; k < index + indices; k += 3) {
        const hit = this.meetTriangle(k, origin, direction);
        if (hit && (hit.front || showsBacks) && (!best || hit.distance < best.distance)) best = { ...hit, surface };
      }
    });
    return best && { ...best, position: add(origin, times(best.distance, direction)) };
  }

  /** By the way of Moller and Trumbore, Fast, minimum storage ray/triangle intersection, 1997. */
  meetTriangle(first, origin, direction) {
    const own = [this.indices[first], this.indices[first + 1], this.indices[first + 2]];
    const [a, b, c] = own.map((index) => this.corner(index));
    const [ab, ac] = [minus(b, a), minus(c, a)];
    const p = cross(direction, ac);
    const determinant = dot(ab, p);
    if (determinant === 0) return null;
    const from = minus(origin, a);
    const s = dot(from, p) / determinant;
    const q = cross(from, ab);
    const t = dot(direction, q) / determinant;
    const distance = dot(ac, q) / determinant;
    if (s < 0 || t < 0 || s + t > 1 || distance <= 0) return null;
    const mean = (axis) =>
      (1 - s - t) * this.parameters[2 * own[0] + axis] +
      s * this.parameters[2 * own[1] + axis] +
      t * this.parameters[2 * own[2] + axis];
    return { distance, front: determinant > 0, u: mean(0), v: mean(1) };
  }
}

/** Whether a ray meets a box: by the slabs between its faces. */
function meetsBox({ low, high }, origin, direction) {
  let [enter, leave] = [0, Infinity];
  for (let axis = 0; axis < 3; axis++) {
    if (direction[axis] === 0) {
      if (origin[axis] < low[axis] || origin[axis] > high[axis]) return false;
      continue;
    }
    const one = (low[axis] - origin[axis]) / direction[axis];
    const other = (high[axis] - origin[axis]) / direction[axis];
    enter = Math.max(enter, Math.min(one, other));
    leave = Math.min(leave, Math.max(one, other));
  }
  return enter <= leave * (1 + 1e-6);
}
