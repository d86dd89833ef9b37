#pragma once
// Files that suites of `burl bench` read, in a folder that goes with them.
#include <filesystem>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A new folder among the system's temporary ones, gone with this.
struct BenchFolder {
    BenchFolder();
    ~BenchFolder();
    BenchFolder(const BenchFolder&) = delete;
    BenchFolder& operator=(const BenchFolder&) = delete;

    std::filesystem::path path;
};

/// Points and triangles alone; binary PLY is little-endian with float coordinates.
void write_bench_obj(const std::filesystem::path& path, const Mesh& mesh);
void write_bench_ply(const std::filesystem::path& path, const Mesh& mesh);

}  // namespace burl
