#include "procedural/kernels/noise_sum.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/noise_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/point_noise-inl.h"
#include "procedural/noise/lattice_site.h"
#include "procedural/numbers/fixed_point-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Coordinates of a vector of points along an axis, in units of 2^-32 cells.
struct PointAxis {
    Bit cell, part;  ///< upper and lower 32 bits

    /// The cells after so many doublings of the coordinate, at most 31.
    HWY_ATTR HWY_INLINE Bit Cells(int doublings) const {
        const Bit carried = hn::ShiftRightSame(hn::ShiftRight<1>(part), 31 - doublings);
        return hn::Or(hn::ShiftLeftSame(cell, doublings), carried);
    }
    /// Offsets from the cells' middles after so many doublings, in [-1/2, 1/2].
    HWY_ATTR HWY_INLINE Float Places(int doublings) const {
        const Bit place = hn::ShiftLeftSame(part, doublings);
        const auto centred = hn::BitCast(Ints(), hn::Xor(place, hn::Set(Bits(), 0x80000000u)));
        return hn::Mul(hn::ConvertTo(Floats(), centred), hn::Set(Floats(), 0x1p-32f));
    }
};

/// The coordinates frequency * x of a vector of points; those of size `limit` or more, and NaN,
/// count as 0.
HWY_ATTR HWY_INLINE PointAxis SplitPoints(const double* x, double frequency, double limit) {
    const Doubles d;
    const Double half = hn::Set(d, 0.5);
    const auto fixed = [&](const double* at) HWY_ATTR {
        const Double y = hn::Mul(hn::Set(d, frequency), hn::Load(d, at));
        const Double near = hn::IfThenElseZero(hn::Lt(hn::Abs(y), hn::Set(d, limit)), y);
        // The split is taken from the middle of a cell; the half cell is added back with a carry,
        // so that place 1/2 goes into the next cell.
        return hn::Add(FixedPoint(hn::Sub(near, half)), hn::Set(Longs(), std::uint64_t(1) << 31));
    };
#if HWY_TARGET == HWY_SCALAR
    const Long low = fixed(x);
    const Halves at(low, low);
#else
    const Halves at(fixed(x), fixed(x + hn::Lanes(d)));
#endif
    return {at.upper, at.lower};
}

/// Whether any of a vector of points has a coordinate that, times `frequency`, reaches `limit`.
HWY_ATTR HWY_INLINE bool AnyBeyond(const std::array<const double*, 3>& points, std::size_t j,
                                   double frequency, double limit) {
    const Doubles d;
    const Double factor = hn::Set(d, frequency), bound = hn::Set(d, limit);
    for (const double* axis : points)
        for (std::size_t i = 0; i < hn::Lanes(Floats()); i += hn::Lanes(d))
            if (!hn::AllTrue(d, hn::Lt(hn::Abs(hn::Mul(factor, hn::Load(d, axis + j + i))), bound)))
                return true;
    return false;
}

/// The shaped noise: n, |n| or (1 - |n|)^2.
template <OctaveShape shape>
HWY_ATTR HWY_INLINE Float Shaped(Float n) {
    if (shape == OctaveShape::plain) return n;
    const Float size = hn::Abs(n);
    if (shape == OctaveShape::absolute) return size;
    const Float rest = hn::Sub(hn::Set(Floats(), 1.0f), size);
    return hn::Mul(rest, rest);
}

/// The sites of a vector of points for all octaves of a run.
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
HWY_ATTR HWY_INLINE Float GroupSum(const NoiseSum& sum, const OctaveRun& group, const Noise& noise,
                                   const PointArrays& points, std::size_t j, Float total) {
    const double frequency = sum.octaves[group.begin].frequency;
    const int last = int(group.end - group.begin) - 1;
    const auto add = [&](int k, const SharedSites& sites) HWY_ATTR {
        const SumOctave& octave = sum.octaves[group.begin + std::size_t(k)];
        const Float n =
            hn::Mul(noise(octave.seed, sites.After(k)), hn::Set(Floats(), float(Noise::unit)));
        total = hn::Add(total, hn::Mul(hn::Set(Floats(), float(octave.weight)), Shaped<shape>(n)));
    };
    const double limit = std::ldexp(lattice_limit, -last);
    // The finest octaves' coordinates count as 0.
    if (AnyBeyond(points, j, frequency, limit)) {
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
    const std::vector<OctaveRun> groups = octave_runs(sum.octaves);
    HWY_ALIGN float totals[batch_capacity + batch_padding];
    for (std::size_t j = 0; j < count; j += hn::Lanes(Floats())) {
        Float total = hn::Zero(Floats());
        // The finest octaves come first, so that small numbers are added before large ones.
        for (std::size_t g = groups.size(); g-- > 0;)
            total = GroupSum<shape>(sum, groups[g], noise, points, j, total);
        hn::Store(total, Floats(), totals + j);
    }
    const Double offset = hn::Set(d, sum.offset);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d))
        hn::Store(hn::Add(hn::PromoteTo(d, hn::Load(HalfFloats(), totals + j)), offset), d,
                  out + j);
}

/// The sums of a vector of points.
struct VectorSums {
    Float value, slope[3];
};

/// Adds an octave of which `share` is visible; `mean` stands for the rest.
template <OctaveShape shape>
HWY_ATTR HWY_INLINE void AddShaped(const SumOctave& octave, VectorSample n, float unit, Float share,
                                   double mean, VectorSums& sums) {
    const Floats d;
    const Float weight = hn::Set(d, float(octave.weight)), one = hn::Set(d, 1.0f);
    n.value = hn::Mul(n.value, hn::Set(d, unit));
    const Float shaped = hn::Mul(share, Shaped<shape>(n.value));
    const Float rest = hn::Mul(hn::Sub(one, share), hn::Set(d, float(mean)));
    sums.value = hn::Add(sums.value, hn::Mul(weight, hn::Add(shaped, rest)));
    Float factor =
        hn::Mul(share, hn::Set(d, float(octave.weight * octave.frequency * double(unit))));
    if (shape != OctaveShape::plain) factor = hn::Xor(factor, hn::And(n.value, hn::SignBit(d)));
    if (shape == OctaveShape::ridged)
        factor = hn::Mul(factor, hn::Mul(hn::Set(d, -2.0f), hn::Sub(one, hn::Abs(n.value))));
    for (int axis = 0; axis < 3; ++axis)
        sums.slope[axis] = hn::Add(sums.slope[axis], hn::Mul(factor, n.slope[axis]));
}

/// visible_share for a vector of points: smoothstep(0.3, 0.7, kept - k).
HWY_ATTR HWY_INLINE Float ShareOf(Float kept, std::size_t k) {
    const Floats d;
    const Float away = hn::Sub(kept, hn::Set(d, float(k) + 0.3f));
    const Float u =
        hn::Min(hn::Max(hn::Mul(away, hn::Set(d, 2.5f)), hn::Zero(d)), hn::Set(d, 1.0f));
    return hn::Mul(hn::Mul(u, u), hn::Sub(hn::Set(d, 3.0f), hn::Add(u, u)));
}

template <OctaveShape shape, class Noise>
HWY_ATTR HWY_INLINE void AddGroup(const NoiseSum& sum, const OctaveRun& group, const Noise& noise,
                                  const PointArrays& points, std::size_t j, const Float* kept,
                                  double mean, VectorSums& sums) {
    const Floats d;
    const double frequency = sum.octaves[group.begin].frequency;
    const int last = int(group.end - group.begin) - 1;
    const bool beyond = AnyBeyond(points, j, frequency, std::ldexp(lattice_limit, -last));
    const SharedSites shared(points, j, frequency, std::ldexp(lattice_limit, -last));
    for (int k = last; k >= 0; --k) {
        const std::size_t number = group.begin + std::size_t(k);
        const Float share = kept ? ShareOf(*kept, number) : hn::Set(d, 1.0f);
        const SumOctave& octave = sum.octaves[number];
        VectorSample n{hn::Zero(d), {hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
        if (!hn::AllTrue(d, hn::Eq(share, hn::Zero(d))))
            n = noise.Sample(
                octave.seed,
                beyond ? SharedSites(points, j, frequency, std::ldexp(lattice_limit, -k)).After(k)
                       : shared.After(k));
        AddShaped<shape>(octave, n, float(Noise::unit), share, mean, sums);
    }
}

template <OctaveShape shape, class Noise>
HWY_ATTR void AddUpSlopesOf(const NoiseSum& sum, const Noise& noise, const PointArrays& points,
                            std::size_t count, const VisibleOctaves& visible,
                            const SlopeArrays& out) {
    const Floats d;
    const std::vector<OctaveRun> groups = octave_runs(sum.octaves);
    const Float zero = hn::Zero(d), offset = hn::Set(d, float(sum.offset));
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        VectorSums sums{zero, {zero, zero, zero}};
        const Float kept = visible.kept ? hn::Load(d, visible.kept + j) : zero;
        for (std::size_t g = groups.size(); g-- > 0;)
            AddGroup<shape>(sum, groups[g], noise, points, j, visible.kept ? &kept : nullptr,
                            visible.mean, sums);
        hn::Store(hn::Add(sums.value, offset), d, out.value + j);
        for (std::size_t axis = 0; axis < 3; ++axis)
            hn::Store(sums.slope[axis], d, out.slope[axis] + j);
    }
}

HWY_ATTR void AddUpSlopes(const NoiseSum& sum, const PointArrays& points, std::size_t count,
                          const VisibleOctaves& visible, const SlopeArrays& out) {
    WithPointNoise(sum.noise, [&](const auto& noise) HWY_ATTR {
        if (sum.shape == OctaveShape::plain)
            AddUpSlopesOf<OctaveShape::plain>(sum, noise, points, count, visible, out);
        else if (sum.shape == OctaveShape::absolute)
            AddUpSlopesOf<OctaveShape::absolute>(sum, noise, points, count, visible, out);
        else
            AddUpSlopesOf<OctaveShape::ridged>(sum, noise, points, count, visible, out);
    });
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
#include "procedural/noise/noise.h"

namespace burl {

std::vector<OctaveRun> octave_runs(std::span<const SumOctave> octaves) {
    // A place keeps 25 bits after 7 doublings, as many as float32 holds with its sign.
    constexpr std::size_t most_shared_octaves = 8;
    std::vector<OctaveRun> runs;
    for (std::size_t k = 0; k < octaves.size(); ++k) {
        const bool joins = !runs.empty() && k - runs.back().begin < most_shared_octaves &&
                           octaves[k].frequency == 2.0 * octaves[k - 1].frequency;
        if (!joins) runs.push_back({k, k});
        runs.back().end = k + 1;
    }
    return runs;
}

HWY_EXPORT(AddUp);
HWY_EXPORT(AddUpSlopes);

bool has_point_kernel(const NoiseSpec& noise) {
    return is_interpolated(noise.kind) && noise.period == Period<4>{} && !noise.time;
}

namespace {

/// add_up for noises without a kernel: point by point, noise in float32, sums in float64.
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

/// add_up_slopes for noises without a kernel, at one point.
void add_up_slopes_at(const NoiseSum& sum, const Point<3>& p, const VisibleOctaves& visible,
                      std::size_t j, const SlopeArrays& out) {
    NoiseSample<double, 3> total{sum.offset, {}};
    NoiseSpec noise = sum.noise;
    for (std::size_t k = 0; k < sum.octaves.size(); ++k) {
        const auto& [seed, frequency, weight] = sum.octaves[k];
        noise.seed = seed;
        const double share = visible.kept ? visible_share(double(visible.kept[j]), k) : 1.0;
        total.value += weight * (1.0 - share) * visible.mean;
        if (share == 0.0) continue;
        const auto n = shaped(
            sum.shape,
            sample_noise<float, 3>(noise, {frequency * p[0], frequency * p[1], frequency * p[2]}));
        total.value += weight * share * double(n.value);
        for (std::size_t axis = 0; axis < 3; ++axis)
            total.gradient[axis] += weight * share * frequency * double(n.gradient[axis]);
    }
    out.value[j] = float(total.value);
    for (std::size_t axis = 0; axis < 3; ++axis) out.slope[axis][j] = float(total.gradient[axis]);
}

}  // namespace

void add_up_slopes(const NoiseSum& sum, const PointArrays& points, std::size_t count,
                   const VisibleOctaves& visible, const SlopeArrays& out) {
    if (has_point_kernel(sum.noise))
        return HWY_DYNAMIC_DISPATCH(AddUpSlopes)(sum, points, count, visible, out);
    for (std::size_t j = 0; j < count; ++j)
        add_up_slopes_at(sum, {points[0][j], points[1][j], points[2][j]}, visible, j, out);
}

void add_up(const NoiseSum& sum, const PointArrays& points, std::size_t count, double* out) {
    if (!has_point_kernel(sum.noise)) return add_up_points(sum, points, count, out);
    HWY_DYNAMIC_DISPATCH(AddUp)(sum, points, count, out);
}

}  // namespace burl
#endif
