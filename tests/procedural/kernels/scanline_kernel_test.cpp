// Scan-line polynomials against the definition in float64: any step, start and length, planes,
// edges and corners hit exactly, spans cut anywhere, every instruction set.
#include "procedural/kernels/scanline_kernel.h"

#include <memory>
#include <random>

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include "procedural/field/octave_streams.h"
#include "procedural/noise/noise.h"
#include "procedural/numbers/simd_target.h"
#include "tests/procedural/support/random_batch.h"

namespace burl {
namespace {

using test::NoiseName;
using test::piece;
using test::random_vector;
constexpr auto& noises = test::shared_noises;

double error_of(NoiseKind kind) {
    return kind == NoiseKind::perlin ? 2.5e-7 : 2.0e-7;
}

class Scan {
  public:
    /// The octave at the pieces' texels, batch_capacity at most.
    std::vector<float> operator()(const NoiseName& noise, const StreamOctave& octave,
                                  const std::vector<Piece>& pieces, const Affine3& map = {}) {
        map_scan_lines(map, octave.doublings, pieces, lines_);
        std::fill(std::begin(sums_), std::end(sums_), 0.0f);
        std::size_t count = 0;
        for (const Piece& p : pieces) count += p.solid.count;
        add_octave_scanline(noise.kind, noise.fade, octave, lines_, *segments_, sums_);
        return {sums_, sums_ + count};
    }

    /// A whole span, in pieces of batch_capacity.
    std::vector<float> span(const NoiseName& noise, const StreamOctave& octave, const Vec3d& start,
                            const Vec3d& step, std::size_t length) {
        std::vector<float> values;
        for (std::size_t first = 0; first < length; first += batch_capacity) {
            const std::size_t count = std::min(length - first, batch_capacity);
            const std::vector<float> part =
                (*this)(noise, octave, {piece(start, step, double(first), count, double(length))});
            values.insert(values.end(), part.begin(), part.end());
        }
        return values;
    }

  private:
    std::vector<ScanLine> lines_;
    std::unique_ptr<ScanSegments> segments_ = std::make_unique<ScanSegments>();
    alignas(64) float sums_[batch_capacity + batch_padding];
};

/// Largest error of a span as a share of what it may be.
double worst_share(Scan& scan, const NoiseName& noise, const StreamOctave& octave,
                   const Vec3d& start, const Vec3d& step, std::size_t length) {
    const std::vector<float> values = scan.span(noise, octave, start, step, length);
    const double finer = std::ldexp(1.0, octave.doublings);
    double worst = 0.0;
    for (std::size_t j = 0; j < length; ++j) {
        const Vec3d p = finer * (start + double(j) * step);
        const double exact =
            noise_value<double, 3>({noise.kind, noise.fade, {}, 0.6, octave.seed}, {p.x, p.y, p.z});
        const double far = std::max({1.0, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        const double bound = error_of(noise.kind) * (1.0 + std::abs(exact)) + far * 0x1p-50;
        const double error = std::abs(double(values[j]) * stream_unit(noise.kind) - exact);
        worst = std::max(worst, error / bound);
    }
    return worst;
}

TEST(ScanlineKernel, IsTheNoiseOnEveryLine) {
    std::mt19937 random(11);
    Scan scan;
    for (const NoiseName& noise : noises)
        for (const double size : {0x1p-40, 1e-9, 0x1p-14, 0x1p-9, 0x1p-6, 0.11, 0.4, 0.6, 3.0, 1e3})
            for (const double reach : {0.0, 1.0, 30.0, 1e6}) {
                const std::size_t length = 1 + random() % 900;
                const Vec3d start = random_vector(random, reach),
                            step = random_vector(random, size);
                EXPECT_LE(worst_share(scan, noise, {std::uint32_t(random()), 0, 1.0f}, start, step,
                                      length),
                          1.0)
                    << size << " " << reach;
            }
}

TEST(ScanlineKernel, HitsPlanesEdgesAndCornersExactly) {
    Scan scan;
    for (const NoiseName& noise : noises)
        for (const double size : {0x1p-7, 0x1p-4, 0.25, 0.5, 1.0, 1.0 / 3.0})
            for (const Vec3d& way :
                 {Vec3d(1, 0, 0), Vec3d(0, -1, 0), Vec3d(1, 1, 0), Vec3d(0, 1, -1), Vec3d(1, 1, 1),
                  Vec3d(-1, 1, -1), Vec3d(-1, -1, -1), Vec3d(1, 0.5, 0.25), Vec3d(0.0)})
                for (const double at : {0.0, -1.0, 7.0, 0.5, std::nextafter(3.0, 4.0),
                                        std::nextafter(3.0, 2.0), -5e-324})
                    EXPECT_LE(worst_share(scan, noise, {3, 0, 1.0f}, Vec3d(at), size * way, 70),
                              1.0)
                        << size << " " << way.x << " " << way.y << " " << way.z << " " << at;
}

TEST(ScanlineKernel, CrossesPlanesOfAxesThatHardlyMove) {
    std::mt19937 random(14);
    Scan scan;
    for (const NoiseName& noise : noises)
        for (const double change : {0.9 * 0x1p-20, -0.9 * 0x1p-20, 0x1p-24, 0x1p-32})
            for (int line = 0; line < 60; ++line) {
                constexpr std::size_t length = 200;
                Vec3d start = random_vector(random, 9.0), step = random_vector(random, 0.004);
                start[line % 3] = double(line % 7) - 0.5 * change;
                step[line % 3] = change / double(length);
                EXPECT_LE(worst_share(scan, noise, {std::uint32_t(random()), 0, 1.0f}, start, step,
                                      length),
                          1.0)
                    << change << " " << line;
            }
}

TEST(ScanlineKernel, TakesLinesOfAnyLength) {
    std::mt19937 random(12);
    Scan scan;
    for (const std::size_t length :
         {1u, 2u, 3u, 15u, 16u, 17u, 63u, 64u, 65u, 1023u, 1024u, 1025u, 4096u, 16384u})
        for (const NoiseName& noise : noises) {
            const Vec3d start = random_vector(random, 10.0), step = random_vector(random, 0.01);
            EXPECT_LE(worst_share(scan, noise, {5, 0, 1.0f}, start, step, length), 1.0) << length;
        }
}

TEST(ScanlineKernel, TakesOctavesAtTheirDoublings) {
    std::mt19937 random(13);
    Scan scan;
    for (const int doublings : {0, 1, 5, 12})
        for (const NoiseName& noise : noises) {
            const Vec3d start = random_vector(random, 4.0);
            const Vec3d step = random_vector(random, std::ldexp(0.02, -doublings));
            EXPECT_LE(worst_share(scan, noise, {9, doublings, 1.0f}, start, step, 600), 1.0)
                << doublings;
        }
}

TEST(ScanlineKernel, TakesStepsOfEverySize) {
    Scan scan;
    for (const NoiseName& noise : noises) {
        const auto values = [&](const Vec3d& step) {
            return scan.span(noise, {1, 0, 1.0f}, {0.25, -3.5, 1e3 + 0.125}, step, 300);
        };
        const std::vector<float> still(300, values(Vec3d(0.0))[0]);
        EXPECT_EQ(values(Vec3d(0.0)), still);
        EXPECT_EQ(values({5e-324, -5e-324, 1e-310}), still);
        EXPECT_EQ(values({0.0, -0.0, 1e-300}), still);
        // Whole cells: the noise at the same place of other cells.
        EXPECT_LE(worst_share(scan, noise, {1, 0, 1.0f}, {0.25, -3.5, 0.125}, {1e6, 0, 0x1p33}, 50),
                  1.0);
        // Beyond the lattice there is its origin, on the whole span.
        EXPECT_EQ(values({1e300, 0, 0}),
                  scan.span(noise, {1, 0, 1.0f}, {0.0, -3.5, 1000.125}, Vec3d(0.0), 300));
    }
}

TEST(ScanlineKernel, WeighsAndMapsAndAdds) {
    Scan scan;
    const Affine3 map{Mat3d(2, 0, 0, 0, 0.5, 0, 0, 0, -1), {1, 2, 3}};
    const NoiseName noise{NoiseKind::value, Fade::smooth};
    const std::vector<float> whole =
        scan(noise, {4, 0, 1.0f}, {piece({0.3, 0.8, 0.1}, {0.25, 0.5, 0.125}, 0, 40, 40)}, map);
    const std::vector<float> half =
        scan(noise, {4, 0, -0.5f}, {piece({1.6, 2.4, 2.9}, {0.5, 0.25, -0.125}, 0, 40, 40)});
    for (std::size_t j = 0; j < whole.size(); ++j)
        EXPECT_NEAR(half[j], -0.5f * whole[j], 1e-6f / float(stream_unit(noise.kind)));
}

/// Spans in a batch, at any place in it and in any parts, have the bits they have alone.
TEST(ScanlineKernel, LeavesNoTraceOfHowSpansAreCut) {
    std::mt19937 random(14);
    Scan scan;
    for (int i = 0; i < 60; ++i) {
        const NoiseName& noise = noises[i % 4];
        const StreamOctave octave{std::uint32_t(random()), i % 3, 0.7f};
        const std::size_t length = 1 + random() % 5000;
        const Vec3d start = random_vector(random, 1e3),
                    step = random_vector(random, std::ldexp(1.0, -int(random() % 12)));
        const std::vector<float> whole = scan.span(noise, octave, start, step, length);
        for (std::size_t first = 0; first < length;) {
            std::vector<Piece> pieces;
            std::size_t at = 0;
            if (random() % 2) {
                at = 1 + random() % 300;
                const Vec3d p = random_vector(random, 9.0);
                pieces.push_back(piece(p, random_vector(random, 0.1), 5, at, 400));
            }
            const std::size_t count = std::min(length - first, 1 + random() % (1024 - at));
            pieces.push_back(piece(start, step, double(first), count, double(length)));
            if (at + count < 1000) pieces.push_back(piece({}, {0.3, 0, 0.2}, 0, 20, 20));
            const std::vector<float> values = scan(noise, octave, pieces);
            for (std::size_t j = 0; j < count; ++j)
                ASSERT_EQ(values[at + j], whole[first + j]) << i << " " << first + j;
            first += count;
        }
    }
}

/// Restricts Highway to one instruction set while it lives.
class OnlyTarget {
  public:
    explicit OnlyTarget(std::int64_t target) { choose(target); }
    ~OnlyTarget() { choose(0); }

  private:
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

TEST(ScanlineKernel, GivesTheSameBitsOnEveryInstructionSet) {
    std::vector<Piece> pieces;
    std::mt19937 random(15);
    for (std::size_t left = batch_capacity; left > 0;) {
        const std::size_t count = std::min<std::size_t>(left, 1 + random() % 200);
        const double first = double(random() % 300);
        const double size = std::ldexp(1.0, 1 - int(random() % 10));
        const Vec3d start = random_vector(random, 1e4), step = random_vector(random, size);
        const double rest = double(random() % 50);
        pieces.push_back(piece(start, step, first, count, first + double(count) + rest));
        left -= count;
    }
    Scan scan;
    for (const NoiseName& noise : noises) {
        const StreamOctave octave{21, 2, 0.3f};
        const std::vector<float> expected = scan(noise, octave, pieces);
        for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0;
             left &= left - 1) {
            const OnlyTarget only(left & -left);
            EXPECT_EQ(scan(noise, octave, pieces), expected) << simd_level();
        }
    }
}

std::vector<Octave> octaves_of(NoiseKind kind, Fade fade, std::uint32_t octaves) {
    Texture texture;
    NoiseTerm& term = texture.noise.emplace_back();
    term.kind = kind, term.fade = fade, term.octaves = octaves, term.range = NoiseRange::bipolar;
    return expand_octaves(texture);
}

/// Long and short spans in one batch: the short ones as the direct kernel has them, the long ones
/// the same wherever they are, all of them right.
TEST(OctaveStreams, ScanLongSpansOnly) {
    std::mt19937 random(16);
    const auto buffers = std::make_unique<StreamBuffers>();
    for (const NoiseName& noise : noises) {
        const bool many = noise.kind == NoiseKind::perlin || noise.fade == Fade::linear;
        const std::vector<Octave> octaves = octaves_of(noise.kind, noise.fade, many ? 4 : 1);
        const OctaveStreams automatic(octaves), direct(octaves, Kernel::direct),
            scanning(octaves, Kernel::scanline);
        const auto values = [&](const OctaveStreams& streams, const std::vector<Piece>& pieces) {
            std::vector<double> sums(batch_capacity + batch_padding, 0.0);
            std::size_t count = 0;
            for (const Piece& p : pieces) count += p.solid.count;
            streams.add(pieces, count, *buffers, sums.data());
            EXPECT_EQ(sums[count], 0.0) << "nothing beyond the texels";
            sums.resize(count);
            return sums;
        };
        const Piece wide = piece({1, 2, 3}, {0.002, -0.001, 0.0015}, 700, 333, 5000);
        std::vector<Piece> pieces;
        for (int i = 0; i < 9; ++i) {
            const Vec3d p = random_vector(random, 5.0), s = random_vector(random, 0.05);
            pieces.push_back(i == 4 ? wide : piece(p, s, 0, 30, 30));
        }
        const auto mixed = values(automatic, pieces), alone = values(automatic, {wide}),
                   plain = values(direct, pieces), scans = values(scanning, pieces);
        EXPECT_EQ(std::vector(mixed.begin() + 120, mixed.begin() + 453), alone);
        EXPECT_EQ(std::vector(mixed.begin(), mixed.begin() + 120),
                  std::vector(plain.begin(), plain.begin() + 120));
        EXPECT_EQ(std::vector(mixed.begin() + 453, mixed.end()),
                  std::vector(plain.begin() + 453, plain.end()));
        EXPECT_EQ(std::vector(scans.begin() + 120, scans.begin() + 453), alone);
        EXPECT_NE(scans, plain);
        std::size_t at = 0;
        for (const Piece& p : pieces)
            for (std::size_t j = 0; j < p.solid.count; ++j, ++at) {
                const Vec3d s = p.solid.start + (p.solid.first + double(j)) * p.solid.step;
                const double exact = evaluate_field({}, octaves, s);
                ASSERT_NEAR(mixed[at], exact, 2.5e-7 * (1.875 + std::abs(exact)));
                ASSERT_NEAR(scans[at], exact, 2.5e-7 * (1.875 + std::abs(exact)));
            }
    }
}

}  // namespace
}  // namespace burl
