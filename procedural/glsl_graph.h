#pragma once
// A texture graph as GLSL, for OpenGL and for use elsewhere: the value program that the host runs
// over arrays (graph_values.h), written step by step for one point, with the same operations in the
// same order. In float64 a context that rounds as IEEE 754 asks gives the host's bits.
#include "procedural/glsl_text.h"
#include "procedural/graph.h"

namespace burl {

/// Colour maps are written out, one comparison a stop.
inline constexpr std::size_t most_glsl_stops = 256;

/// Why there is no shader for a graph, as a clause; empty where there is one.
std::string no_graph_shader(const TextureGraph& graph);

/// The graph must be valid and not empty. Throws Error(unsupported) where there is no shader for
/// it.
GlslTexture glsl_graph(const TextureGraph& graph, GlslReal real);

/// A texture of the 1999 model as the graph it stands for: a color_map over a field.
TextureGraph graph_of_texture(const Texture& texture);

}  // namespace burl
