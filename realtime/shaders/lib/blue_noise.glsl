// SPDX-License-Identifier: Apache-2.0
// Noise without low frequencies, for passes that read noise.blue: what is left of it is easiest to filter away.

/// Two values in [0,1) of a pixel: the texture's there, and as far from there as its repetition allows, where it is as good as another.
vec2 blue_noise(vec2 p_px) {
  ivec2 side = textureSize(noise_blue, 0);
  ivec2 px = ivec2(floor(p_px)) & (side - 1);
  return vec2(texelFetch(noise_blue, px, 0).r, texelFetch(noise_blue, (px + side / 2) & (side - 1), 0).r);
}
