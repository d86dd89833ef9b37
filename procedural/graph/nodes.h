#pragma once
// The functions of the nodes of table.h, one per node, by family: each fills its output channels
// from its inputs, its point and the samples' footprints. docs/reference/nodes.md defines them.
#include "procedural/graph/batch.h"

namespace burl::nodes {

// math.cpp: numbers, arithmetic and weighted sums of inputs
void constant(const NodeCall& call);
void coordinate(const NodeCall& call);
void add(const NodeCall& call);
void multiply(const NodeCall& call);
void minimum(const NodeCall& call);
void maximum(const NodeCall& call);
void absolute(const NodeCall& call);
void power(const NodeCall& call);
void sine_of(const NodeCall& call);
void slope(const NodeCall& call);
void floor_of(const NodeCall& call);
void fract_of(const NodeCall& call);
void smoothstep(const NodeCall& call);
void scale(const NodeCall& call);
void mix(const NodeCall& call);
void bilerp(const NodeCall& call);

// patterns.cpp
void uv(const NodeCall& call);
void checkerboard(const NodeCall& call);
void checkerboard_3d(const NodeCall& call);
void stripes(const NodeCall& call);
void ramp(const NodeCall& call);
void sine(const NodeCall& call);
void rings(const NodeCall& call);
void wood_grain(const NodeCall& call);

// noise.cpp
void field(const NodeCall& call);
void fbm(const NodeCall& call);
void wrinkled(const NodeCall& call);
void windy(const NodeCall& call);
void marble(const NodeCall& call);
void bumps(const NodeCall& call);
void dots(const NodeCall& call);
void warp(const NodeCall& call);

// colors.cpp
void color_map(const NodeCall& call);
void layer_over(const NodeCall& call);

// image.cpp
void image(const NodeCall& call);

// mappings.cpp
void transform(const NodeCall& call);
void map_uv(const NodeCall& call);
void map_spherical(const NodeCall& call);
void map_cylindrical(const NodeCall& call);
void map_planar(const NodeCall& call);

}  // namespace burl::nodes
