#pragma once
// The cubes of "Bresenham Noise" (Kameya & Hart, figures 4 to 8): three faces in parallel
// projection, where the points of a scan line are evenly spaced in solid space, so that the
// texturing function can be evaluated along it by forward differences; and the pixels where the
// result differs from evaluation pixel by pixel.
#include <cstddef>

#include "atlas/base/image.h"
#include "procedural/model/texture.h"

namespace burl {

/// The evaluation of the field f.
enum class CubeMethod {
    pixelwise,  ///< f in float64 at every pixel
    forward,    ///< forward differences in float32, from one cell crossing to the next
};

/// The faces s = 0, t = 0 and r = size of the cube [0, size]^3 in a picture of `side` x `side`
/// pixels; its lowest point is the origin and its highest (size, size, size), as in the paper.
/// Every face has a light intensity of its own, so that the edges are visible; the rest is the
/// background of pictures. The texture's noise must be plain value noise (no_forward_form).
Image<Rgb8> draw_cube(const Texture& texture, double size, std::size_t side, CubeMethod method);

/// Two cubes of one size compared, in the paper's colours: black where they differ, white where
/// they agree, and the background unchanged.
Image<Rgb8> disagreement(const Image<Rgb8>& a, const Image<Rgb8>& b);

}  // namespace burl
