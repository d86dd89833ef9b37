#pragma once
// What the passes of multipass noise hold ("Perlin Noise Pixel Shaders", figures 4 and 6 to 9), as
// textures that are graphs.
#include <string>
#include <vector>

namespace burl {

/// Arguments of `burl render --direct` for 16 squares in rows of four, over 16 x 16 cells of the
/// plane r = 0 with s to the right and t upwards: solid coordinates, their whole and their
/// fractional part, numbers by s; numbers by t, their mean, numbers by both, the noise; the
/// numbers of the four corners; these times their weights, which add up to the noise.
std::vector<std::string> pass_parts();

/// Arguments for three squares of 4 x 4 cells (figure 5): the fractions of s and t as an image's
/// red and green, then the two as the luminance images that it is made of.
std::vector<std::string> channel_parts();

}  // namespace burl
