#include "procedural/noise_sum.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "procedural/perlin1985.h"
#include "procedural/published_permutation.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/noise_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/noise_corners-inl.h"
#include "procedural/point_sites-inl.h"

#ifndef BURL_NOISE_SUM_ONCE
#define BURL_NOISE_SUM_ONCE
namespace burl {

/// Doublings after which coordinates are split anew: a place then has 25 bits left, as many as
/// float32 holds.
inline constexpr std::size_t most_shared_octaves = 8;

/// Octaves [begin, end) of which each doubles the frequency of the one before.
struct OctaveGroup {
    std::size_t begin = 0, end = 0;
};

inline std::vector<OctaveGroup> groups_of(std::span<const SumOctave> octaves) {
    std::vector<OctaveGroup> groups;
    for (std::size_t k = 0; k < octaves.size(); ++k) {
        const bool joins = !groups.empty() && k - groups.back().begin < most_shared_octaves &&
                           octaves[k].frequency == 2.0 * octaves[k - 1].frequency;
        if (!joins) groups.push_back({k, k});
        groups.back().end = k + 1;
    }
    return groups;
}

/// The published permutation as numbers that vectors can gather.
inline constexpr auto permutation_numbers = [] {
    std::array<std::int32_t, 256> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = published_permutation[i];
    return numbers;
}();

}  // namespace burl
#endif

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

struct VectorSite {
    Bit cell[3];
    Float place[3];
};

// Noises give `unit` times the noise of a vector of sites, by octave.

template <class Corner, class FadeFunction, int exponent>
struct HashedNoise {
    static constexpr double unit = exponent == 3 ? 0x1p-3 : 0x1p-26;
    HWY_ATTR HWY_INLINE Float operator()(std::uint32_t seed, const VectorSite& at) const {
        const Bit seeds = hn::Set(Bits(), seed * LatticeHash::prime_seed);
        return EightfoldNoise<Corner, FadeFunction>(
            CellHash(seeds, at.cell[0], at.cell[1], at.cell[2]), at.place[0], at.place[1],
            at.place[2]);
    }
};

/// Blends eight corners whose random numbers come from tables of 256: `Tables` has Hash(h) for the
/// first two axes and Corner(h, x, y, z).
template <class Tables, class FadeFunction>
struct TableNoise {
    static constexpr double unit = 0x1p-3;
    Tables tables;

    HWY_ATTR HWY_INLINE Float operator()(std::uint32_t seed, const VectorSite& at) const {
        const Floats d;
        const FadeFunction fade;
        const Bit one = hn::Set(Bits(), 1);
        Bit low[3];
        Float from_low[3], from_high[3], weight[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Float u = at.place[axis], half = hn::Set(d, 0.5f);
            low[axis] = hn::Add(at.cell[axis], hn::Set(Bits(), LatticeHash::shift(seed, axis)));
            from_low[axis] = hn::Add(u, half);
            from_high[axis] = hn::Sub(u, half);
            weight[axis] = fade(hn::Add(u, u));
        }
        const auto column = [&](Bit hash, Float x, Float y) HWY_ATTR {
            const Bit h = hn::Add(hash, low[2]);
            return TwiceLerp(weight[2], tables.Corner(h, x, y, from_low[2]),
                             tables.Corner(hn::Add(h, one), x, y, from_high[2]));
        };
        const auto side = [&](Bit x_index, Float x) HWY_ATTR {
            const Bit h = hn::Add(tables.Hash(x_index), low[1]);
            return TwiceLerp(weight[1], column(tables.Hash(h), x, from_low[1]),
                             column(tables.Hash(hn::Add(h, one)), x, from_high[1]));
        };
        return TwiceLerp(weight[0], side(low[0], from_low[0]),
                         side(hn::Add(low[0], one), from_high[0]));
    }
};

HWY_ATTR HWY_INLINE hn::Vec<Ints> LowByte(Bit h) {
    return hn::BitCast(Ints(), hn::And(h, hn::Set(Bits(), 255)));
}

struct PublishedTables {
    HWY_ATTR HWY_INLINE Bit Hash(Bit h) const {
        return hn::BitCast(Bits(), hn::GatherIndex(Ints(), permutation_numbers.data(), LowByte(h)));
    }
    HWY_ATTR HWY_INLINE Float Corner(Bit h, Float x, Float y, Float z) const {
        return PerlinCorner()(hn::ShiftLeft<28>(Hash(h)), x, y, z);
    }
};

struct Tables1985 {
    const std::int32_t* permutation = nullptr;
    const float* gradients = nullptr;
    HWY_ATTR HWY_INLINE Bit Hash(Bit h) const {
        return hn::BitCast(Bits(), hn::GatherIndex(Ints(), permutation, LowByte(h)));
    }
    HWY_ATTR HWY_INLINE Float Corner(Bit h, Float x, Float y, Float z) const {
        const Floats d;
        const auto number = LowByte(h), at = hn::Add(number, hn::Add(number, number));
        const auto product = [&](int axis, Float offset) HWY_ATTR {
            return hn::Mul(hn::GatherIndex(d, gradients + axis, at), offset);
        };
        return hn::Add(hn::Add(product(0, x), product(1, y)), product(2, z));
    }
};

/// Calls visit(noise) with the kind's.
template <class Visit>
HWY_ATTR void WithPointNoise(const NoiseSpec& noise, const Visit& visit) {
    if (noise.kind == NoiseKind::perlin2002)
        return visit(TableNoise<PublishedTables, QuinticFade>{});
    if (noise.kind == NoiseKind::perlin1985) {
        const ClassicTables& tables = classic_tables();
        const auto* permutation = reinterpret_cast<const std::int32_t*>(tables.p.data());
        return visit(TableNoise<Tables1985, SmoothFade>{{permutation, tables.g3[0].data()}});
    }
    if (noise.kind == NoiseKind::perlin) return visit(HashedNoise<PerlinCorner, QuinticFade, 3>());
    if (noise.fade == Fade::linear) return visit(HashedNoise<ValueCorner, LinearFade, 26>());
    if (noise.fade == Fade::smooth) return visit(HashedNoise<ValueCorner, SmoothFade, 26>());
    return visit(HashedNoise<ValueCorner, QuinticFade, 26>());
}

/// n, |n| or (1 - |n|)^2.
template <OctaveShape shape>
HWY_ATTR HWY_INLINE Float Shaped(Float n) {
    if (shape == OctaveShape::plain) return n;
    const Float size = hn::Abs(n);
    if (shape == OctaveShape::absolute) return size;
    const Float rest = hn::Sub(hn::Set(Floats(), 1.0f), size);
    return hn::Mul(rest, rest);
}

/// The sites of a group's octaves.
struct SharedSites {
    PointAxis axes[3];

    HWY_ATTR HWY_INLINE SharedSites(const PointArrays& points, std::size_t j, double frequency,
                                    double limit)
        : axes{SplitPoints(points[0] + j, frequency, limit),
               SplitPoints(points[1] + j, frequency, limit),
               SplitPoints(points[2] + j, frequency, limit)} {}

    HWY_ATTR HWY_INLINE VectorSite After(int doublings) const {
        return {{axes[0].Cells(doublings), axes[1].Cells(doublings), axes[2].Cells(doublings)},
                {axes[0].Places(doublings), axes[1].Places(doublings), axes[2].Places(doublings)}};
    }
};

template <OctaveShape shape, class Noise>
HWY_ATTR HWY_INLINE Float GroupSum(const NoiseSum& sum, const OctaveGroup& group,
                                   const Noise& noise, const PointArrays& points, std::size_t j,
                                   Float total) {
    const double frequency = sum.octaves[group.begin].frequency;
    const int last = int(group.end - group.begin) - 1;
    const auto add = [&](int k, const SharedSites& sites) HWY_ATTR {
        const SumOctave& octave = sum.octaves[group.begin + std::size_t(k)];
        const Float n =
            hn::Mul(noise(octave.seed, sites.After(k)), hn::Set(Floats(), float(Noise::unit)));
        total = hn::Add(total, hn::Mul(hn::Set(Floats(), float(octave.weight)), Shaped<shape>(n)));
    };
    const double limit = std::ldexp(lattice_limit, -last);
    if (AnyBeyond(points, j, frequency, limit)) {  // the finest octaves' coordinates count as 0
        for (int k = last; k >= 0; --k)
            add(k, SharedSites(points, j, frequency, std::ldexp(lattice_limit, -k)));
        return total;
    }
    const SharedSites sites(points, j, frequency, limit);
    for (int k = last; k >= 0; --k) add(k, sites);
    return total;
}

template <OctaveShape shape, class Noise>
HWY_ATTR void AddUpOf(const NoiseSum& sum, const Noise& noise, const PointArrays& points,
                      std::size_t count, double* out) {
    const Doubles d;
    const std::vector<OctaveGroup> groups = groups_of(sum.octaves);
    HWY_ALIGN float totals[batch_capacity + batch_padding];
    for (std::size_t j = 0; j < count; j += hn::Lanes(Floats())) {
        Float total = hn::Zero(Floats());
        for (std::size_t g = groups.size();
             g-- > 0;)  // the finest first: small numbers before large
            total = GroupSum<shape>(sum, groups[g], noise, points, j, total);
        hn::Store(total, Floats(), totals + j);
    }
    const Double offset = hn::Set(d, sum.offset);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d))
        hn::Store(hn::Add(hn::PromoteTo(d, hn::Load(HalfFloats(), totals + j)), offset), d,
                  out + j);
}

HWY_ATTR void AddUp(const NoiseSum& sum, const PointArrays& points, std::size_t count,
                    double* out) {
    WithPointNoise(sum.noise, [&](const auto& noise) HWY_ATTR {
        if (sum.shape == OctaveShape::plain)
            AddUpOf<OctaveShape::plain>(sum, noise, points, count, out);
        else if (sum.shape == OctaveShape::absolute)
            AddUpOf<OctaveShape::absolute>(sum, noise, points, count, out);
        else
            AddUpOf<OctaveShape::ridged>(sum, noise, points, count, out);
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "procedural/noise.h"

namespace burl {

HWY_EXPORT(AddUp);

bool has_point_kernel(const NoiseSpec& noise) {
    return is_interpolated(noise.kind) && noise.period == Period<4>{} && !noise.time;
}

namespace {

/// Point by point, in float32.
void add_up_points(const NoiseSum& sum, const PointArrays& points, std::size_t count, double* out) {
    std::fill_n(out, count, sum.offset);
    NoiseSpec noise = sum.noise;
    for (std::size_t k = sum.octaves.size(); k-- > 0;) {
        const SumOctave& octave = sum.octaves[k];
        noise.seed = octave.seed;
        for (std::size_t j = 0; j < count; ++j) {
            const float n = noise_value<float, 3>(
                noise, {octave.frequency * points[0][j], octave.frequency * points[1][j],
                        octave.frequency * points[2][j]});
            out[j] += octave.weight * double(shaped(sum.shape, n));
        }
    }
}

}  // namespace

void add_up(const NoiseSum& sum, const PointArrays& points, std::size_t count, double* out) {
    if (!has_point_kernel(sum.noise)) return add_up_points(sum, points, count, out);
    HWY_DYNAMIC_DISPATCH(AddUp)(sum, points, count, out);
}

}  // namespace burl
#endif
