// What only the quad atlas promises: blocks on a binary grid, sizes that follow the weight, singles
// that do not spoil averages, and an order that keeps neighbours together.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <random>

#include "atlas/base/error.h"
#include "atlas/measure/atlas_measures.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

AtlasOptions quad_options_of(std::uint32_t size, AtlasWeight weight = AtlasWeight::error,
                             Overscan overscan = Overscan::bilinear) {
    return {AtlasKind::quad, overscan, size, weight};
}

Atlas quad_layout(const Mesh& mesh, const AtlasOptions& options) {
    return layout_atlas(mesh, made::neighbours_by_brute_force(mesh), options);
}

/// A sheet without bumps, so that all its pairs are alike.
Mesh flat(std::uint32_t squares) {
    Mesh mesh = made::grid(squares, squares);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    return mesh;
}

template <class Check>
void for_all_quads(Check check) {
    for (const auto& [name, mesh] : made::all())
        for (const AtlasWeight weight :
             {AtlasWeight::equal, AtlasWeight::area, AtlasWeight::length, AtlasWeight::error})
            for (const Overscan overscan : {Overscan::nearest, Overscan::bilinear})
                for (const std::uint32_t size : {16u, 64u, 256u}) {
                    const AtlasOptions options = quad_options_of(size, weight, overscan);
                    if (size < smallest_size(mesh.triangles.size(), options)) continue;
                    SCOPED_TRACE(fmt::format("{} {} {} {}", name, to_string(weight),
                                             to_string(overscan), size));
                    check(mesh, quad_layout(mesh, options));
                    if (testing::Test::HasFailure()) return;
                }
}

TEST(Quad, BlocksArePowersOfTwoAtMultiplesOfTheirSidesAndFillTheSquare) {
    for_all_quads([](const Mesh& mesh, const Atlas& atlas) {
        std::uint64_t texels = 0;
        for (const Block& block : atlas.blocks) {
            EXPECT_TRUE(std::has_single_bit(block.width));
            EXPECT_TRUE(std::has_single_bit(block.height));
            EXPECT_EQ(block.x % block.width, 0u);
            EXPECT_EQ(block.y % block.height, 0u);
            texels += std::uint64_t{block.width} * block.height;
        }
        EXPECT_EQ(texels, atlas.notes.texels_total);
        const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
        EXPECT_EQ(measure(mesh, atlas, solid).texel_coverage, 1.0);
    });
}

// Averaging halves texels in both directions: as long as a block is at least as large as a level's
// texel each way, no texel of that level reaches over its sides.
TEST(Quad, LevelTexelsMixNoBlocksThatAreLargerThanThey) {
    for_all_quads([](const Mesh&, const Atlas& atlas) {
        for (std::uint32_t texel = 2; texel <= atlas.options.size; texel *= 2)
            for (const Block& block : atlas.blocks) {
                if (block.width < texel || block.height < texel) continue;
                EXPECT_EQ(block.x % texel, 0u);
                EXPECT_EQ((block.x + block.width) % texel, 0u);
                EXPECT_EQ(block.y % texel, 0u);
                EXPECT_EQ((block.y + block.height) % texel, 0u);
            }
    });
}

TEST(Quad, EqualSharesOfAPowerOfTwoAreEqual) {
    const Mesh mesh = flat(16);
    const Atlas atlas = quad_layout(mesh, quad_options_of(128, AtlasWeight::equal));
    ASSERT_EQ(atlas.blocks.size(), 256u);
    for (const Block& block : atlas.blocks) {
        EXPECT_EQ(block.width, 8u);
        EXPECT_EQ(block.height, 8u);
    }
}

TEST(Quad, EqualWeightGivesAllBlocksAboutAsManyTexels) {
    const Mesh mesh = made::soup(300, 4);
    std::uint32_t least = ~0u, most = 0;
    for (const Block& block : quad_layout(mesh, quad_options_of(256, AtlasWeight::equal)).blocks) {
        least = std::min(least, block.width * block.height);
        most = std::max(most, block.width * block.height);
    }
    EXPECT_GE(least, 128u);  // 65536 / 300 = 218, so 128 and 256
    EXPECT_LE(most, 256u);
}

TEST(Quad, DensityFollowsTheArea) {
    for (const Mesh& mesh : {made::ball(3), made::grid(20, 20), made::soup(400, 5)}) {
        const Atlas atlas =
            quad_layout(mesh, quad_options_of(1024, AtlasWeight::area, Overscan::nearest));
        const AtlasMetrics m = measure(mesh, atlas, rasterize(mesh, atlas, mesh.positions));
        const double whole = m.coverage;  // half of a single's block is not read
        EXPECT_GT(m.density[0], 0.45 * whole);
        EXPECT_LT(m.density[2], 2.2 * whole);
    }
}

TEST(Quad, LengthGivesSliversMoreThanTheirArea) {
    const Mesh mesh = made::fan(128);  // slivers with edges 1, 1 and 0.05
    Mesh both = made::grid(4, 4);
    const auto shift = static_cast<std::uint32_t>(both.positions.size());
    both.positions.insert(both.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& [a, b, c] : mesh.triangles)
        both.triangles.push_back({a + shift, b + shift, c + shift});
    both = made::mesh_of(both.positions, both.triangles);
    const auto sliver_share = [&](AtlasWeight weight) {
        const Atlas atlas = quad_layout(both, quad_options_of(512, weight));
        double texels = 0.0;
        for (const Block& block : atlas.blocks)
            if (block.lower >= 32) texels += double(block.width) * block.height;
        return texels / (512.0 * 512.0);
    };
    const double area = sliver_share(AtlasWeight::area);
    const double error = sliver_share(AtlasWeight::error);
    const double length = sliver_share(AtlasWeight::length);
    EXPECT_LT(area, error + 0.01);
    EXPECT_LT(error, length);
    EXPECT_GT(length, 0.8);
}

// A rectangle much longer than high gets a block that is wider than high, or turned.
TEST(Quad, BlocksTakeTheShapeOfTheirPairs) {
    Mesh mesh = flat(8);
    for (Vec3d& p : mesh.positions) p.x *= 16.0;
    for (const Block& block : quad_layout(mesh, quad_options_of(256)).blocks) {
        const double along = block.rising ? block.height : block.width;
        const double across = block.rising ? block.width : block.height;
        const auto corner = std::size_t(block.lower_corner);
        const Triangle& t = mesh.triangles[std::size_t(block.lower)];
        const double x =
            glm::distance(mesh.positions[t[corner]], mesh.positions[t[(corner + 1) % 3]]);
        const double y =
            glm::distance(mesh.positions[t[corner]], mesh.positions[t[(corner + 2) % 3]]);
        EXPECT_GE(x > y ? along / across : across / along, 4.0);
    }
}

// The block of a single shows every point of the triangle as often as its mirror image: the mean of
// all texels is the mean over the triangle, but for the cell of overscan.
TEST(Quad, TheMeanOfASinglesBlockIsItsTrianglesMean) {
    const Mesh mesh = made::one_triangle();
    const Atlas atlas = quad_layout(mesh, quad_options_of(64));
    const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
    ASSERT_EQ(solid.maps.size(), 2u);
    Vec3d sum{0.0};
    for (std::uint32_t y = 0; y < 64; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                sum += solid.maps[span.map](x, y);
    const Vec3d mean = sum / (64.0 * 64.0), centroid{1.0, 4.0 / 3.0, 0.0};
    EXPECT_LT(glm::distance(mean, centroid), 0.15);
    EXPECT_GT(atlas.notes.unread_texels, 64u * 64u * 2u / 5u);
}

TEST(Quad, OneTexelShowsTheMiddleOfWhatItHolds) {
    const auto shown = [](const Mesh& mesh) {
        const Atlas atlas = quad_layout(mesh, quad_options_of(1));
        EXPECT_EQ(atlas.notes.minimal_cells, mesh.triangles.size());
        const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
        return solid.maps[solid.row(0)[0].map](0, 0);
    };
    EXPECT_LT(glm::distance(shown(made::one_triangle()), Vec3d(1.0, 4.0 / 3.0, 0.0)), 1e-12);
    EXPECT_LT(glm::distance(shown(made::square()), Vec3d(0.5, 0.5, 0.0)), 1e-12);
}

// All texels of narrow blocks show points of their own triangle.
TEST(Quad, NarrowBlocksShowOnlyTheSurface) {
    std::uint64_t narrow = 0;
    for (const auto& [name, mesh] : made::all()) {
        const AtlasOptions options =
            quad_options_of(smallest_size(mesh.triangles.size(), quad_options_of(0)));
        const Atlas atlas = quad_layout(mesh, options);
        const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
        const std::vector<bool> collapsed = made::collapsed_triangles(atlas);
        for (std::uint32_t y = 0; y < options.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                    const std::uint32_t t = solid.triangle_of(span.map);
                    if (!collapsed[t] || triangle_area(mesh, t) == 0.0) continue;
                    ++narrow;
                    const auto& [a, b, c] = mesh.triangles[t];
                    const Vec3d p = mesh.positions[a], u = mesh.positions[b] - p,
                                v = mesh.positions[c] - p, w = solid.maps[span.map](x, y) - p;
                    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v),
                                 det = uu * vv - uv * uv;
                    const double s = (vv * glm::dot(u, w) - uv * glm::dot(v, w)) / det;
                    const double r = (uu * glm::dot(v, w) - uv * glm::dot(u, w)) / det;
                    EXPECT_GE(std::min({s, r, 1.0 - s - r}), -1e-9) << name;
                }
    }
    EXPECT_GT(narrow, 100u);
}

TEST(Quad, HoldsAsManyPairsAsTexels) {
    const Mesh mesh = flat(16);  // 512 triangles, 256 pairs
    EXPECT_EQ(smallest_size(512, quad_options_of(0)), 32u);
    const Atlas atlas = quad_layout(mesh, quad_options_of(16));
    EXPECT_EQ(atlas.blocks.size(), 256u);
    EXPECT_EQ(atlas.notes.minimal_cells, 512u);
    EXPECT_EQ(atlas.notes.shared_texels, 0u);
    const Mesh loose = made::soup(256, 3);
    EXPECT_EQ(quad_layout(loose, quad_options_of(16)).blocks.size(), 256u);
}

TEST(Quad, RefusesSizesThatCannotBeHalvedAndNamesTheNearest) {
    try {
        quad_layout(made::square(), quad_options_of(1000));
        FAIL() << "1000 is no power of two";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_STREQ(error.what(),
                     "the quad atlas halves its texture down to single texels, which 1000 x 1000 "
                     "texels do not allow; use --size 512 or 1024");
    }
}

/// RMS difference between a level's texel at each block's centre and the function there. Level l
/// averages 2^l x 2^l texels.
double level_error(const Mesh& mesh, const Atlas& atlas, std::vector<double> image, int level) {
    std::uint32_t size = atlas.options.size;
    for (int l = 0; l < level; ++l, size /= 2)
        for (std::uint32_t y = 0; y < size / 2; ++y)
            for (std::uint32_t x = 0; x < size / 2; ++x) {
                const std::size_t at = std::size_t{2 * y} * size + 2 * x;
                image[std::size_t{y} * (size / 2) + x] =
                    0.25 * (image[at] + image[at + 1] + image[at + size] + image[at + size + 1]);
            }
    double sum = 0.0;
    for (const Block& block : atlas.blocks) {
        const auto x = (block.x + block.width / 2) >> level;
        const auto y = (block.y + block.height / 2) >> level;
        Vec3d centre{0.0};
        for (const std::uint32_t p : mesh.triangles[std::size_t(block.lower)])
            centre += mesh.positions[p] / 3.0;
        const double truth = std::sin(0.5 * (centre.x + 2.0 * centre.y - centre.z));
        sum += std::pow(image[std::size_t{y} * size + x] - truth, 2);
    }
    return std::sqrt(sum / double(atlas.blocks.size()));
}

// The paper's figure 8: levels above the blocks average neighbours on the surface.
TEST(Quad, TreeOrderKeepsLevelsThatRandomOrderLoses) {
    const Mesh mesh = made::ball(4);  // 1024 pairs
    Atlas atlas = quad_layout(mesh, quad_options_of(128, AtlasWeight::equal));
    const auto image_of = [&mesh](const Atlas& a) {
        const SolidAtlas solid = rasterize(mesh, a, mesh.positions);
        std::vector<double> image(128 * 128);
        for (std::uint32_t y = 0; y < 128; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                    const Vec3d p = solid.maps[span.map](x, y);
                    image[y * 128 + x] = std::sin(0.5 * (p.x + 2.0 * p.y - p.z));
                }
        return image;
    };
    Atlas shuffled = atlas;
    std::vector<std::size_t> order(atlas.blocks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Block& place = atlas.blocks[order[i]];
        Block& block = shuffled.blocks[i];
        ASSERT_EQ(place.width * place.height, 16u);
        const Vec2d move{double(place.x) - block.x, double(place.y) - block.y};
        ASSERT_EQ(place.width, block.width) << "all blocks are 4 x 4";
        block.x = place.x;
        block.y = place.y;
        for (const std::int32_t t : {block.lower, block.upper})
            for (Vec2d& c : shuffled.corners[std::size_t(t)]) c += move;
    }
    const std::vector<double> tree = image_of(atlas), random = image_of(shuffled);
    EXPECT_NEAR(level_error(mesh, atlas, tree, 2), level_error(mesh, shuffled, random, 2), 1e-12);
    for (const int level : {3, 4, 5})
        EXPECT_GT(level_error(mesh, shuffled, random, level),
                  1.8 * level_error(mesh, atlas, tree, level))
            << level;
}

}  // namespace
}  // namespace burl
