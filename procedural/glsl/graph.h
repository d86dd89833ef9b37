#pragma once
// A texture graph as GLSL, for OpenGL and for use elsewhere: the value program that the host runs
// over arrays (graph_values.h), written step by step for one point, with the same operations in the
// same order. In float64 a context that rounds as IEEE 754 asks gives the host's bits.
#include "procedural/batch/filter.h"
#include "procedural/glsl/text.h"
#include "procedural/graph/graph.h"

namespace burl {

/// Of a colour map where gradients are asked for, by the node `slope` or a filter.
inline constexpr std::size_t most_sloped_stops = 256;

/// Why there is no shader for a graph, as a clause; empty where there is one.
std::string no_graph_shader(const TextureGraph& graph);

/// The graph must be valid and not empty. Throws Error(unsupported) where there is no shader for
/// it.
GlslTexture glsl_graph(const TextureGraph& graph, GlslReal real);

/// Why there is no shader for a graph whose nodes filter; empty where there is one.
std::string no_filtered_shader(const TextureGraph& graph, const Filter& filter);

/// The graph as the host's evaluator has it in float32 with a filter (graph_evaluator.h): the last
/// part defines `real3 texture_color(real3 solid, real3 step_u, real3 step_v)`, a texel's mean by
/// its two steps. Noise and what of it a texel shows, colour maps and patterns have the host's bits
/// in float64, but for sine, angle, logarithm and power, which the host takes from the C library,
/// and octaves of a field that fade, which it adds in float64. Throws Error(unsupported) where
/// there is no shader for it.
GlslTexture glsl_filtered_graph(const TextureGraph& graph, const Filter& filter, GlslReal real);

/// A texture of the 1999 model as the graph it stands for: a color_map over a field.
TextureGraph graph_of_texture(const Texture& texture);

}  // namespace burl
