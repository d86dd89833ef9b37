// Partition and mapping of whole meshes: nothing lost, nothing twice, nothing flipped, and the same
// for every number of threads.
#include "atlas/patch/maps.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <thread>

#include <tbb/global_control.h>

#include "atlas/mesh/dual_graph.h"
#include "atlas/read/read_mesh.h"
#include "tests/atlas/support/made_patches.h"
#include "tests/paths.h"

namespace burl {
namespace {

PatchMaps maps_of(const Mesh& mesh, const PartitionOptions& options = {}) {
    const Connectivity connectivity = build_connectivity(mesh);
    return map_regions(mesh, connectivity, partition_mesh(mesh, connectivity, options));
}

void expect_every_face_once(const Mesh& mesh, const Regions& regions) {
    std::vector<int> seen(mesh.triangles.size(), 0);
    for (const auto& region : regions) {
        EXPECT_TRUE(std::is_sorted(region.begin(), region.end()));
        for (const std::uint32_t face : region) ++seen[face];
    }
    EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
}

TEST(Partition, EveryFaceOnceInConnectedRegions) {
    for (const auto& [name, mesh] : made::all()) {
        SCOPED_TRACE(name);
        const Connectivity connectivity = build_connectivity(mesh);
        const Regions regions = partition_mesh(mesh, connectivity);
        expect_every_face_once(mesh, regions);
        EXPECT_EQ(regions, partition_mesh(mesh, connectivity));
        for (const auto& region : regions)
            EXPECT_EQ(topology_of(made::patch_of(mesh, region)).components, 1u);
        expect_every_face_once(mesh, crease_regions(mesh, connectivity, 30.0));
    }
}

TEST(Partition, RegionsHaveAboutTheSameArea) {
    const Mesh mesh = made::ball(4);
    const Regions regions = partition_mesh(mesh, build_connectivity(mesh));
    ASSERT_EQ(regions.size(), 6u);
    double all = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) all += triangle_area(mesh, t);
    for (const auto& region : regions) {
        double area = 0.0;
        for (const std::uint32_t t : region) area += triangle_area(mesh, t);
        EXPECT_NEAR(area, all / 6, 0.1 * all / 6);
    }
}

TEST(Partition, CreasesDivideABoxIntoItsSides) {
    const Mesh mesh = made::box(5);
    const Regions regions = crease_regions(mesh, build_connectivity(mesh), 30.0);
    ASSERT_EQ(regions.size(), 6u);
    for (const auto& region : regions) EXPECT_EQ(region.size(), 50u);
}

TEST(Partition, BisectingAlwaysDivides) {
    for (const auto& [name, mesh] : made::all()) {
        if (name == "soup" || name == "soup_of_two" || name == "one_triangle") continue;
        SCOPED_TRACE(name);
        const Connectivity connectivity = build_connectivity(mesh);
        std::vector<std::int32_t> local(mesh.triangles.size(), -1);
        const Patch patch = made::whole(mesh);
        const auto faces = component_faces(patch)[0];
        const Regions halves = bisect_region(mesh, connectivity, faces, local);
        EXPECT_GE(halves.size(), 2u);
        std::vector<std::uint32_t> together;
        for (const auto& half : halves) together.insert(together.end(), half.begin(), half.end());
        std::sort(together.begin(), together.end());
        EXPECT_EQ(together, faces);
        EXPECT_EQ(local, std::vector<std::int32_t>(local.size(), -1));
    }
}

TEST(Partition, PrintsNothingAndLetsOthersPrint) {
    const Mesh mesh = read_mesh(test::case_file("metis.obj"));
    const Connectivity connectivity = build_connectivity(mesh);
    testing::internal::CaptureStdout();
    std::atomic<bool> done = false;
    std::string said;
    std::thread other([&] {
        do {
            std::fputs("other\n", stdout);
            said += "other\n";
        } while (!done);
    });
    for (int i = 0; i < 100; ++i)
        for (const std::uint32_t patches : {2u, 3u, 6u, 9u})
            partition_mesh(mesh, connectivity, {.patches = patches});
    done = true;
    other.join();
    std::fflush(stdout);
    EXPECT_TRUE(testing::internal::GetCapturedStdout() == said);
}

TEST(PatchMaps, NothingLostNothingFlipped) {
    auto meshes = made::all();
    meshes.push_back({"ring", made::ring(24, 12)});
    meshes.push_back({"tube", made::tube(16, 9, 4.0)});
    meshes.push_back({"box", made::box(4)});
    for (const auto& [name, mesh] : meshes) {
        SCOPED_TRACE(name);
        const PatchMaps maps = maps_of(mesh);
        std::vector<int> seen(mesh.triangles.size(), 0);
        for (const std::uint32_t face : maps.unmapped) ++seen[face];
        std::vector<double> area(mesh.triangles.size(), 0.0);
        for (const MappedPatch& mapped : maps.patches) {
            EXPECT_NE(mapped.rectangle.has_value(), mapped.planar.has_value());
            if (mapped.rectangle) made::expect_fills_square(mapped.patch, mapped.uv);
            for (std::size_t t = 0; t < mapped.patch.triangles.size(); ++t) {
                if (area_of(mapped.patch, t) > 0.0) {
                    EXPECT_GT(made::uv_area(mapped.patch, mapped.uv, t), 0.0);
                }
                if (mapped.patch.faces[t] == not_in_mesh) continue;
                seen[mapped.patch.faces[t]] = 1;
                area[mapped.patch.faces[t]] += area_of(mapped.patch, t);
            }
            EXPECT_LT(mapped.stretch.distortion(), 5.0);
            EXPECT_GE(mapped.stretch.distortion(), 1.0 - 1e-9);
        }
        EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
        for (const std::uint32_t face : maps.unmapped) area[face] = triangle_area(mesh, face);
        for (std::size_t t = 0; t < area.size(); ++t)
            EXPECT_NEAR(area[t], triangle_area(mesh, t), 1e-12 * (1.0 + area[t]));
    }
}

TEST(PatchMaps, OrdinaryMeshesAreMappedWholly) {
    for (const Mesh& mesh : {made::ball(4), made::ring(40, 20), made::tube(24, 20, 6.0)}) {
        const PatchMaps maps = maps_of(mesh);
        EXPECT_TRUE(maps.unmapped.empty());
        EXPECT_LE(maps.patches.size(), 12u);
        for (const MappedPatch& mapped : maps.patches) EXPECT_LE(mapped.stretch.distortion(), 1.4);
    }
}

TEST(PatchMaps, BoxIsProjectedSideBySide) {
    const Mesh mesh = made::box(5);
    const Connectivity connectivity = build_connectivity(mesh);
    const PatchMaps maps =
        map_regions(mesh, connectivity, crease_regions(mesh, connectivity, 30.0));
    ASSERT_EQ(maps.patches.size(), 6u);
    EXPECT_EQ(maps.notes.planar_patches, 6u);
    for (const MappedPatch& mapped : maps.patches) {
        EXPECT_NEAR(mapped.stretch.distortion(), 1.0, 1e-12);
        const PlanarMap& map = *mapped.planar;
        for (std::size_t v = 0; v < mapped.uv.size(); ++v) {
            const Vec3d p =
                map.origin + mapped.uv[v].x * map.along_u + mapped.uv[v].y * map.along_v;
            EXPECT_LT(glm::length(p - mapped.patch.points[v]), 1e-12);
        }
        made::expect_fills_square(mapped.patch, mapped.uv);
    }
}

TEST(PatchMaps, SheetWithHoleIsProjectedWhole) {
    const Mesh sheet = made::grid(6, 6);
    std::vector<Triangle> pierced;
    for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t)
        if (t / 2 != 14) pierced.push_back(sheet.triangles[t]);
    Mesh mesh = made::mesh_of(sheet.positions, pierced);
    for (Vec3d& p : mesh.positions) p = {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, 1.0};
    const PatchMaps maps = maps_of(mesh, {.patches = 1});
    ASSERT_EQ(maps.patches.size(), 1u);
    ASSERT_TRUE(maps.patches[0].planar);
    EXPECT_NEAR(maps.patches[0].stretch.distortion(), 36.0 / 35.0, 1e-9);
}

TEST(PatchMaps, ThreadsDoNotMatter) {
    const Mesh mesh = made::ring(60, 24);
    const PatchMaps many = maps_of(mesh, {.patches = 8});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const PatchMaps single = maps_of(mesh, {.patches = 8});
    ASSERT_EQ(many.patches.size(), single.patches.size());
    for (std::size_t i = 0; i < many.patches.size(); ++i) {
        EXPECT_EQ(many.patches[i].uv, single.patches[i].uv);
        EXPECT_EQ(many.patches[i].patch.faces, single.patches[i].patch.faces);
    }
}

TEST(DualGraph, WeightsFollowAreaAndCreases) {
    const Mesh mesh = made::box(1);
    std::vector<std::uint32_t> faces(mesh.triangles.size());
    std::iota(faces.begin(), faces.end(), 0u);
    std::vector<std::int32_t> local(faces.size(), -1);
    const DualGraph graph = dual_graph(mesh, build_connectivity(mesh), faces, local);
    ASSERT_EQ(graph.nodes(), 12u);
    double all = 0.0, units = 0.0;
    for (std::size_t t = 0; t < 12; ++t) {
        all += triangle_area(mesh, t);
        units += graph.node_weights[t];
    }
    for (std::size_t t = 0; t < 12; ++t)
        EXPECT_NEAR(graph.node_weights[t] / units, triangle_area(mesh, t) / all, 1e-6);
    // A diagonal of a side is flat, an edge of the box a right angle: half the weight per length.
    std::vector<double> flat, bent;
    for (std::size_t t = 0; t < 12; ++t)
        for (auto i = graph.begin[t]; i < graph.begin[t + 1]; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const auto other = static_cast<std::uint32_t>(graph.targets[at]);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto n = build_connectivity(mesh).neighbours[t][k];
                if (n != graph.targets[at]) continue;
                const double per_length = (graph.edge_weights[at] - 0.5) /
                                          edge_length(mesh, static_cast<std::uint32_t>(t), k);
                (dihedral_cosine(mesh, static_cast<std::uint32_t>(t), other) > 0.5 ? flat : bent)
                    .push_back(per_length);
            }
        }
    ASSERT_EQ(flat.size(), 12u);
    ASSERT_EQ(bent.size(), 24u);
    for (const double w : bent) EXPECT_NEAR(w / flat[0], 0.5, 0.03);
}

}  // namespace
}  // namespace burl
