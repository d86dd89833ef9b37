#pragma once
// Temporary files that suites of `burl bench` read.
#include <filesystem>

#include "atlas/mesh/mesh.h"

namespace burl {

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
