#include "app/bench/files.h"

#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

namespace burl {

namespace fs = std::filesystem;

BenchFolder::BenchFolder()
    : path(fs::temp_directory_path() / fmt::format("burl-bench-{}", getpid())) {
    fs::create_directories(path);
}

BenchFolder::~BenchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
}

void write_bench_obj(const fs::path& path, const Mesh& mesh) {
    std::ofstream file(path, std::ios::binary);
    for (const Vec3d& p : mesh.positions)
        file << fmt::format("v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : mesh.triangles)
        file << fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
}

void write_bench_ply(const fs::path& path, const Mesh& mesh) {
    std::ofstream file(path, std::ios::binary);
    file << fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
        "y\n"
        "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.size(), mesh.triangles.size());
    for (const Vec3d& p : mesh.positions) {
        const Vec3f q(p);
        file.write(reinterpret_cast<const char*>(&q), sizeof q);
    }
    for (const Triangle& t : mesh.triangles) {
        file.put(3).write(reinterpret_cast<const char*>(t.data()), sizeof t);
    }
}

}  // namespace burl
