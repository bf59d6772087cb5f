// Drawing by WebGL 2: a sample of the scene, the mean of several while the camera stands still, and that on the screen.

class Drawing {
  constructor(canvas, header, shape, light) {
    this.canvas = canvas;
    this.gl = context(canvas);
    this.count = shape.indices.length;
    const { gl } = this;
    // Without this extension eight bits must do, which WebGL keeps as sRGB.
    this.format = gl.getExtension("EXT_color_buffer_float") ? gl.RGBA16F : gl.SRGB8_ALPHA8;
    this.surface = program(gl, "surface.vert", "surface.frag");
    this.screen = program(gl, "screen.vert", "screen.frag");
    this.corners(shape, light);
    this.light = texture(gl, gl.LINEAR);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA16F, light.width, light.height);
    this.extent = [light.width, light.height];
    this.gradient = texture(gl, gl.LINEAR);
    const colours = new Uint8Array(header.gradient.flatMap((colour) => [...colour, 255]));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, header.gradient.length, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colours);
    this.sampleAt(header.points);
  }

  /** The corners of all triangles with their places in the atlas, and the triangles. */
  corners(shape, light) {
    const { gl } = this;
    const places = new Float32Array(shape.parameters.length);
    shape.ranges.forEach(({ corner, corners }, surface) => {
      for (let k = 2 * corner; k < 2 * (corner + corners); k += 2) {
        places.set(light.inAtlas(surface, shape.parameters[k], shape.parameters[k + 1]), k);
      }
    });
    this.scene = gl.createVertexArray();
    gl.bindVertexArray(this.scene);
    [shape.positions, places].forEach((numbers, index) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(index);
      gl.vertexAttribPointer(index, 3 - index, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, shape.indices, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
  }

  /** Takes samples at these points of a pixel, in pixels from its upper left corner, those near its middle first. */
  sampleAt(points) {
    const shifts = points.map((point) => point.map((at) => at - 0.5));
    this.shifts = shifts.sort((a, b) => Math.hypot(...a) - Math.hypot(...b));
    this.restart();
  }

  /** Takes other light: an atlas as Light fills it. */
  take(atlas) {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D, this.light);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, ...this.extent, gl.RGBA, gl.FLOAT, atlas);
    this.restart();
  }

  /** Sets the number of pixels. */
  resize([width, height]) {
    const { gl } = this;
    if (this.canvas.width === width && this.canvas.height === height && this.sample) return;
    [this.canvas.width, this.canvas.height] = [width, height];
    for (const old of [this.sample, this.mean].filter(Boolean)) {
      gl.deleteTexture(old.picture);
      gl.deleteRenderbuffer(old.depth);
      gl.deleteFramebuffer(old.frame);
    }
    [this.sample, this.mean] = [target(gl, this.format, width, height), target(gl, this.format, width, height)];
    this.restart();
  }

  get size() {
    return [this.canvas.width, this.canvas.height];
  }

  /** Begins a new picture with the next sample. */
  restart() {
    this.done = 0;
  }

  get isComplete() {
    return this.done >= this.shifts.length;
  }

  /** Draws one more sample and shows the mean of all since the start of the picture. */
  draw(camera, look) {
    const { gl } = this;
    gl.viewport(0, 0, ...this.size);
    const [right, down] = this.shifts[this.done];
    const matrix = camera.matrix(this.size, [-right, down]);
    this.done += 1;
    if (this.done === 1) {
      this.drawScene(this.mean.frame, matrix, look);
    } else {
      this.drawScene(this.sample.frame, matrix, look);
      this.copy(this.sample, this.mean.frame, { part: 1 / this.done });
    }
    this.copy(this.mean, null, { encode: true, dither: !look.falseColours });
  }

  drawScene(frame, matrix, { style, exposure, range, backs, falseColours }) {
    const { gl, surface } = this;
    const paper = falseColours ? 1 : 0;
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.clearColor(paper, paper, paper, 1);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(surface.program);
    gl.bindVertexArray(this.scene);
    [this.light, this.gradient].forEach((texture, place) => {
      gl.activeTexture(gl.TEXTURE0 + place);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    gl.uniform1i(surface.at("light"), 0);
    gl.uniform1i(surface.at("gradient"), 1);
    gl.uniformMatrix4fv(surface.at("view"), false, matrix);
    gl.uniform1f(surface.at("exposure"), exposure);
    gl.uniform1i(surface.at("style"), style);
    gl.uniform2f(surface.at("range"), ...range);
    gl.uniform1i(surface.at("front"), 1);
    gl.cullFace(gl.BACK);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
    if (backs) {
      // The two sides of a sheet lie in one place: the front is shown.
      gl.enable(gl.POLYGON_OFFSET_FILL);
      gl.polygonOffset(1, 4);
      gl.uniform1i(surface.at("front"), 0);
      gl.cullFace(gl.FRONT);
      gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
      gl.disable(gl.POLYGON_OFFSET_FILL);
    }
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.activeTexture(gl.TEXTURE0);
  }

  /** Copies a picture to a frame: mixed by a part with what is there, or encoded for the screen. */
  copy({ picture }, frame, { part = 1, encode = false, dither = false }) {
    const { gl, screen } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.useProgram(screen.program);
    gl.bindVertexArray(null);
    gl.bindTexture(gl.TEXTURE_2D, picture);
    gl.uniform1i(screen.at("picture"), 0);
    gl.uniform1i(screen.at("encode"), encode ? 1 : 0);
    gl.uniform1i(screen.at("dither"), dither ? 1 : 0);
    if (part < 1) {
      gl.enable(gl.BLEND);
      gl.blendColor(0, 0, 0, part);
      gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
    }
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
  }

  /** Waits until all is drawn. */
  finish() {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

function context(canvas) {
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, preserveDrawingBuffer: true });
  if (!gl) throw new Error("this browser does not offer WebGL 2: choose a newer one, or allow it to use WebGL");
  return gl;
}

/** A program of two shaders of the page, and where its uniforms are. */
function program(gl, vertex, fragment) {
  const program = gl.createProgram();
  [vertex, fragment].forEach((name, index) => {
    const shader = gl.createShader(index === 0 ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
    gl.shaderSource(shader, document.getElementById(name).textContent.trim());
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(`${name}: ${gl.getShaderInfoLog(shader)}`);
    gl.attachShader(program, shader);
  });
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const places = {};
  const at = (name) => (places[name] ??= gl.getUniformLocation(program, name));
  return { program, at };
}

/** A texture, bound, that is not repeated. */
function texture(gl, filter) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, filter);
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  return texture;
}

/** A picture to draw on, with depth. */
function target(gl, format, width, height) {
  const picture = texture(gl, gl.NEAREST);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
  const depth = gl.createRenderbuffer();
  gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, picture, 0);
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
  return { picture, depth, frame };
}
