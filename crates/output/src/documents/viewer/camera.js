// The camera: a pinhole that goes around a point, or walks.

/** Greatest angle of the view above and below the horizon. */
const STEEPEST = (89.5 * Math.PI) / 180;

class Camera {
  /** `start` as in the header; `shape` tells how far away the camera may go. */
  constructor(start, shape) {
    this.start = start;
    this.shape = shape;
    this.up = unit(start.up);
    const side = Math.abs(this.up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    this.north = unit(minus(side, times(dot(side, this.up), this.up)));
    this.east = cross(this.north, this.up);
    this.look(start);
  }

  /** Looks from `eye` to `target` with the vertical angle `fov` in degrees; what is not given stays. */
  look({ eye = this.eye, target = this.target, fov = this.fov } = {}) {
    this.eye = eye;
    this.fov = clamp(fov, 1, 170);
    const view = minus(target, eye);
    this.distance = Math.max(length(view), 1e-6 * this.shape.diagonal);
    this.yaw = Math.atan2(dot(view, this.east), dot(view, this.north));
    this.pitch = Math.asin(clamp(dot(view, this.up) / this.distance, -1, 1));
  }

  /** Unit vector of the view. */
  get forward() {
    const level = add(times(Math.cos(this.yaw), this.north), times(Math.sin(this.yaw), this.east));
    return add(times(Math.cos(this.pitch), level), times(Math.sin(this.pitch), this.up));
  }

  /** The point that the camera looks at and goes around. */
  get target() {
    return add(this.eye, times(this.distance, this.forward));
  }

  get right() {
    return unit(cross(this.forward, this.up));
  }

  /** Turns the view by angles to the right and up, where it stands. */
  turn(right, up) {
    this.yaw += right;
    this.pitch = clamp(this.pitch + up, -STEEPEST, STEEPEST);
  }

  /** Goes around the target. */
  orbit(right, up) {
    const target = this.target;
    this.turn(right, up);
    this.eye = minus(target, times(this.distance, this.forward));
  }

  /** Goes nearer to the target, or away from it, by a factor on the distance. */
  approach(factor) {
    const target = this.target;
    this.distance = clamp(factor * this.distance, 1e-3 * this.shape.diagonal, 20 * this.shape.diagonal);
    this.eye = minus(target, times(this.distance, this.forward));
  }

  /** Moves the camera and its target within the picture. */
  pan(right, up) {
    const above = cross(this.right, this.forward);
    this.step(add(times(right, this.right), times(up, above)));
  }

  /** Walks: to the front and to the right on the level, and up. */
  walk(front, right, up) {
    const ahead = unit(cross(this.up, this.right));
    this.step(add(add(times(front, ahead), times(right, this.right)), times(up, this.up)));
  }

  /** Moves, not too far from the scene. */
  step(offset) {
    const { low, high, diagonal } = this.shape;
    this.eye = add(this.eye, offset).map((x, axis) => clamp(x, low[axis] - 20 * diagonal, high[axis] + 20 * diagonal));
  }

  /** Tangents of half the angles of view, across and up: the start's picture is seen whole in any window. */
  tangents([width, height]) {
    const up = Math.tan((this.fov * Math.PI) / 360);
    const [aspect, own] = [width / height, this.start.width / this.start.height];
    return aspect >= own ? [up * aspect, up] : [up * own, (up * own) / aspect];
  }

  /** Direction of the ray through a point of a picture, in pixels from its upper left corner. */
  ray([x, y], size) {
    const [across, up] = this.tangents(size);
    const above = cross(this.right, this.forward);
    const [a, b] = [across * ((2 * x) / size[0] - 1), up * (1 - (2 * y) / size[1])];
    return add(this.forward, add(times(a, this.right), times(b, above)));
  }

  /** The matrix of WebGL, column by column; `shift` moves the picture by parts of a pixel. */
  matrix(size, shift) {
    const [across, up] = this.tangents(size);
    const [right, forward] = [this.right, this.forward];
    const above = cross(right, forward);
    const middle = times(0.5, add(this.shape.low, this.shape.high));
    const far = length(minus(this.eye, middle)) + this.shape.diagonal;
    const near = Math.max(2e-4 * this.shape.diagonal, far - 3 * this.shape.diagonal);
    const rows = [times(1 / across, right), times(1 / up, above), times((far + near) / (far - near), forward), forward];
    const ends = rows.map((row) => -dot(row, this.eye));
    ends[2] -= (2 * far * near) / (far - near);
    // A shift of the picture is proportional to depth, the last row.
    const moved = [(2 * shift[0]) / size[0], (2 * shift[1]) / size[1]];
    for (let k = 0; k < 2; k++) {
      rows[k] = add(rows[k], times(moved[k], rows[3]));
      ends[k] += moved[k] * ends[3];
    }
    return [0, 1, 2].flatMap((axis) => rows.map((row) => row[axis])).concat(ends);
  }
}
