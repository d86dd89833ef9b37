// Levels of points against the map of the texel under each centre, texel by texel.
#include "atlas/solid/level.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "atlas/base/image.h"
#include "atlas/build/mesh_atlas.h"
#include "tests/atlas/support/made_meshes.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

/// Per texel the map it shows, or nobody.
Image<std::uint32_t> maps_of(const SolidAtlas& solid) {
    Image<std::uint32_t> maps(solid.size, solid.size, nobody);
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                EXPECT_EQ(maps(x, y), nobody) << "spans overlap";
                maps(x, y) = span.map;
            }
    return maps;
}

/// The texel's parallelogram under any place of the texture, in texels with whole numbers at their
/// sides.
Vec3d point_at(const TexelMap& map, double x, double y) {
    return map.origin + (x - 0.5 - map.anchor_x) * map.step_x +
           (y - 0.5 - map.anchor_y) * map.step_y;
}

void expect_same_places(const SolidAtlas& solid, const SolidAtlas& level, std::uint32_t size) {
    ASSERT_EQ(level.size, size);
    ASSERT_EQ(level.row_begin.size(), std::size_t{size} + 1);
    ASSERT_EQ(level.row_begin.back(), level.spans.size());
    const Image<std::uint32_t> old = maps_of(solid), now = maps_of(level);
    const double scale = double(solid.size) / size;
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
            const double at_x = (x + 0.5) * scale, at_y = (y + 0.5) * scale;
            const std::uint32_t owner = old(std::size_t(at_x), std::size_t(at_y));
            ASSERT_EQ(now(x, y) == nobody, owner == nobody) << x << ", " << y;
            if (owner == nobody) continue;
            const TexelMap &from = solid.maps[owner], &to = level.maps[now(x, y)];
            const double step = glm::length(to.step_x) + glm::length(to.step_y);
            const double tolerance = 1e-12 * (1.0 + glm::length(from.origin)) + 1e-11 * step;
            EXPECT_LT(glm::distance(to(x, y), point_at(from, at_x, at_y)), tolerance);
            EXPECT_LT(glm::distance(to.step_x, scale * from.step_x), 1e-14 * step);
            EXPECT_LT(glm::distance(to.step_y, scale * from.step_y), 1e-14 * step);
            EXPECT_EQ(level.triangle_of(now(x, y)), solid.triangle_of(owner));
        }
}

template <class Check>
void for_some_atlases(Check check) {
    const Mesh mesh = made::ring(24, 12);
    const Connectivity connectivity = build_connectivity(mesh);
    for (const AtlasKind kind : {AtlasKind::area, AtlasKind::quad, AtlasKind::patch})
        for (const std::uint32_t size : {128u, 201u}) {
            if (!made::allowed(kind, size)) continue;
            SCOPED_TRACE(fmt::format("{} {}", to_string(kind), size));
            const MeshAtlas atlas =
                build_atlas(mesh, connectivity, {.kind = kind, .size = size, .tries = 1});
            check(rasterize(mesh, atlas, atlas.mesh(mesh).positions));
        }
}

TEST(SolidLevel, TexelsShowWhatLiesUnderTheirCentres) {
    for_some_atlases([](const SolidAtlas& solid) {
        for (const std::uint32_t level : {0u, 1u, 2u, 3u, 5u, 9u, 40u}) {
            SCOPED_TRACE(level);
            expect_same_places(solid, solid_level(solid, level), level_size(solid.size, level));
        }
    });
}

TEST(SolidLevel, AnySizeWillDo) {
    for_some_atlases([](const SolidAtlas& solid) {
        for (const std::uint32_t size : {1u, 7u, 100u, solid.size + 1, 2 * solid.size, 301u})
            expect_same_places(solid, resized(solid, size), size);
    });
}

TEST(SolidLevel, GapsStayGaps) {
    SolidAtlas solid;
    solid.size = 8;
    solid.maps.resize(3);
    for (int i = 0; i < 3; ++i)
        solid.maps[std::size_t(i)].origin = Vec3d(10.0 * i),
        solid.maps[std::size_t(i)].step_x = Vec3d(1, 0, 0);
    solid.row_begin.push_back(0);
    for (std::uint32_t y = 0; y < 8; ++y) {
        if (y != 2) solid.spans.insert(solid.spans.end(), {{1, 1, 0}, {2, 2, 1}, {5, 3, 2}});
        solid.row_begin.push_back(solid.spans.size());
    }
    for (const std::uint32_t size : {1u, 2u, 3u, 4u, 8u, 16u})
        expect_same_places(solid, resized(solid, size), size);
    EXPECT_TRUE(resized(solid, 2).row(0).empty());  // centres of row 0 lie in the old row 2
}

TEST(SolidLevel, OneSpanPerRunAndOnlyMapsThatAreSeen) {
    for_some_atlases([](const SolidAtlas& solid) {
        const SolidAtlas level = solid_level(solid, 3);
        std::vector<bool> seen(level.maps.size(), false);
        for (std::size_t y = 0; y < level.size; ++y) {
            const Span* before = nullptr;
            for (const Span& span : level.row(y)) {
                seen[span.map] = true;
                EXPECT_GT(span.count, 0u);
                if (before && before->x + before->count == span.x) {
                    EXPECT_NE(before->map, span.map);
                }
                before = &span;
            }
        }
        EXPECT_EQ(std::ranges::count(seen, false), 0);
        EXPECT_LT(level.maps.size(), solid.maps.size());
    });
}

TEST(SolidLevel, SizesAreOpenGls) {
    EXPECT_EQ(level_size(1024, 0), 1024u);
    EXPECT_EQ(level_size(1024, 3), 128u);
    EXPECT_EQ(level_size(201, 1), 100u);
    EXPECT_EQ(level_size(201, 7), 1u);
    EXPECT_EQ(level_size(201, 8), 1u);
    EXPECT_EQ(level_size(16384, 40), 1u);
}

}  // namespace
}  // namespace burl
