#pragma once
// The cost of a graph in noises, known before it is run or its shader is compiled: software OpenGL
// works through every noise that a shader calls, some 50 ms each, and several times that where they
// are many.
#include <cstddef>

#include "procedural/graph/graph.h"
#include "procedural/graph/planes.h"

namespace burl {

/// The largest number of noises of a graph that OpenGL is given; those of Burl's own recipes have
/// at most a fifth of it (tests/app/gl/fill/noise_limit_test.cpp).
inline constexpr std::size_t most_shader_noises = 256;

/// The number of noises that a graph evaluates for a point: an octave, or a cell's number, counts
/// as one, a vector of them as three, strewn shapes and an octave of `simplex_nd`, whose walk needs
/// arrays, as four, and a noise of Blender's or MaterialX's whose octaves the point decides as 16;
/// what the graph shares counts once. The graph must be valid and not empty.
std::size_t graph_noises(const TextureGraph& graph, GraphOutput output);

/// The cost of a graph for a point on the host, in noises: those of graph_noises(), and one for
/// every eight steps that are none; at least one.
double graph_cost(const TextureGraph& graph, GraphOutput output);

}  // namespace burl
