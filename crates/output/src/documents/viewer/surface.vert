#version 300 es
// Corners of triangles: where they are, and their places in the atlas of light.
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 place;
uniform mat4 view;
out vec2 at;

void main() {
  at = place;
  gl_Position = view * vec4(position, 1.0);
}
