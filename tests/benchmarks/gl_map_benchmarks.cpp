// Lattice maps as textures: drawn from the atlas's spans, or filled by the host and uploaded.
#include <fmt/format.h>

#include "app/gl/fill/lattice_map.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/build/mesh_atlas.h"
#include "tests/benchmarks/micro_benchmarks.h"

namespace burl {

namespace {

constexpr std::uint32_t size = 1024;

SolidAtlas teapot_atlas(AtlasKind kind) {
    const Mesh mesh = sample_mesh("sample:teapot");
    AtlasOptions options;
    options.kind = kind;
    options.size = size;
    const MeshAtlas atlas = build_atlas(mesh, build_connectivity(mesh), options);
    const Affine3 map = solid_from_mesh(mesh, SolidSpace::unit);
    return rasterize(mesh, atlas, map_positions(atlas.mesh(mesh), map));
}

void make_maps(benchmark::State& state, AtlasKind kind, MapFill fill) {
    const auto context = create_osmesa_context();
    const SolidAtlas solid = teapot_atlas(kind);
    const GlLatticeMapper mapper(context->gl(), solid, solid.maps, 0, fill);
    const LatticeStreamKey stream{{Mat3d(8.0), Vec3d(0.0)}, 3, 0.0};
    const Quadric quadric{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    for ([[maybe_unused]] auto iteration : state) {
        const GlLatticeMap map = mapper.make(stream, quadric, {{0, 0}, {int(size), int(size)}});
        context->gl().Finish();
    }
    state.counters["spans"] = double(solid.spans.size());
}

}  // namespace

void register_map_benchmarks() {
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad})
        for (const MapFill fill : {MapFill::host, MapFill::gpu}) {
            const std::string name = fmt::format("lattice_map/{}/{}", to_string(kind),
                                                 fill == MapFill::gpu ? "drawn" : "uploaded");
            benchmark::RegisterBenchmark(name.c_str(),
                                         [=](benchmark::State& state) {
                                             try {
                                                 make_maps(state, kind, fill);
                                             } catch (const Error& error) {
                                                 state.SkipWithError(error.what());
                                             }
                                         })
                ->MeasureProcessCPUTime()
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace burl
