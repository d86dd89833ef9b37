#pragma once
// Cells and scattered shapes as calls of the functions of shaders/graph/tiles.glsl.
#include <span>

#include "procedural/glsl/functions.h"
#include "procedural/graph/program.h"

namespace burl {

/// The call, of type real, that gives a cell's random number; `axes` are one to three coordinates.
std::string glsl_call(const CellNumber& cell, std::span<const std::string> axes,
                      GlslFunctions& functions);

/// The call, of type real4, that gives a cell's feature and its derivatives along x, y and z.
std::string glsl_call(const CellFeature& feature, std::span<const std::string> axes,
                      GlslFunctions& functions);

/// The call, of type real4, that gives what shapes give and its derivatives along x and y, then 0.
std::string glsl_call(const ScatteredShapes& shapes, std::span<const std::string> axes,
                      GlslFunctions& functions);

}  // namespace burl
