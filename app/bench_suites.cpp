// The suites of `burl bench`. They make their own torus, so that a figure needs no file and can be
// repeated anywhere.
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>

#include <fmt/format.h>
#include <unistd.h>

#include "app/bench.h"
#include "app/pipeline.h"
#include "atlas/mesh_io.h"
#include "atlas/mesh_readers.h"
#include "procedural/synthesize.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

/// A torus of about `faces` triangles: a grid twice as long as wide, closed both ways.
Mesh torus(std::size_t faces) {
    const auto rings = std::uint32_t(std::max(3.0, std::sqrt(double(faces))));
    const auto sides = std::uint32_t(std::max<std::size_t>(3, faces / 2 / rings));
    Mesh mesh;
    mesh.name = "torus";
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
    mesh.parts.push_back({"torus", 0, std::uint32_t(mesh.triangles.size())});
    return mesh;
}

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

std::vector<BenchCase> atlas_suite(std::size_t faces) {
    auto mesh = std::make_shared<Mesh>(torus(faces == 0 ? 100'000 : faces));
    auto edges = std::make_shared<Connectivity>(build_connectivity(*mesh));
    std::vector<BenchCase> cases;
    for (const AtlasKind kind :
         {AtlasKind::uniform, AtlasKind::area, AtlasKind::length, AtlasKind::quad}) {
        const AtlasOptions options{kind, Overscan::bilinear, 4096};
        cases.push_back({fmt::format("layout {} 4096", to_string(kind)),
                         double(mesh->triangles.size()), "face",
                         [mesh, edges, options] { layout_atlas(*mesh, *edges, options); }});
    }
    auto atlas = std::make_shared<Atlas>(
        layout_atlas(*mesh, *edges, {AtlasKind::area, Overscan::bilinear, 4096}));
    cases.push_back({"rasterize area 4096", double(mesh->triangles.size()), "face",
                     [mesh, atlas] { rasterize(*mesh, *atlas, mesh->positions); }});
    return cases;
}

std::vector<BenchCase> synthesis_suite(std::size_t side) {
    const std::size_t n = side == 0 ? 1024 : side;
    std::vector<BenchCase> cases;
    for (const char* preset : {"marble", "wood", "clouds"}) {
        Recipe recipe = load_recipe(preset, {fmt::format("atlas.size={}", n)});
        auto pipeline = std::make_shared<Pipeline>(torus(6000));
        pipeline->set_recipe(recipe);
        pipeline->solid();
        for (const int threads : {1, 0}) {
            cases.push_back(
                {fmt::format("{} {} {}", preset, n, threads == 1 ? "1 thread" : "all threads"),
                 double(n * n), "texel", [pipeline, threads] {
                     pipeline->set_threads(threads);
                     pipeline->synthesize<Rgb8>();
                 }});
        }
    }
    return cases;
}

}  // namespace

const std::vector<std::string>& bench_suites() {
    static const std::vector<std::string> names{"mesh_io", "atlas", "synthesis"};
    return names;
}

std::vector<BenchCase> bench_suite(const std::string& suite, std::size_t size) {
    if (suite == "mesh_io") return mesh_io_suite(size);
    if (suite == "atlas") return atlas_suite(size);
    return synthesis_suite(size);
}

}  // namespace burl
