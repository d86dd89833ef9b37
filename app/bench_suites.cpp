// The suite of `burl bench` that times cases one by one and compares nothing with a reference.
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "app/bench.h"
#include "app/bench_meshes.h"
#include "atlas/connectivity.h"
#include "atlas/mesh_io.h"
#include "atlas/mesh_readers.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

/// A folder for the files a suite reads, gone with the suite.
struct TemporaryFolder {
    fs::path path = fs::temp_directory_path() / fmt::format("burl-bench-{}", getpid());
    TemporaryFolder() { fs::create_directories(path); }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

void write_obj(const fs::path& path, const Mesh& mesh) {
    std::ofstream file(path, std::ios::binary);
    for (const Vec3d& p : mesh.positions)
        file << fmt::format("v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : mesh.triangles)
        file << fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
}

void write_ply(const fs::path& path, const Mesh& mesh) {
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

std::vector<BenchCase> mesh_io_suite(std::size_t faces) {
    const Mesh mesh = torus(faces == 0 ? 1'000'000 : faces);
    auto folder = std::make_shared<TemporaryFolder>();
    const std::string obj = folder->path / "torus.obj", ply = folder->path / "torus.ply";
    write_obj(obj, mesh);
    write_ply(ply, mesh);
    auto read = std::make_shared<Mesh>(read_mesh(obj));
    const double count = double(mesh.triangles.size());
    return {{"parse obj", count, "face", [folder, obj] { parse_mesh(obj); }},
            {"parse binary ply", count, "face", [folder, ply] { parse_mesh(ply); }},
            {"read obj (parse, weld, check)", count, "face", [folder, obj] { read_mesh(obj); }},
            {"read binary ply", count, "face", [folder, ply] { read_mesh(ply); }},
            {"connectivity", count, "face", [read] { build_connectivity(*read); }}};
}

}  // namespace

const std::vector<std::string>& bench_suites() {
    static const std::vector<std::string> names{"mesh_io"};
    return names;
}

std::vector<BenchCase> bench_suite(const std::string&, std::size_t size) {
    return mesh_io_suite(size);
}

}  // namespace burl
