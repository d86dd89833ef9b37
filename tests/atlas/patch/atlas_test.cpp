// The patch atlas from mesh to texels: every texel has one owner, inner texels show what lies at
// their centre, gutters reflect it, and the refined mesh is the same surface.
#include "atlas/patch/atlas.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "atlas/base/error.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/surface_points.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

struct Built {
    Mesh mesh;
    PatchAtlas atlas;
    SolidAtlas solid;
    Built(Mesh m, std::uint32_t size)
        : mesh(std::move(m)),
          atlas(*build_patch_atlas(mesh, build_connectivity(mesh), {.size = size})),
          solid(rasterize_patches(atlas, atlas.refined.mesh.positions)) {}

    Vec3d texel(std::size_t x, std::size_t y) const {
        for (const Span& span : solid.row(y))
            if (x >= span.x && x < span.x + span.count)
                return solid.maps[span.map](std::int64_t(x), std::int64_t(y));
        ADD_FAILURE() << "nobody owns " << x << ", " << y;
        return Vec3d(0.0);
    }
    /// The solid coordinate by bilinear lookup.
    Vec3d lookup(const Vec2d& at) const {
        const double x = std::floor(at.x - 0.5), y = std::floor(at.y - 0.5);
        const double fx = at.x - 0.5 - x, fy = at.y - 0.5 - y;
        const auto tap = [&](int i, int j, double weight) {
            return weight == 0.0 ? Vec3d(0.0)
                                 : weight * texel(std::size_t(x + i), std::size_t(y + j));
        };
        return tap(0, 0, (1 - fx) * (1 - fy)) + tap(1, 0, fx * (1 - fy)) +
               tap(0, 1, (1 - fx) * fy) + tap(1, 1, fx * fy);
    }
};

std::vector<made::Named> meshes() {
    return {{"ball", made::ball(4)},           {"ring", made::ring(40, 20)},
            {"tube", made::tube(24, 20, 6.0)}, {"box", made::box(4)},
            {"grid", made::grid(9, 7)},        {"nasty", made::nasty()},
            {"soup", made::soup(11, 1)},       {"one_triangle", made::one_triangle()}};
}

TEST(PatchAtlas, EveryTexelHasOneOwner) {
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const Built b(mesh, 200);
        ASSERT_EQ(b.solid.row_begin.size(), 201u);
        for (std::size_t y = 0; y < 200; ++y) {
            std::uint32_t next = 0;
            for (const Span& span : b.solid.row(y)) {
                EXPECT_EQ(span.x, next);
                EXPECT_LT(span.map, b.solid.maps.size());
                // The triangle named lies in the block that the texel is in.
                const std::uint32_t t = b.solid.triangle_of(span.map);
                ASSERT_LT(t, b.atlas.refined.mesh.triangles.size());
                const PatchBlock& block = b.atlas.layout.blocks[b.atlas.patch_of(t)];
                EXPECT_TRUE(span.x >= block.x && span.x + span.count <= block.x + block.width &&
                            y >= block.y && y < block.y + block.height);
                next = span.x + span.count;
            }
            EXPECT_EQ(next, 200u);
        }
    }
}

TEST(PatchAtlas, TrianglesAreShownWhereTheirCornersSay) {
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const Built b(mesh, 256);
        const Mesh& refined = b.atlas.refined.mesh;
        std::size_t inside = 0;
        for (std::size_t t = 0; t < refined.triangles.size(); ++t) {
            const auto& c = b.atlas.atlas.corners[t];
            const Vec2d u = c[1] - c[0], v = c[2] - c[0];
            const double det = u.x * v.y - u.y * v.x;
            if (triangle_area(mesh, refined.source_faces[t]) <= 0.0) continue;
            ASSERT_GT(det, 0.0);
            const Vec2d low = glm::min(glm::min(c[0], c[1]), c[2]),
                        high = glm::max(glm::max(c[0], c[1]), c[2]);
            for (double y = std::floor(low.y) + 0.5; y <= high.y; ++y)
                for (double x = std::floor(low.x) + 0.5; x <= high.x; ++x) {
                    const Vec2d d = Vec2d(x, y) - c[0];
                    const double i = (d.x * v.y - d.y * v.x) / det,
                                 j = (u.x * d.y - u.y * d.x) / det;
                    if (!(i > 1e-9 && j > 1e-9 && i + j < 1.0 - 1e-9)) continue;
                    const auto& p = refined.triangles[t];
                    const Vec3d point = refined.positions[p[0]] +
                                        i * (refined.positions[p[1]] - refined.positions[p[0]]) +
                                        j * (refined.positions[p[2]] - refined.positions[p[0]]);
                    EXPECT_LT(glm::distance(b.texel(std::size_t(x), std::size_t(y)), point), 1e-9);
                    ++inside;
                }
        }
        // Texels strictly inside triangles of rectangles' inner parts: nearly all there are.
        EXPECT_GT(inside, name == "soup" || name == "one_triangle" ? 20000u : 45000u);
    }
}

TEST(PatchAtlas, GuttersLieOnTheSurfaceAndGoOnFromTheBorder) {
    const Built b(made::ring(40, 20), 256);
    ASSERT_GE(b.atlas.layout.gutter, 2u);
    double worst = 0.0, steps = 0.0;
    int outside = 0;
    for (std::size_t p = 0; p < b.atlas.patches.size(); ++p) {
        if (b.atlas.patches[p].plane) continue;
        const PatchBlock& k = b.atlas.layout.blocks[p];
        ASSERT_GT(k.gutter, 0u);
        const std::size_t x0 = k.x + k.gutter, x1 = x0 + k.columns();
        const std::size_t y0 = k.y + k.gutter, y1 = y0 + k.rows();
        for (std::size_t y = k.y; y < k.y + k.height; ++y)
            for (std::size_t x = k.x; x < k.x + k.width; ++x) {
                if (x >= x0 && x <= x1 && y >= y0 && y <= y1) continue;
                ++outside;
                EXPECT_TRUE(made::lies_on(b.mesh, b.texel(x, y), 1e-12));
            }
        // Across the border points go on as they came: by less than a step more or less.
        for (std::size_t y = y0; y <= y1; ++y) {
            const Vec3d in = b.texel(x0, y) - b.texel(x0 + 1, y),
                        out = b.texel(x0 - 1, y) - b.texel(x0, y);
            worst = std::max(worst, glm::distance(in, out) / glm::length(in));
            steps += glm::distance(in, out) / glm::length(in) / double(y1 - y0 + 1);
        }
    }
    EXPECT_GT(outside, 1000);
    EXPECT_LT(worst, 1.0);
    EXPECT_LT(steps / double(b.atlas.patches.size()), 0.3);
}

TEST(PatchAtlas, BordersLieOnCentresOfTheOutermostInnerTexels) {
    const Mesh mesh = made::ball(4);
    const PatchCandidate fitted = *fit_patches(mesh, build_connectivity(mesh), {.size = 256});
    for (std::size_t p = 0; p < fitted.maps.patches.size(); ++p) {
        const MappedPatch& mapped = fitted.maps.patches[p];
        const PatchBlock& k = fitted.layout.blocks[p];
        ASSERT_TRUE(mapped.rectangle);
        for (const HalfEdge h : mapped.patch.loops[0]) {
            const Vec2d at = k.place(mapped.uv[mapped.patch.start(h)]);
            const bool side = at.x == k.x + k.gutter + 0.5 || at.y == k.y + k.gutter + 0.5 ||
                              at.x == k.x + k.width - k.gutter - 0.5 ||
                              at.y == k.y + k.height - k.gutter - 0.5;
            EXPECT_TRUE(side);
        }
    }
}

TEST(PatchAtlas, LookupsFindTheSurfacePointAndBothSidesOfABorderAgree) {
    const Built b(made::ball(5), 512);
    const Mesh& refined = b.atlas.refined.mesh;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3d> at_edge;
    double worst = 0.0, sum = 0.0, mismatch = 0.0;
    for (std::size_t t = 0; t < refined.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t p = refined.triangles[t][k], q = refined.triangles[t][(k + 1) % 3];
            const auto& c = b.atlas.atlas.corners[t];
            const Vec3d middle = 0.5 * refined.positions[p] + 0.5 * refined.positions[q];
            const Vec3d found = b.lookup(0.5 * c[k] + 0.5 * c[(k + 1) % 3]);
            const TexelMap& map = b.solid.maps[t];
            const double texel = glm::length(map.step_x) + glm::length(map.step_y);
            worst = std::max(worst, glm::distance(found, middle) / texel);
            sum += glm::distance(found, middle) / texel;
            const auto [other, first] = at_edge.emplace(std::minmax(p, q), found);
            if (!first) mismatch = std::max(mismatch, glm::distance(other->second, found));
        }
    // Where the stretch of neighbouring triangles differs a lookup is off by a part of a texel; on
    // average by little. Both sides of a border are off alike.
    EXPECT_LT(worst, 0.5);
    EXPECT_LT(sum / (3.0 * double(refined.triangles.size())), 0.02);
    EXPECT_LT(mismatch, 0.2 * 3.5 / 512);
}

TEST(PatchAtlas, FlatMeshesAreExact) {
    const Built b(made::box(4), 256);
    EXPECT_EQ(b.atlas.notes.planar_patches, 6u);
    // Planes have gutters, too, which levels need: the plane as far as lookups read, then round the
    // edge, straight on along the next side.
    for (std::size_t p = 0; p < 6; ++p) {
        const PatchBlock& k = b.atlas.layout.blocks[p];
        EXPECT_EQ(k.gutter, b.atlas.layout.gutter);
        const std::size_t y = k.y + k.height / 2, x = k.x + k.gutter;
        const Vec3d step = b.texel(x + 1, y) - b.texel(x, y);
        EXPECT_LT(glm::distance(b.texel(x - 1, y), b.texel(x, y) - step), 1e-12);
        const Vec3d far = b.texel(k.x, y) - b.texel(x, y);
        EXPECT_NEAR(glm::length(far), k.gutter * glm::length(step), 1e-12);
        EXPECT_NEAR(glm::dot(far, step), 0.0, 1e-12);
        EXPECT_TRUE(made::lies_on(b.mesh, b.texel(k.x, y), 1e-12));
    }
    const Mesh& refined = b.atlas.refined.mesh;
    for (std::size_t t = 0; t < refined.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d found = b.lookup(b.atlas.atlas.corners[t][k]);
            EXPECT_LT(glm::distance(found, refined.positions[refined.triangles[t][k]]), 1e-12);
        }
}

Mesh moved(Mesh mesh, double scale, const Vec3d& by) {
    for (Vec3d& p : mesh.positions) p = scale * (p + by);
    return mesh;
}

PatchAtlas small_atlas(const Mesh& mesh) {
    return *build_patch_atlas(mesh, build_connectivity(mesh), {.size = 256, .tries = 2});
}

TEST(PatchAtlas, SameBitsAtPowersOfTwo) {
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const PatchAtlas a = small_atlas(mesh);
        const PatchAtlas b = small_atlas(moved(mesh, 0x1p-20, Vec3d(0.0)));
        EXPECT_EQ(a.atlas.corners, b.atlas.corners);
        EXPECT_EQ(a.layout.blocks, b.layout.blocks);
        EXPECT_EQ(a.refined.mesh.triangles, b.refined.mesh.triangles);
    }
}

TEST(PatchAtlas, ScaleAndPlaceDoNotMatter) {
    for (const Mesh& mesh : {made::ring(24, 12), made::ball(3)}) {
        const PatchAtlas a = small_atlas(mesh);
        const double side = bounding_box(mesh).longest_side();
        for (const double scale : {1e-6, 7.7e5}) {
            const PatchAtlas b = small_atlas(moved(mesh, scale, Vec3d(0.0)));
            ASSERT_EQ(a.layout.blocks, b.layout.blocks);
            ASSERT_EQ(a.refined.mesh.triangles, b.refined.mesh.triangles);
            for (std::size_t t = 0; t < a.atlas.corners.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_LT(glm::distance(a.atlas.corners[t][k], b.atlas.corners[t][k]), 1e-3);
        }
        for (const double by : {-3.3, 1e6}) {
            const PatchAtlas b = small_atlas(moved(mesh, 1.0, Vec3d(by * side)));
            EXPECT_EQ(a.patches.size(), b.patches.size()) << by;
            EXPECT_NEAR(b.layout.predicted_stretch / a.layout.predicted_stretch, 1.0, 0.02) << by;
        }
    }
}

TEST(PatchAtlas, MapsAreOfTheMeshItself) {
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const Mesh large = moved(mesh, 37.5, {1.0, -2.0, 0.25});
        const PatchCandidate fitted =
            *fit_patches(large, build_connectivity(large), {.size = 256, .tries = 1});
        double area = 0.0;
        for (const MappedPatch& mapped : fitted.maps.patches) {
            for (std::size_t v = 0; v < mapped.patch.points.size(); ++v) {
                const VertexOrigin& o = mapped.patch.origins[v];
                if (o == VertexOrigin{}) continue;
                EXPECT_EQ(mapped.patch.points[v],
                          0.5 * large.positions[o.a] + 0.5 * large.positions[o.b]);
            }
            area += area_of(mapped.patch);
            const Stretch now = StretchMeasure(mapped.patch)(mapped.uv);
            if (name == "nasty" || mapped.planar) continue;
            EXPECT_NEAR(now.distortion() / mapped.stretch.distortion(), 1.0, 1e-3);
            EXPECT_NEAR(now.x / mapped.stretch.x, 1.0, 1e-3);
        }
        double all = 0.0;
        for (std::size_t t = 0; t < large.triangles.size(); ++t) all += triangle_area(large, t);
        EXPECT_NEAR(area, all, 1e-6 * all);
    }
}

TEST(PatchAtlas, PointsKeepTheirPlacesOnTheRefinedMesh) {
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const MeshAtlas atlas =
            build_atlas(mesh, build_connectivity(mesh), {.kind = AtlasKind::patch, .size = 256});
        ASSERT_TRUE(atlas.patches());
        const std::vector<SurfacePoint> points = area_uniform_points(mesh, 3000, 1);
        const std::vector<SurfacePoint> moved = refined_points(mesh, atlas, points);
        ASSERT_EQ(moved.size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_LT(
                glm::distance(position(atlas.mesh(mesh), moved[i]), position(mesh, points[i])),
                1e-12);
            EXPECT_GT(std::min({moved[i].weights.x, moved[i].weights.y, moved[i].weights.z}),
                      -1e-12);
        }
    }
}

TEST(PatchAtlas, GivesWayToPairsWhereItDoesNotFit) {
    const Mesh mesh = made::soup(61, 1);
    const MeshAtlas atlas =
        build_atlas(mesh, build_connectivity(mesh), {.kind = AtlasKind::patch, .size = 8});
    EXPECT_FALSE(atlas.patches());
    EXPECT_EQ(atlas.atlas().options.kind, AtlasKind::quad);
    EXPECT_EQ(&atlas.mesh(mesh), &mesh);
}

TEST(PatchAtlas, NothingWhenTheTextureIsTooSmall) {
    const Mesh mesh = made::soup(61, 1);
    EXPECT_FALSE(build_patch_atlas(mesh, build_connectivity(mesh), {.size = 8}));
}

TEST(PatchAtlas, NothingOnceItIsStopped) {
    std::stop_source stopped;
    stopped.request_stop();
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const Connectivity connectivity = build_connectivity(mesh);
        EXPECT_FALSE(build_patch_atlas(mesh, connectivity, {.size = 256}, stopped.get_token()));
        EXPECT_FALSE(build_atlas(mesh, connectivity, {.size = 256}, stopped.get_token()));
        EXPECT_TRUE(build_atlas(mesh, connectivity, {.size = 256}, std::stop_token()));
        const PatchMaps maps = map_regions(mesh, connectivity, partition_mesh(mesh, connectivity),
                                           {.stop = stopped.get_token()});
        EXPECT_TRUE(maps.patches.empty());
        EXPECT_EQ(maps.unmapped.size(), mesh.triangles.size());
    }
}

TEST(PatchAtlas, AStopAtAnyTimeGivesNothingOrTheAtlas) {
    const Mesh mesh = made::ball(4);
    const Connectivity connectivity = build_connectivity(mesh);
    const PatchAtlas whole = *build_patch_atlas(mesh, connectivity, {.size = 256});
    for (int microseconds = 0; microseconds < 64000; microseconds = 2 * microseconds + 1) {
        std::stop_source stop;
        std::jthread stopper([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
            stop.request_stop();
        });
        const auto atlas = build_patch_atlas(mesh, connectivity, {.size = 256}, stop.get_token());
        if (atlas) {
            EXPECT_EQ(atlas->atlas.corners, whole.atlas.corners);
        }
    }
}

TEST(PatchRefine, SameSurfaceWithoutTJunctions) {
    std::uint32_t extra = 0;
    for (const auto& [name, mesh] : meshes()) {
        SCOPED_TRACE(name);
        const Connectivity connectivity = build_connectivity(mesh);
        const PatchMaps maps =
            map_regions(mesh, connectivity, partition_mesh(mesh, connectivity, {.patches = 12}));
        const RefinedMesh refined = refine_mesh(mesh, maps).refined;
        extra += std::uint32_t(refined.extra_points.size());
        std::vector<double> area(mesh.triangles.size(), 0.0);
        for (std::size_t t = 0; t < refined.mesh.triangles.size(); ++t)
            area[refined.mesh.source_faces[t]] += triangle_area(refined.mesh, t);
        for (std::size_t t = 0; t < area.size(); ++t)
            EXPECT_NEAR(area[t], triangle_area(mesh, t), 1e-12);
        EXPECT_EQ(refined.mesh.positions.size(),
                  mesh.positions.size() + refined.extra_points.size());
        EXPECT_TRUE(
            std::is_sorted(refined.mesh.source_faces.begin(), refined.mesh.source_faces.end()));
        EXPECT_EQ(refined.mesh.parts.back().triangle_count, refined.mesh.triangles.size());
        if (name == "nasty") continue;  // duplicates: which copy meets which is not defined
        const Connectivity after = build_connectivity(refined.mesh);
        EXPECT_EQ(after.boundary_edges, connectivity.boundary_edges);
        EXPECT_EQ(after.split_faces, connectivity.split_faces);
    }
    EXPECT_GT(extra, 0u);
}

TEST(PatchRefine, InterpolatesWhatCornersCarry) {
    Mesh mesh = made::ring(30, 10);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) {
            const Vec3d at = mesh.positions[p];
            mesh.corners.colors.push_back(Vec4f(at.x, at.y, at.z, 1.0));
            mesh.corners.normals.push_back(glm::normalize(Vec3f(at)));
            mesh.corners.uvs.push_back({at.x, at.y});
            mesh.corners.joints.push_back({1, 2, 0, 0});
            mesh.corners.weights.push_back(Vec4f(0.25, 0.75, 0.0, 0.0));
        }
    const Connectivity connectivity = build_connectivity(mesh);
    const PatchMaps maps =
        map_regions(mesh, connectivity, partition_mesh(mesh, connectivity, {.patches = 20}));
    const RefinedMesh refined = refine_mesh(mesh, maps).refined;
    ASSERT_FALSE(refined.extra_points.empty());
    const CornerAttributes& corners = refined.mesh.corners;
    ASSERT_EQ(corners.colors.size(), 3 * refined.mesh.triangles.size());
    for (std::size_t c = 0; c < corners.colors.size(); ++c) {
        const Vec3d p = refined.mesh.positions[refined.mesh.triangles[c / 3][c % 3]];
        EXPECT_LT(glm::distance(Vec3d(corners.colors[c]), p), 1e-6);
        EXPECT_LT(glm::distance(corners.uvs[c], Vec2d(p)), 1e-12);
        EXPECT_NEAR(glm::length(corners.normals[c]), 1.0f, 1e-6f);
        for (std::size_t k = 0; k < 4; ++k) {
            const float weight = corners.joints[c][k] == 1   ? 0.25f
                                 : corners.joints[c][k] == 2 ? 0.75f
                                                             : 0.0f;
            EXPECT_NEAR(corners.weights[c][int(k)], weight, 1e-6f);
        }
    }
}

}  // namespace
}  // namespace burl
