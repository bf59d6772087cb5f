#version 300 es
// A picture copied: linear as it is, or to the screen as sRGB (IEC 61966-2-1), dithered as in src/output/dither.rs.
precision highp float;
uniform sampler2D picture;
uniform bool encode;
uniform bool dither;
out vec4 colour;

vec3 encoded(vec3 linear) {
  return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
  vec3 linear = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
  if (!encode) {
    colour = vec4(linear, 1.0);
    return;
  }
  float height = float(textureSize(picture, 0).y);
  vec2 place = vec2(gl_FragCoord.x, height - gl_FragCoord.y);
  float step = dither ? fract(52.9829189 * fract(0.06711056 * place.x + 0.00583715 * place.y)) : 0.5;
  colour = vec4(floor(255.0 * encoded(clamp(linear, 0.0, 1.0)) + step) / 255.0, 1.0);
}
