#pragma once
// Closed meshes of any number of faces for benchmarks, generated so that figures need no file and
// can be reproduced anywhere, and the temporary files from which suites read them.
#include <cstddef>
#include <filesystem>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A torus of about `faces` triangles of similar size: a grid twice as long as wide.
Mesh torus(std::size_t faces);

/// A bumpy sphere of about `faces` triangles, 12 n^2 exactly: a cube's six grids of n x n squares
/// projected onto it, so that triangles vary in size and shape. Its genus is 0; the box's centre is
/// near the origin and its half diagonal about 1.
Mesh bumpy_sphere(std::size_t faces);

/// A new folder in the system's temporary one, removed with this object.
struct BenchFolder {
    BenchFolder();
    ~BenchFolder();
    BenchFolder(const BenchFolder&) = delete;
    BenchFolder& operator=(const BenchFolder&) = delete;

    std::filesystem::path path;
};

/// Write positions and triangles only; binary PLY is little-endian with float coordinates.
void write_bench_obj(const std::filesystem::path& path, const Mesh& mesh);
void write_bench_ply(const std::filesystem::path& path, const Mesh& mesh);

}  // namespace burl
