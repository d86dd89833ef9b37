// Lines of spans are those of the pieces that a synthesis from scratch makes, and coordinates along
// them have the same bits; what is cached of them stays within the budget.
#include "procedural/cache/span_line_cache.h"

#include <memory>

#include <gtest/gtest.h>

#include "procedural/cache/synthesis.h"
#include "procedural/fill/pieces.h"
#include "procedural/fill/synthesize.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

const Affine3 map{2.0 * Mat3d(1.0), Vec3d(0.5, 0.0, -3.0)};

/// An atlas of rows shorter than a batch, or of two rows that are longer.
SolidAtlas atlas_of(std::uint32_t size) {
    SolidAtlas solid = SyntheticAtlas{size, size > 1000 ? 700u : 11u, 10.0, 0.02, true}.make(3);
    if (size < 1000) return solid;
    for (std::size_t y = 2; y <= size; ++y) solid.row_begin[y] = solid.row_begin[2];
    solid.spans.resize(solid.row_begin[2]);
    return solid;
}

/// Calls visit(pieces, lines) for every batch.
template <class Visit>
void for_each_batch(const SolidAtlas& solid, const Visit& visit) {
    const std::vector<TexelMap> maps = moved_maps(solid.maps, map, 1);
    SpanLineCache cached(solid);
    cached.allot();
    const auto batch = std::make_unique<FieldBatch>();
    for (int time = 0; time < 2; ++time)
        for (std::size_t y = 0; y < solid.size; ++y) {
            std::vector<std::vector<Piece>> batches;
            PieceReader pieces(solid, maps, {y, y + 1});
            while (pieces.read(*batch)) batches.push_back(batch->pieces);
            std::size_t at = 0;
            cached.for_each_batch(y, maps, [&](const SpanLines& lines) {
                ASSERT_LT(at, batches.size());
                visit(batches[at++], lines);
            });
            ASSERT_EQ(at, batches.size());
        }
}

TEST(SpanLineCache, AreThoseOfTheRowsPieces) {
    for (const std::uint32_t size : {40u, 2300u})
        for_each_batch(atlas_of(size),
                       [&](const std::vector<Piece>& pieces, const SpanLines& lines) {
                           ASSERT_EQ(lines.spans, pieces.size());
                           std::size_t at = 0;
                           for (std::size_t i = 0; i < pieces.size(); ++i) {
                               const LatticeLine line = lines.line(i, at), &solid = pieces[i].solid;
                               ASSERT_EQ(line.start, solid.start);
                               ASSERT_EQ(line.step, solid.step);
                               ASSERT_EQ(line.first, solid.first);
                               ASSERT_EQ(line.count, solid.count);
                               ASSERT_EQ(double(lines.counts[i]), pieces[i].length);
                               at += line.count;
                           }
                           ASSERT_EQ(at, lines.texels);
                       });
}

/// Near the lattice's origin, near its cells' only, and too far for either.
TEST(SpanLineCache, HaveTheCoordinatesOfPieces) {
    const auto expected = std::make_unique<LatticeStream>(),
               stream = std::make_unique<LatticeStream>();
    const Mat3d turn(1.5, 0.25, 0, -0.75, 2, 0.5, 0, 0.125, 1);
    for (const double far : {0.0, 1e6, 1e300})
        for (const double scale : {1.0, 1e5})
            for (const double period : {0.0, 4096.0})
                for_each_batch(atlas_of(40), [&](const auto& pieces, const SpanLines& lines) {
                    const Affine3 lattice{scale * turn, Vec3d(0.3, far, -7.0)};
                    const double planes = fill_stream(lattice, 2, pieces, *expected, period);
                    ASSERT_EQ(fill_stream(lattice, 2, lines, *stream, period), planes);
                    for (int axis = 0; axis < 3; ++axis)
                        for (std::size_t j = 0; j < lines.texels; ++j)
                            ASSERT_EQ(stream->at(axis, j), expected->at(axis, j));
                });
}

Texture two_terms() {
    Texture texture;
    texture.quadric.i = 0.5;
    texture.noise.resize(2);
    texture.noise[1].phase.x = 0.25;
    texture.colors.stops = {{0.0, {244, 239, 230}}, {1.0, {59, 58, 64}}};
    return texture;
}

/// Bytes that are cached more once an octave moves; the texture is that from scratch.
std::size_t cached_by_a_move(const SolidAtlas& solid, CachedSynthesis& cached) {
    Image<Rgb8> image;
    Texture texture = two_terms();
    cached.synthesize(texture, 1, image);
    const std::size_t bytes = cached.bytes();
    texture.noise[1].phase.x = 0.5;
    cached.synthesize(texture, 1, image);
    EXPECT_EQ(image, synthesize_model<Rgb8>(solid, texture, map, 1));
    return cached.bytes() - bytes;
}

TEST(SpanLineCache, AreCachedOnceAnOctaveMoves) {
    const SolidAtlas solid = atlas_of(40);
    const std::size_t lines = SpanLineCache(solid).bytes_wanted();
    EXPECT_GE(lines, 52 * solid.spans.size());
    CachedSynthesis roomy(solid, map, std::size_t(1) << 30);
    EXPECT_EQ(cached_by_a_move(solid, roomy), lines);
    const std::size_t without = roomy.bytes() - lines;
    CachedSynthesis tight(solid, map, without);
    EXPECT_EQ(cached_by_a_move(solid, tight), 0u);
    EXPECT_EQ(tight.bytes(), without);
}

TEST(SpanLineCache, AreNotThoseOfAnAtlasThatWasCut) {
    SolidAtlas solid = atlas_of(40);
    for (const Span& span : solid.spans) solid.wholes.push_back({span.x, span.count});
    CachedSynthesis cached(solid, map, std::size_t(1) << 30);
    EXPECT_EQ(cached_by_a_move(solid, cached), 0u);
}

}  // namespace
}  // namespace burl
