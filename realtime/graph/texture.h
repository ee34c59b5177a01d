// SPDX-License-Identifier: Apache-2.0
#pragma once
// How textures are made and read, as manifests say it. No GL.

namespace umbrameter {

enum class TextureKind {
  flat,   // "2d"
  array,  // layers of one size
  cube    // six square layers, ordered and turned as GL's faces: +x, -x, +y, -y, +z, -z
};
enum class TextureFilter { nearest, linear, mipmap };  // mipmap: linear between levels too
enum class TextureWrap { border, clamp, repeat };

}  // namespace umbrameter
