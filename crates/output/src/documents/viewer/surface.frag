#version 300 es
// The colour of a surface, linear, as the pictures of `radiosity render` have it (src/output/tone.rs, scale.rs).
precision highp float;
uniform sampler2D light;     // red, green, blue; or the number that false colours show
uniform sampler2D gradient;  // colours of the scale, sRGB
uniform float exposure;
uniform int style;           // 0: in proportion, 1: with a shoulder, 2: false colours, 3: equal ratios between them
uniform vec2 range;          // ends of the scale
uniform bool front;          // the back of a surface is black, or white in false colours
in vec2 at;
out vec4 colour;

const float KNEE = 0.8;
const float DESATURATION = 0.15;

vec3 shoulder(vec3 light) {
  float greatest = max(light.r, max(light.g, light.b));
  if (greatest <= KNEE) return light;
  float room = 1.0 - KNEE;
  float shown = 1.0 - room * exp(-(greatest - KNEE) / room);
  float towardsWhite = 1.0 - 1.0 / (1.0 + DESATURATION * (greatest - shown));
  vec3 kept = light * (shown / greatest);
  return kept + towardsWhite * (shown - kept);
}

vec3 linear(vec3 encoded) {
  return mix(pow((encoded + 0.055) / 1.055, vec3(2.4)), encoded / 12.92, lessThanEqual(encoded, vec3(0.04045)));
}

vec3 falseColour(float value) {
  float part = style == 3
    ? log(max(value, range.x) / range.x) / log(range.y / range.x)
    : (value - range.x) / (range.y - range.x);
  float count = float(textureSize(gradient, 0).x);
  float place = (clamp(part, 0.0, 1.0) * (count - 1.0) + 0.5) / count;
  return linear(texture(gradient, vec2(place, 0.5)).rgb);
}

void main() {
  vec3 seen = front ? texture(light, at).rgb : vec3(0.0);
  if (style >= 2) seen = front ? falseColour(seen.r) : vec3(1.0);
  else if (style == 1) seen = shoulder(seen * exposure);
  else seen = min(seen * exposure, 1.0);
  colour = vec4(seen, 1.0);
}
