#pragma once
// Parts of figures that no command draws, because they show what goes on inside: cubes and lines by
// forward differences ("Bresenham Noise"), and numbers that bits of coordinates make ("Perlin Noise
// Pixel Shaders").
#include <string>

#include "atlas/base/image.h"

namespace burl {

/// Whether the text is such a part:
///
///     cube RECIPE SIZE pixelwise|forward|difference    (forward_cube.h)
///     line RECIPE values|difference all|OCTAVE LARGEST (forward_line.h; OCTAVE counts from 1)
///     bits mixed|numbers                               (procedural/passes/tables.h)
bool is_drawn_part(const std::string& text);

/// The picture of such a part.
Image<Rgb8> drawn_part(const std::string& text);

}  // namespace burl
