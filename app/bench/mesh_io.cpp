// The suite `burl bench mesh_io`: reading mesh files, and finding who is whose neighbour.
#include <memory>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "atlas/base/json.h"
#include "atlas/mesh/connectivity.h"
#include "atlas/read/read_mesh.h"
#include "atlas/read/readers.h"

namespace burl {

namespace {

std::vector<BenchCase> mesh_io_cases(std::size_t faces) {
    const Mesh mesh = torus(faces);
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

Json mesh_io_json(const BenchRow& row) {
    return {{"name", row.name},
            {"unit", row.unit},
            {"units", row.units},
            {"seconds_median", row.median},
            {"seconds_lowest", row.lowest},
            {"seconds_highest", row.highest},
            {"ns_per_unit", row.ns_per_unit()}};
}

}  // namespace

void run_mesh_io_bench(const BenchCommand& command) {
    const std::vector<BenchRow> rows =
        run_paired(mesh_io_cases(command.size_or(1'000'000)), command.repeats);
    if (!report_rows(command, rows, mesh_io_json)) return;
    fmt::print("{:<36} {:>12} {:>12} {:>12} {:>14}\n", command.suite, "median ms", "lowest",
               "highest", "ns/unit");
    for (const BenchRow& row : rows) {
        fmt::print("{:<36} {:>12.3f} {:>12.3f} {:>12.3f} {:>9.2f} /{}\n", row.name,
                   row.median * 1e3, row.lowest * 1e3, row.highest * 1e3, row.ns_per_unit(),
                   row.unit);
    }
}

}  // namespace burl
