#pragma once
// Closed meshes of any number of faces for benchmarks, made in code so that a figure needs no file
// and can be repeated anywhere.
#include <cstddef>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A torus of about `faces` triangles, of even triangles: a grid twice as long as wide.
Mesh torus(std::size_t faces);

/// A sphere with bumps of about `faces` triangles, 12 n^2 of them: a cube's six grids of n x n
/// squares pulled onto it, so that triangles are of unlike size and shape. Genus 0; the box's
/// middle is near the origin, its half diagonal about 1.
Mesh bumpy_sphere(std::size_t faces);

}  // namespace burl
