#pragma once
// A texture graph as GLSL, for OpenGL and for use elsewhere: the value program that the host runs
// over arrays (graph/values.h), written step by step for one point, with the same operations in the
// same order. In float64 a context that rounds as IEEE 754 requires gives the host's bits.
#include "procedural/batch/filter.h"
#include "procedural/glsl/text.h"
#include "procedural/graph/graph.h"

namespace burl {

/// The largest number of stops of a colour map in shaders with gradients, which the node `slope`
/// and filters need.
inline constexpr std::size_t most_sloped_stops = 256;

/// The reason why there is no shader for a graph, as a clause; empty where there is one.
std::string no_graph_shader(const TextureGraph& graph);

/// The shader of a graph, which must be valid and not empty. Throws Error(unsupported) where there
/// is none.
GlslTexture glsl_graph(const TextureGraph& graph, GlslReal real);

/// Whether the shader of a whole material has a function of all planes: where its graph gives other
/// channels or the base colour may be transparent.
bool has_glsl_planes(const TextureGraph& graph);

/// The reason why glsl_material() cannot have this height; empty where it can.
std::string no_height_shader(const TextureGraph& height);

/// The shader of a whole material. It defines texture_color as glsl_graph() does; where
/// has_glsl_planes(), `TexturePlanes texture_planes(real3 solid)`, a struct of `real4 base_color`,
/// linear light times its alpha, and the graph's channels by their names, which evaluates once what
/// they share; and, unless `height` is empty, `real4 bump_input(real3 solid)`, the height's number
/// with its gradient. Throws Error(unsupported) where there is none.
GlslTexture glsl_material(const TextureGraph& graph, const TextureGraph& height, GlslReal real);

/// The reason why there is no shader for a graph whose nodes filter; empty where there is one.
std::string no_filtered_shader(const TextureGraph& graph, const Filter& filter);

/// The shader of a graph as the host evaluates it in float32 with a filter (graph/evaluator.h): the
/// last part defines `real3 texture_color(real3 solid, real3 step_u, real3 step_v)`, a texel's mean
/// by its two steps. In float64, noise and the share of it that a texel shows, colour maps and
/// patterns have the host's bits, except for sine, angle, logarithm and power, which the host takes
/// from the C library, and octaves of a field that fade, which it adds in float64. Throws
/// Error(unsupported) where there is no shader for the graph.
GlslTexture glsl_filtered_graph(const TextureGraph& graph, const Filter& filter, GlslReal real);

}  // namespace burl
