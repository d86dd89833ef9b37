#pragma once
// A surface of few triangles in the place of one of many, for pictures that must be drawn soon.
#include <cstddef>

#include "app/scene/scene.h"

namespace burl {

/// Returns the surface with about `most` triangles, at most a quarter more, by vertex clustering
/// (Rossignac & Borrel, "Multi-resolution 3D approximations for rendering complex scenes", 1993):
/// of all vertices in a cell of a cubic grid the one nearest to their mean is left, and triangles
/// whose corners lie in three cells are drawn between those. Any triangles will do, whether or not
/// they form a manifold. Vertices keep all that they have, such as their place in an atlas, which
/// between them means nothing: a triangle's corners may lie in different blocks. A surface with no
/// more than `most` triangles, or without area, is returned as it is.
Surface coarse_surface(const Surface& surface, std::size_t most);

}  // namespace burl
