#pragma once
// The cubes of "Bresenham Noise" (Kameya & Hart, figures 4 to 8): three faces in parallel
// projection, where a scan line moves evenly through the solid, so that the texturing function can
// run along it by forward differences; and where the result is not that of every pixel by itself.
#include <cstddef>

#include "atlas/base/image.h"
#include "procedural/model/texture.h"

namespace burl {

enum class CubeMethod {
    pixelwise,  ///< f in float64 at every pixel
    forward,    ///< forward differences in float32, from one cell crossing to the next
};

/// The faces s = 0, t = 0 and r = size of the cube [0, size]^3, `side` x `side` pixels; the lowest
/// point is the origin and the highest (size, size, size), as in the paper. Every face has a light
/// of its own, so that one sees a cube; around it is the background of pictures. The texture's
/// noise must be plain value noise (no_forward_form).
Image<Rgb8> draw_cube(const Texture& texture, double size, std::size_t side, CubeMethod method);

/// Black where two cubes of one size differ, white where they agree, as the paper has it; the
/// background stays.
Image<Rgb8> disagreement(const Image<Rgb8>& a, const Image<Rgb8>& b);

}  // namespace burl
