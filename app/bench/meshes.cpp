#include "app/bench/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <unordered_map>

#include <fmt/format.h>
#include <unistd.h>

namespace burl {

namespace fs = std::filesystem;

namespace {

/// The surface points of an n x n x n lattice cube, numbered by first use.
class CubeLattice {
  public:
    explicit CubeLattice(std::uint32_t n) : n_(n) {}

    std::uint32_t number(const std::array<std::uint32_t, 3>& at) {
        const std::uint64_t side = n_ + 1,
                            key = (std::uint64_t{at[2]} * side + at[1]) * side + at[0];
        const auto [entry, added] =
            numbers_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
        if (added)
            points_.push_back(2.0 / n_ * Vec3d(at[0], at[1], at[2]) - 1.0);  // the cube's side is 2
        return entry->second;
    }
    std::vector<Vec3d> take_points() { return std::move(points_); }

  private:
    std::uint32_t n_;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
    std::vector<Vec3d> points_;
};

Vec3d with_bumps(const Vec3d& on_cube) {
    const Vec3d p = glm::normalize(on_cube);
    const double bumps = 0.12 * std::sin(5.0 * p.x + 1.0) * std::sin(6.0 * p.y) +
                         0.06 * std::sin(13.0 * p.z + 2.0 * p.x) * std::cos(11.0 * p.y);
    return (1.0 + bumps) / std::numbers::sqrt3 * p;
}

void close_mesh(Mesh& mesh, const char* name) {
    mesh.name = name;
    mesh.parts.push_back({name, 0, static_cast<std::uint32_t>(mesh.triangles.size())});
}

}  // namespace

Mesh torus(std::size_t faces) {
    const auto rings = std::uint32_t(std::max(3.0, std::sqrt(double(faces))));
    const auto sides = std::uint32_t(std::max<std::size_t>(3, faces / 2 / rings));
    Mesh mesh;
    const double turn = 2.0 * std::numbers::pi;
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < sides; ++j) {
            const double u = turn * i / rings, v = turn * j / sides, radius = 2.0 + std::cos(v);
            mesh.positions.emplace_back(radius * std::cos(u), std::sin(v), radius * std::sin(u));
            const std::uint32_t a = i * sides + j, b = i * sides + (j + 1) % sides;
            const std::uint32_t c = (i + 1) % rings * sides + j,
                                d = (i + 1) % rings * sides + (j + 1) % sides;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    }
    close_mesh(mesh, "torus");
    return mesh;
}

Mesh bumpy_sphere(std::size_t faces) {
    const auto n = std::uint32_t(std::max(1.0, std::round(std::sqrt(double(faces) / 12.0))));
    CubeLattice lattice(n);
    Mesh mesh;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true})
            for (std::uint32_t i = 0; i < n; ++i)
                for (std::uint32_t j = 0; j < n; ++j) {
                    const auto corner = [&](std::uint32_t u, std::uint32_t v) {
                        std::array<std::uint32_t, 3> at{};
                        at[axis] = high ? n : 0;
                        at[(axis + (high ? 1 : 2)) % 3] = u;
                        at[(axis + (high ? 2 : 1)) % 3] = v;
                        return lattice.number(at);
                    };
                    const std::uint32_t a = corner(i, j), b = corner(i + 1, j),
                                        c = corner(i + 1, j + 1), d = corner(i, j + 1);
                    mesh.triangles.push_back({a, b, c});
                    mesh.triangles.push_back({a, c, d});
                }
    mesh.positions = lattice.take_points();
    for (Vec3d& p : mesh.positions) p = with_bumps(p);
    close_mesh(mesh, "bumpy sphere");
    return mesh;
}

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
