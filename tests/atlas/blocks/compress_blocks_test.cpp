// Blocks share a place exactly when they may, and lookups stay within the error allowed.
#include "atlas/blocks/compress_blocks.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "atlas/base/error.h"
#include "atlas/measure/lookup.h"
#include "atlas/solid/solid_atlas.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

Atlas quad_of(const Mesh& mesh, std::uint32_t size) {
    return layout_atlas(mesh, made::neighbours_by_brute_force(mesh),
                        {AtlasKind::quad, Overscan::bilinear, size});
}

/// f of the surface point of every texel, in all channels, float.
template <class F>
Image<RgbF> picture(const Mesh& mesh, const Atlas& atlas, F f) {
    const std::uint32_t size = atlas.options.size;
    Image<RgbF> image(size, size);
    const SolidAtlas solid = rasterize(mesh, atlas, mesh.positions);
    for (std::uint32_t y = 0; y < size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                const auto value = float(f(solid.maps[span.map](x, y)));
                image(x, y) = {value, 0.5f * value, 1.0f - value};
            }
    return image;
}

std::set<std::pair<std::uint32_t, std::uint32_t>> sides_of(const Atlas& atlas) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const Block& block : atlas.blocks) sides.insert({block.width, block.height});
    return sides;
}

Image<Vec3f> floats(const Image<RgbF>& image) {
    Image<Vec3f> result(image.width(), image.height());
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x)
            result(x, y) = {image(x, y).r, image(x, y).g, image(x, y).b};
    return result;
}

TEST(CompressBlocks, AConstantKeepsOneBlockOfEachSides) {
    const Mesh mesh = made::ball(3);
    const Atlas atlas = quad_of(mesh, 256);
    const Image<Rgb8> image(256, 256, {10, 200, 30});
    const auto result = compress_blocks(atlas, image, 0.0);
    EXPECT_EQ(result.notes.places, sides_of(atlas).size());
    EXPECT_EQ(result.notes.blocks, atlas.blocks.size());
    EXPECT_EQ(result.notes.largest_error, 0.0);
    EXPECT_EQ(result.notes.texels_after, result.image.width() * result.image.height());
    EXPECT_LT(result.notes.texels_after, 256u * 256u / 50u);
    for (const Block& block : result.atlas.blocks) {
        EXPECT_EQ(block.x % block.width, 0u);
        EXPECT_EQ(block.y % block.height, 0u);
        for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
            for (std::uint32_t x = block.x; x < block.x + block.width; ++x)
                EXPECT_EQ(result.image(x, y), image(0, 0));
    }
}

// A flat sheet of 16 x 16 equal squares under a function of period 4 squares: 16 blocks remain.
TEST(CompressBlocks, APeriodIsKeptOnce) {
    Mesh mesh = made::grid(16, 16);
    for (Vec3d& p : mesh.positions) p.z = 0.0;
    const Atlas atlas = quad_of(mesh, 256);
    // The same value all over a square, so that it does not matter how its block is turned.
    const Image<RgbF> image = picture(mesh, atlas, [](const Vec3d&) { return 0.0; });
    Image<RgbF> periodic = image;
    for (std::size_t i = 0; i < atlas.blocks.size(); ++i) {
        const Block& block = atlas.blocks[i];
        for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
            for (std::uint32_t x = block.x; x < block.x + block.width; ++x)
                periodic(x, y) = {float(i % 16) / 16.0f, float(x % 2), float(y % 4)};
    }
    const auto result = compress_blocks(atlas, periodic, 0.001);
    EXPECT_EQ(result.notes.places, 16u);
    EXPECT_EQ(result.notes.texels_after, 16u * 16u * 16u);
    EXPECT_EQ(result.notes.largest_error, 0.0);
}

TEST(CompressBlocks, LookupsStayWithinTheError) {
    for (const auto& [name, mesh] : made::all()) {
        SCOPED_TRACE(name);
        const Atlas atlas = quad_of(mesh, 128);
        const Image<RgbF> image =
            picture(mesh, atlas, [](const Vec3d& p) { return 0.5 + 0.4 * std::sin(p.x + p.y); });
        std::uint64_t last = ~0ull;
        for (const double error : {0.0, 0.02, 0.1, 1.0}) {
            const auto result = compress_blocks(atlas, image, error);
            EXPECT_LE(result.notes.largest_error, error);
            EXPECT_LE(result.notes.texels_after, last);
            last = result.notes.texels_after;
            const Image<Vec3f> before = floats(image), after = floats(result.image);
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                for (const Vec3d& w : {Vec3d(1, 0, 0), Vec3d(0, 0.5, 0.5), Vec3d(0.2, 0.3, 0.5)}) {
                    const auto at = [&](const Atlas& a) {
                        const auto& c = a.corners[t];
                        return w.x * c[0] + w.y * c[1] + w.z * c[2];
                    };
                    const Vec3d off =
                        glm::abs(bilinear(before, at(atlas)) - bilinear(after, at(result.atlas)));
                    EXPECT_LE(std::max({off.x, off.y, off.z}), error + 1e-6);
                }
        }
        // Blocks of the same sides all share one place, if that makes the texture smaller.
        if (last < 128u * 128u) {
            EXPECT_EQ(compress_blocks(atlas, image, 1.0).notes.places, sides_of(atlas).size());
        }
    }
}

TEST(CompressBlocks, DifferentBlocksStayApartAndOtherKindsAreRefused) {
    const Mesh mesh = made::ball(2);
    const Atlas atlas = quad_of(mesh, 64);
    Image<Rgb16> image(64, 64);
    std::uint32_t seed = 1;
    for (std::size_t y = 0; y < 64; ++y)
        for (Rgb16& p : image.row(y))
            p.g = std::uint16_t((seed = seed * 1664525u + 1013904223u) >> 16);
    const auto result = compress_blocks(atlas, image, 0.01);
    EXPECT_EQ(result.image, image);
    EXPECT_EQ(result.notes.places, result.notes.blocks);
    EXPECT_EQ(result.atlas.corners, atlas.corners);
    const Atlas area = layout_atlas(mesh, made::neighbours_by_brute_force(mesh),
                                    {AtlasKind::area, Overscan::bilinear, 64});
    EXPECT_THROW(compress_blocks(area, image, 0.01), Error);
}

TEST(PackBlocks, FillsARectangleWithoutOverlap) {
    std::vector<PackedBlock> blocks;
    for (int i = 0; i < 300; ++i) blocks.push_back({i * 7 % 5, i * 11 % 4, 0, 0});
    const PackedSize size = pack_blocks(blocks, 256);
    std::vector<int> taken(std::size_t(size.width) * size.height, 0);
    for (const PackedBlock& b : blocks) {
        EXPECT_EQ(b.x % (1u << b.log_width), 0u);
        EXPECT_EQ(b.y % (1u << b.log_height), 0u);
        ASSERT_LE(b.x + (1u << b.log_width), size.width);
        ASSERT_LE(b.y + (1u << b.log_height), size.height);
        for (std::uint32_t y = 0; y < 1u << b.log_height; ++y)
            for (std::uint32_t x = 0; x < 1u << b.log_width; ++x)
                EXPECT_EQ(taken[(b.y + y) * size.width + b.x + x]++, 0);
    }
    const auto used = std::count(taken.begin(), taken.end(), 1);
    EXPECT_GT(double(used), 0.95 * double(taken.size()));
}

}  // namespace
}  // namespace burl
