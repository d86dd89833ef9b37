// The suite of `burl bench` whose cases are timed without a reference to compare with.
#include <memory>

#include <fmt/format.h>

#include "app/bench/bench.h"
#include "app/bench/files.h"
#include "app/bench/meshes.h"
#include "atlas/mesh/connectivity.h"
#include "atlas/read/read_mesh.h"
#include "atlas/read/readers.h"

namespace burl {

namespace {

std::vector<BenchCase> mesh_io_suite(std::size_t faces) {
    const Mesh mesh = torus(faces == 0 ? 1'000'000 : faces);
    auto folder = std::make_shared<BenchFolder>();
    const std::string obj = folder->path / "torus.obj", ply = folder->path / "torus.ply";
    write_bench_obj(obj, mesh);
    write_bench_ply(ply, mesh);
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
