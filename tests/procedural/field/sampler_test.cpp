// The field of a batch against the float64 definition: its slopes, its values beside the texels'
// centres, and what is left of it where texels cannot show all octaves.
#include "procedural/field/sampler.h"

#include <memory>

#include <gtest/gtest.h>

#include "procedural/model/band_limit.h"
#include "tests/procedural/support/random_batch.h"

namespace burl {
namespace {

using test::for_each_texel;
using test::random_batch;
using test::random_vector;

/// Terms of every kind with a kernel, in chains and by themselves, and some without one.
Texture field_sampler_random_texture(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Texture texture;
    Quadric& q = texture.quadric;
    for (double* c : {&q.a, &q.b, &q.c, &q.d, &q.e, &q.f, &q.g, &q.h, &q.i, &q.j})
        *c = 0.1 * unit(random);
    texture.noise.resize(1 + random() % 3);
    for (NoiseTerm& term : texture.noise) {
        term.kind = random() % 3 ? NoiseKind::value : NoiseKind::perlin;
        term.fade = Fade(random() % 3);
        term.amplitude = unit(random);
        term.frequency = 3.0 * random_vector(random, 1.0);
        term.phase = random() % 2 ? random_vector(random, 5.0) : Vec3d(0.0);
        term.seed = std::uint32_t(random());
        term.octaves = 1 + std::uint32_t(random() % 5);
        term.gain = random() % 3 ? 0.5 : 0.8;
        term.shape = random() % 4 ? OctaveShape::plain : OctaveShape::absolute;
    }
    return texture;
}

std::unique_ptr<FieldBatch> batch_of(const std::vector<Piece>& pieces) {
    auto batch = std::make_unique<FieldBatch>();
    batch->pieces = pieces;
    batch->count = batch_capacity;
    return batch;
}

std::vector<double> field_of(const FieldBatch& batch) {
    return {batch.field, batch.field + batch.count};
}

/// The largest error of f: 3e-7 of every amplitude, and up to 1e-6 of octaves without a kernel.
double error_of(const std::vector<Octave>& octaves) {
    double sum = 0.1;
    for (const Octave& octave : octaves) sum += std::abs(octave.scale);
    return 1e-6 * sum;
}

TEST(FieldSampler, SlopesAreTheReferencesAndLeaveNoTraceInTheValues) {
    std::mt19937 random(21);
    for (int i = 0; i < 20; ++i) {
        const Texture texture = field_sampler_random_texture(random);
        const std::vector<Octave> octaves = expand_octaves(texture);
        const std::vector<Piece> pieces = random_batch(random, 3.0, 0.1);
        const auto points = batch_of(pieces);
        FieldSampler(texture, false).values(*points);
        for (const Kernel kernel : {Kernel::automatic, Kernel::direct, Kernel::share}) {
            const auto batch = batch_of(pieces);
            FieldSampler(texture, false, kernel).values_and_slopes(*batch);
            EXPECT_EQ(field_of(*batch), field_of(*points)) << i;
            for_each_texel(pieces, [&](std::size_t at, const Piece& piece, const Vec3d& p) {
                const FieldSample exact = sample_field<double>(texture.quadric, octaves, p);
                // Gradients err by 2e-6 in every octave's own cells.
                double error = 1e-6;
                for (const Octave& octave : octaves)
                    error += 4e-6 * std::abs(octave.scale) *
                             (glm::length(octave.lattice_from_solid.linear * piece.solid.step) +
                              glm::length(octave.lattice_from_solid.linear * piece.down));
                ASSERT_NEAR(batch->slopes.u[at], glm::dot(exact.gradient, piece.solid.step), error);
                ASSERT_NEAR(batch->slopes.v[at], glm::dot(exact.gradient, piece.down), error);
            });
        }
    }
}

TEST(FieldSampler, TakesValuesBesideTheCentres) {
    std::mt19937 random(22);
    std::uniform_real_distribution<float> offset(-1.0f, 1.0f);
    for (int i = 0; i < 20; ++i) {
        const Texture texture = field_sampler_random_texture(random);
        const std::vector<Octave> octaves = expand_octaves(texture);
        const std::vector<Piece> pieces = random_batch(random, 3.0, i % 4 == 0 ? 1e4 : 0.5);
        const auto batch = batch_of(pieces);
        for (std::size_t j = 0; j < batch_capacity; ++j)
            batch->offsets.u[j] = offset(random), batch->offsets.v[j] = offset(random);
        FieldSampler(texture, false, Kernel(i % 3)).values_at_offsets(*batch);
        for_each_texel(pieces, [&](std::size_t at, const Piece& piece, const Vec3d& centre) {
            const Vec3d p = centre + double(batch->offsets.u[at]) * piece.solid.step +
                            double(batch->offsets.v[at]) * piece.down;
            const double exact = evaluate_field(texture.quadric, octaves, p);
            ASSERT_NEAR(batch->field[at], exact, error_of(octaves) + 1e-12 * glm::dot(p, p)) << i;
        });
    }
}

TEST(FieldSampler, OffsetsOfZeroAreTheCentres) {
    std::mt19937 random(23);
    Texture texture = field_sampler_random_texture(random);
    texture.quadric = {};  // along lines by another formula
    const auto centres = batch_of(random_batch(random, 3.0, 0.1));
    const auto batch = batch_of(centres->pieces);
    std::fill_n(batch->offsets.u, batch_capacity, 0.0f);
    std::fill_n(batch->offsets.v, batch_capacity, 0.0f);
    const FieldSampler sampler(texture, false);
    sampler.values(*centres);
    sampler.values_at_offsets(*batch);
    EXPECT_EQ(field_of(*batch), field_of(*centres));
}

/// The definition: octaves weighed by what a texel shows of them. `rest` is the mean of what it
/// does not show, with the offsets.
std::vector<Octave> limited(std::vector<Octave> octaves, const Piece& piece, double& rest) {
    rest = 0.0;
    for (Octave& octave : octaves) {
        const Mat3d& map = octave.lattice_from_solid.linear;
        const double weight = band_weight(map * piece.solid.step, map * piece.down);
        rest += octave.offset + (1.0 - weight) * octave_mean(octave);
        octave.scale *= weight, octave.offset = 0.0;
    }
    return octaves;
}

TEST(FieldSampler, LeavesOutOfAnOctaveWhatATexelCannotShow) {
    std::mt19937 random(24);
    for (int i = 0; i < 12; ++i) {
        const Texture texture = field_sampler_random_texture(random);
        const std::vector<Octave> all = expand_octaves(texture);
        const std::vector<Piece> pieces = random_batch(random, 3.0, 0.5);
        const auto values = batch_of(pieces), slopes = batch_of(pieces);
        const FieldSampler sampler(texture, true, Kernel(i % 3));
        sampler.values(*values);
        sampler.values_and_slopes(*slopes);
        EXPECT_EQ(field_of(*values), field_of(*slopes));
        double rest = 0.0;
        std::vector<Octave> octaves;
        const Piece* before = nullptr;
        for_each_texel(pieces, [&](std::size_t at, const Piece& piece, const Vec3d& p) {
            if (&piece != before) octaves = limited(all, piece, rest);
            before = &piece;
            const FieldSample exact = sample_field<double>(texture.quadric, octaves, p);
            ASSERT_NEAR(values->field[at], exact.value + rest, error_of(all)) << i;
            double error = 1e-6;
            for (const Octave& octave : octaves) error += 4e-6 * std::abs(octave.scale);
            ASSERT_NEAR(slopes->slopes.u[at], glm::dot(exact.gradient, piece.solid.step), error);
            ASSERT_NEAR(slopes->slopes.v[at], glm::dot(exact.gradient, piece.down), error);
        });
    }
}

TEST(FieldSampler, LeavesNothingOutOfLargeOctaves) {
    std::mt19937 random(25);
    Texture texture = field_sampler_random_texture(random);
    const std::vector<Piece> pieces = random_batch(random, 3.0, 1e-3);
    const auto all = batch_of(pieces), limited = batch_of(pieces);
    FieldSampler(texture, false).values_and_slopes(*all);
    FieldSampler(texture, true).values_and_slopes(*limited);
    EXPECT_EQ(field_of(*limited), field_of(*all));
    EXPECT_TRUE(std::equal(all->slopes.u, all->slopes.u + batch_capacity, limited->slopes.u));
}

}  // namespace
}  // namespace burl
