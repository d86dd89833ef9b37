// Streams of coordinates against float64, kernels on them against the same additions one by one to
// the bit and against float64, sums of octaves against the float64 field.
#include "procedural/kernels/stream_kernels.h"

#include <array>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "procedural/field/octave_streams.h"
#include "procedural/kernels/quadric_kernel.h"
#include "procedural/kernels/share_kernels.h"
#include "procedural/noise/noise.h"
#include "procedural/noise/perlin_noise.h"
#include "tests/procedural/support/random_batch.h"

namespace burl {
namespace {

using test::NoiseName;
using test::piece;
using test::random_vector;
constexpr auto& stream_kernels_noises = test::shared_noises;

/// Pieces of 1 to 40 texels, near and far, slow and fast; 0 where `far` is false.
std::vector<Piece> random_pieces(std::mt19937& random, bool far) {
    std::vector<Piece> pieces;
    std::size_t left = batch_capacity;
    while (left > 0) {
        const std::size_t count = std::min<std::size_t>(left, 1 + random() % 40);
        const double first = double(random() % 100);
        const double reach = far && random() % 3 == 0 ? 1e8 : 30.0;
        const double step = far && random() % 5 == 0 ? 1e5 : std::ldexp(1.0, -int(random() % 8));
        const Vec3d start = random_vector(random, reach);
        pieces.push_back(
            piece(start, random_vector(random, step), first, count, first + double(count)));
        left -= count;
    }
    return pieces;
}

template <class Visit>
void for_each_texel(const std::vector<Piece>& pieces, const Affine3& map, Visit&& visit) {
    std::size_t at = 0;
    for (const Piece& p : pieces)
        for (std::size_t j = 0; j < p.solid.count; ++j)
            visit(at++, map(p.solid.start + (p.solid.first + double(j)) * p.solid.step));
}

const Affine3 stream_kernels_oblique{Mat3d(1.5, 0.25, 0, -0.75, 2, 0.5, 0, 0.125, 1),
                                     Vec3d(0.3, -7.0, 100.0)};

TEST(LatticeStream, HoldsCoordinatesTo2ToTheMinus32) {
    std::mt19937 random(5);
    const auto stream = std::make_unique<LatticeStream>();
    for (int i = 0; i < 30; ++i) {
        const std::vector<Piece> pieces = random_pieces(random, true);
        fill_stream(stream_kernels_oblique, 3, pieces, *stream);
        std::vector<double> size_at;  // of what is added up to a coordinate
        for (const Piece& p : pieces) {
            const double start = glm::length(p.solid.start), step = glm::length(p.solid.step);
            size_at.insert(size_at.end(), p.solid.count, 100.0 + 3.0 * (start + p.length * step));
        }
        for_each_texel(pieces, stream_kernels_oblique, [&](std::size_t at, const Vec3d& p) {
            for (int axis = 0; axis < 3; ++axis) {
                const std::uint64_t bits = stream->at(axis, at);
                const double x = double(std::int32_t(bits >> 32)) + double(bits << 32) * 0x1p-64;
                const double rest = p[axis] - x;
                const double wrapped = rest - 0x1p32 * std::round(rest * 0x1p-32);
                ASSERT_NEAR(wrapped, 0.0, 0x1p-32 + 0x1p-50 * size_at[at]) << at;
            }
        });
    }
}

TEST(LatticeStream, CarriesIntoTheCellWhereAPlaceRoundsToOne) {
    // x runs over too many cells for the fast path, so that y just below 0 takes the other one,
    // too.
    const std::vector<Piece> pieces{piece({0.5, -1e-17, 0.25}, {1e6, 0.0, 0.0}, 0.0, 4, 4.0)};
    const auto stream = std::make_unique<LatticeStream>();
    fill_stream(Affine3{}, 0, pieces, *stream);
    for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_EQ(stream->at(0, j), (std::uint64_t(j * 1000000) << 32) + 0x80000000u);
        EXPECT_EQ(stream->at(1, j), 0u) << "y is 0 to 2^-32, not a cell below it";
        EXPECT_EQ(stream->at(2, j), 0x40000000u);
    }
}

TEST(LatticeStream, StaysAtTheOriginWhereFloat64EndsAfterDoublings) {
    const auto stream = std::make_unique<LatticeStream>();
    const double far = 0x1p49 + 5.0;
    const auto cell = [&](int doublings) {
        fill_stream({}, doublings, std::vector{piece({far, 0, 0}, {0, 0, 0}, 0, 1, 1)}, *stream);
        return std::uint32_t(stream->at(0, 0) >> 32);
    };
    EXPECT_EQ(cell(1), 5u);
    EXPECT_EQ(cell(2), 0u);
}

TEST(LatticeStream, DoesNotDependOnHowSpansAreCut) {
    const auto whole = std::make_unique<LatticeStream>(), parts = std::make_unique<LatticeStream>();
    for (const double step : {0.01, 3.0, 1e4, 0x1p45}) {
        const Vec3d start(0.1, -5e5, 1e9), steps(step, -0.3 * step, 0.77);
        const auto cut = [&](double first, std::size_t count) {
            return piece(start, steps, first, count, 100.0);
        };
        fill_stream(stream_kernels_oblique, 5, std::vector{cut(0, 100)}, *whole);
        fill_stream(stream_kernels_oblique, 5, std::vector{cut(0, 3), cut(3, 37), cut(40, 60)},
                    *parts);
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t j = 0; j < 100; ++j)
                ASSERT_EQ(whole->at(axis, j), parts->at(axis, j)) << step;
    }
}

/// The corners' numbers in float32, times 2^31 or slopes at twice the distance.
float corner_number(NoiseKind kind, std::uint32_t hash, const std::array<float, 3>& twice_offset) {
    if (kind == NoiseKind::value) return float(std::int32_t(hash & 0xffffff00u));
    NoiseValue<float, 3> slope;
    set_perlin_slope(hash >> 28, twice_offset, slope);
    return slope.value;
}

float faded(Fade fade, float t) {
    if (fade == Fade::linear) return t;
    const float square = t * t;
    if (fade == Fade::smooth) return t * (1.5f - 0.5f * square);
    return t * (1.875f - square * (1.25f - 0.375f * square));
}

/// The noise that kernels have to give at a texel, in float32 in the order of their additions.
float expected_noise(const NoiseName& k, const StreamOctave& octave,
                     const std::array<std::uint64_t, 3>& coordinates) {
    std::array<std::uint32_t, 3> cell{};
    float t[3], v[3], corners[8];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint64_t x = coordinates[axis] << octave.doublings;
        cell[axis] = std::uint32_t(x >> 32);
        t[axis] = float(std::int32_t(std::uint32_t(x) ^ 0x80000000u)) * 0x1p-31f;
        v[axis] = faded(k.fade, t[axis]);
    }
    for (std::uint32_t c = 0; c < 8; ++c) {
        const std::array index{cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)};
        std::array<float, 3> offset{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            offset[axis] = t[axis] + (c >> axis & 1 ? -1.0f : 1.0f);
        corners[c] = corner_number(k.kind, LatticeHash::bits(index, octave.seed), offset);
    }
    const auto twice = [](float w, float a, float b) { return (a + b) + w * (b - a); };
    const auto plane = [&](const float* c) {
        if (k.kind == NoiseKind::perlin)
            return twice(v[1], twice(v[0], c[0], c[1]), twice(v[0], c[2], c[3]));
        const float low = c[0] + c[1], high = c[2] + c[3], low_x = c[1] - c[0],
                    high_x = c[3] - c[2];
        return ((low + high) + v[0] * (low_x + high_x)) +
               v[1] * ((high - low) + v[0] * (high_x - low_x));
    };
    return octave.weight * twice(v[2], plane(corners), plane(corners + 4));
}

TEST(StreamKernels, GiveTheBitsOfTheSameAdditionsInTurn) {
    std::mt19937 random(6);
    const auto stream = std::make_unique<LatticeStream>();
    alignas(64) float sums[batch_capacity + batch_padding];
    for (const NoiseName& k : stream_kernels_noises)
        for (int doublings : {0, 1, 7, 23}) {
            fill_stream(stream_kernels_oblique, doublings, random_pieces(random, doublings < 8),
                        *stream);
            const StreamOctave octave{std::uint32_t(random()), doublings, 0.7f};
            std::fill(std::begin(sums), std::end(sums), 0.0f);
            direct_kernel(k.kind, k.fade)(octave, *stream, nullptr, batch_capacity, sums, nullptr);
            for (std::size_t j = 0; j < batch_capacity; ++j)
                ASSERT_EQ(sums[j],
                          expected_noise(k, octave,
                                         {stream->at(0, j), stream->at(1, j), stream->at(2, j)}))
                    << doublings;
        }
}

/// One octave's noise against float64 at the same cells and places.
TEST(StreamKernels, ErrAtMostAsTheirCommentSays) {
    std::mt19937 random(11);
    const auto stream = std::make_unique<LatticeStream>();
    alignas(64) float sums[batch_capacity + batch_padding];
    for (const NoiseName& k : stream_kernels_noises) {
        NoiseSpec noise;
        noise.kind = k.kind, noise.fade = k.fade, noise.seed = 77;
        double worst = 0.0;
        for (int i = 0; i < 20; ++i) {
            fill_stream(stream_kernels_oblique, 2, random_pieces(random, false), *stream);
            std::fill(std::begin(sums), std::end(sums), 0.0f);
            direct_kernel(k.kind, k.fade)({noise.seed, 2, 1.0f}, *stream, nullptr, batch_capacity,
                                          sums, nullptr);
            for (std::size_t j = 0; j < batch_capacity; ++j) {
                const auto at = [&](int axis) {
                    const std::uint64_t x = stream->at(axis, j) << 2;
                    return double(std::int32_t(x >> 32)) + double(std::uint32_t(x)) * 0x1p-32;
                };
                const double exact = noise_value<double, 3>(noise, {at(0), at(1), at(2)});
                const double error = std::abs(double(sums[j]) * stream_unit(k.kind) - exact);
                worst = std::max(worst, error / (1.0 + std::abs(exact)));
            }
        }
        EXPECT_LT(worst, k.kind == NoiseKind::perlin ? 2.2e-7 : 1.7e-7) << int(k.fade);
        EXPECT_GT(worst, 2e-8) << "too good to be float32";
    }
}

/// Vectors of texels in one cell and in several, runs that end at a batch's end, short batches.
TEST(StreamKernels, SharedCornersGiveTheBitsOfDirectOnes) {
    std::mt19937 random(7);
    const auto stream = std::make_unique<LatticeStream>();
    const auto runs = std::make_unique<CellRuns>();
    std::vector<float> sums[2];
    for (const NoiseName& k : stream_kernels_noises)
        for (int i = 0; i < 24; ++i) {
            const int doublings = i % 8, finer = i % 3;
            const std::vector<Piece> pieces = random_pieces(random, i % 2 == 0);
            fill_stream(stream_kernels_oblique, doublings + finer, pieces, *stream);
            const std::size_t count = i < 8 ? batch_capacity : 1 + random() % batch_capacity;
            find_runs(*stream, doublings + finer, count, *runs);
            const StreamOctave octave{std::uint32_t(random()), doublings, 0.7f};
            for (auto& s : sums) s.assign(batch_capacity + batch_padding + 16, 0.25f);
            const auto aligned = [](std::vector<float>& s) {
                void* at = s.data();
                std::size_t space = s.size() * sizeof(float);
                return static_cast<float*>(std::align(64, 1, at, space));
            };
            direct_kernel(k.kind, k.fade)(octave, *stream, nullptr, count, aligned(sums[0]),
                                          nullptr);
            sharing_kernel(k.kind, k.fade, false)(octave, *stream, runs.get(), count,
                                                  aligned(sums[1]), nullptr);
            for (std::size_t j = 0; j < count; ++j)
                ASSERT_EQ(aligned(sums[0])[j], aligned(sums[1])[j]) << i << " " << j;
        }
}

TEST(StreamKernels, FindRunsOfTexelsInOneCell) {
    std::mt19937 random(8);
    const auto stream = std::make_unique<LatticeStream>();
    const auto runs = std::make_unique<CellRuns>();
    for (int doublings : {0, 1, 5, 23}) {
        fill_stream(stream_kernels_oblique, doublings, random_pieces(random, true), *stream);
        const std::size_t count = 900;
        find_runs(*stream, doublings, count, *runs);
        std::int32_t run = -1;
        for (std::size_t j = 0; j < count; ++j) {
            bool same = j > 0;
            for (int axis = 0; axis < 3; ++axis)
                same = same && stream->at(axis, j) >> (32 - doublings) ==
                                   stream->at(axis, j - 1) >> (32 - doublings);
            if (!same) {
                ++run;
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_EQ(runs->first.at(axis, std::size_t(run)), stream->at(axis, j));
            }
            ASSERT_EQ(runs->run[j], std::uint32_t(run)) << j;
        }
        EXPECT_EQ(runs->count, std::size_t(run) + 1);
    }
}

TEST(StreamKernels, WeighOctaves) {
    std::mt19937 random(6);
    const auto stream = std::make_unique<LatticeStream>();
    fill_stream({}, 0, random_pieces(random, false), *stream);
    alignas(64) float once[batch_capacity + batch_padding] = {}, twice[std::size(once)] = {};
    direct_kernel(NoiseKind::value, Fade::smooth)({3, 0, 1.0f}, *stream, nullptr, 500, once,
                                                  nullptr);
    direct_kernel(NoiseKind::value, Fade::smooth)({3, 0, 0.75f}, *stream, nullptr, 500, twice,
                                                  nullptr);
    direct_kernel(NoiseKind::value, Fade::smooth)({3, 0, -0.25f}, *stream, nullptr, 500, twice,
                                                  nullptr);
    for (std::size_t j = 0; j < 500; ++j) EXPECT_FLOAT_EQ(twice[j], 0.5f * once[j]);
}

TEST(StreamKernels, AddSums) {
    alignas(64) float sums[4 + batch_padding] = {1.0f, -2.0f, 0.5f, 0.25f};
    double values[4 + batch_padding] = {10.0, 20.0, 30.0, 40.0};
    add_sums(-4.0, sums, 4, values);
    EXPECT_EQ(std::vector<double>(values, values + 4), (std::vector{6.0, 28.0, 28.0, 39.0}));
}

TEST(OctaveStreams, SumOctavesAsTheReferenceDoes) {
    std::mt19937 random(8);
    const auto buffers = std::make_unique<StreamBuffers>();
    for (int i = 0; i < 24; ++i) {
        Texture texture;
        NoiseTerm term;
        term.kind = i % 4 == 3 ? NoiseKind::perlin : NoiseKind::value;
        term.fade = Fade(i % 3);
        term.octaves = 1 + std::uint32_t(random() % 10);
        term.gain = i % 2 ? 0.5 : 0.3;
        term.phase = i % 5 == 0 ? random_vector(random, 3.0) : Vec3d(0.0);
        term.seed = std::uint32_t(random());
        term.range = NoiseRange::bipolar;
        texture.noise = {term, term};
        texture.noise[1].frequency = {2, 3, 4};
        texture.noise[1].shape = i % 6 == 1 ? OctaveShape::absolute : OctaveShape::plain;
        std::vector<Octave> octaves = expand_octaves(texture);
        const std::vector<Piece> pieces = random_pieces(random, false);
        std::vector<double> values(batch_capacity + batch_padding, 0.0);
        OctaveStreams(octaves, Kernel(i % 3)).add(pieces, batch_capacity, *buffers, values.data());
        std::erase_if(octaves, [](const Octave& octave) { return !has_kernel(octave); });
        double amplitudes = 0.0;
        for (const Octave& octave : octaves) amplitudes += std::abs(octave.scale);
        for_each_texel(pieces, {}, [&](std::size_t at, const Vec3d& p) {
            const double exact = evaluate_field({}, octaves, p);
            ASSERT_NEAR(values[at], exact, 2.5e-7 * (std::abs(exact) + amplitudes)) << i;
        });
    }
}

TEST(OctaveStreams, TakeLongChainsOfOctavesApart) {
    Texture texture;
    NoiseTerm first;
    first.octaves = 24, first.frequency = Vec3d(0x1p-10);
    NoiseTerm second = first;  // goes on where the first ends
    second.frequency = Vec3d(0x1p14), second.amplitude = 0x1p-24;
    texture.noise = {first, second};
    const std::vector<Octave> octaves = expand_octaves(texture);
    double offsets = 0.0;
    for (const Octave& octave : octaves) offsets += octave.offset;
    std::mt19937 random(10);
    const std::vector<Piece> pieces = random_pieces(random, false);
    const auto buffers = std::make_unique<StreamBuffers>();
    for (const auto& [name, kernel] : kernel_names) {
        std::vector<double> values(batch_capacity + batch_padding, 0.0);
        OctaveStreams(octaves, kernel).add(pieces, batch_capacity, *buffers, values.data());
        for_each_texel(pieces, {}, [&](std::size_t at, const Vec3d& p) {
            ASSERT_NEAR(values[at], evaluate_field({}, octaves, p) - offsets, 2.5e-7) << name;
        });
    }
}

TEST(QuadricKernel, FillsParabolas) {
    std::vector<double> values(batch_capacity + batch_padding);
    fill_parabolas(std::vector<ParabolaLine>{{1.0, 2.0, 3.0, 0.0, 5}, {0.5, 0.25, -1.0, 10.0, 3}},
                   values.data());
    const std::vector<double> expected{
        1, 6, 17, 34, 57, 0.5 + 2.5 - 100, 0.5 + 2.75 - 121, 0.5 + 3 - 144};
    for (std::size_t j = 0; j < expected.size(); ++j) EXPECT_EQ(values[j], expected[j]);
}

TEST(QuadricKernel, GivesTheQuadricAlongLines) {
    const Quadric q{1.5, -2, 0.25, 3, -0.75, 1, 2, 0.5, -1, 7};
    std::mt19937 random(9);
    const std::vector<Piece> pieces = random_pieces(random, false);
    std::vector<ParabolaLine> parabolas(pieces.size());
    make_parabolas(q, 0.125, pieces, parabolas);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const LatticeLine& line = pieces[i].solid;
        const auto& [c0, c1, c2, first, count] = parabolas[i];
        EXPECT_EQ(first, line.first);
        EXPECT_EQ(count, line.count);
        for (const double x : {0.0, 1.0, first + double(count)}) {
            const Vec3d s = line.start + x * line.step;
            const double size = 10.0 * (1.0 + glm::dot(line.start, line.start) +
                                        x * x * glm::dot(line.step, line.step));
            EXPECT_NEAR(c0 + x * (c1 + x * c2), evaluate_quadric(q, s) + 0.125, 1e-14 * size);
        }
    }
}

}  // namespace
}  // namespace burl
