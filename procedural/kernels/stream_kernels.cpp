#include "procedural/kernels/stream_kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/stream_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/fixed_lines-inl.h"
#include "procedural/kernels/stream_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

template <bool near_origin>
HWY_ATTR HWY_INLINE void FillLine(const FixedLines& lines, std::size_t i, double first,
                                  std::size_t count, std::size_t at, LatticeStream& stream) {
    const Doubles d;
    const FixedAxis<near_origin> axes[] = {{lines, i, 0}, {lines, i, 1}, {lines, i, 2}};
    const auto lanes = hn::Set(d, double(hn::Lanes(d))),
               both = hn::Set(d, double(hn::Lanes(Bits())));
    auto x = hn::Add(LaneNumbers(), hn::Set(d, first));
    for (std::size_t j = at; j < at + count; j += hn::Lanes(Bits())) {
        for (int axis = 0; axis < 3; ++axis)
            axes[axis].Store(x, lanes, stream.cells[axis] + j, stream.places[axis] + j);
        x = hn::Add(x, both);
    }
}

/// Fills a line that FillLine cannot: one far from the origin, or one that crosses very many cells.
void FillHardLine(const Affine3& map, const LatticeLine& line, double length,
                  const LineLimits& limits, std::size_t at, LatticeStream& stream) {
    for (int axis = 0; axis < 3; ++axis) {
        const double a = map.linear[0][axis], b = map.linear[1][axis], c = map.linear[2][axis];
        const auto along = [&](const Vec3d& v) { return a * v.x + b * v.y + c * v.z; };
        const double start = along(line.start) + map.offset[axis], step = along(line.step);
        const bool near = std::abs(start) + length * std::abs(step) < limits.coordinate;
        for (std::size_t j = 0; j < line.count; ++j) {
            const double x = near ? start + (line.first + double(j)) * step : 0.0;
            const double cell = std::floor(x), period = limits.period;
            const double wrapped = period > 0.0 ? cell - period * std::floor(cell / period) : cell;
            // A sum, because just below a cell's border x - cell rounds to 1: place 0 of the next
            // cell.
            stream.set(
                axis, at + j,
                (std::uint64_t(std::int64_t(wrapped)) << 32) + std::uint64_t((x - cell) * 0x1p32));
        }
    }
}

/// The stream that lines are appended to, with counts.
struct StreamEnd {
    LatticeStream& stream;
    /// Texels that the stream has so far.
    std::size_t texels = 0;
    double planes = 0.0;  ///< lattice planes that those texels cross
};

/// Appends `count` lines from number `begin` on.
template <bool near_origin, class Source>
HWY_ATTR void FillLines(const Affine3& map, const LineLimits& limits, const Source& source,
                        std::size_t begin, std::size_t count, const FixedLines& lines,
                        StreamEnd& end) {
    for (std::size_t i = 0; i < count; ++i) {
        const LatticeLine& line = source.Line(begin + i, end.texels);
        source.Prefetch(begin + i, end.texels);
        if (near_origin || lines.hard[i] == 0.0)
            FillLine<near_origin>(lines, i, line.first, line.count, end.texels, end.stream);
        else
            FillHardLine(map, line, lines.length[i], limits, end.texels, end.stream);
        end.texels += line.count;
        end.planes += double(line.count) * lines.planes[i];
    }
}

template <class Source>
HWY_ATTR double FillStreamFrom(const Affine3& map, int doublings, double period,
                               const Source& source, LatticeStream& stream) {
    const LineLimits limits{std::ldexp(lattice_limit, -doublings), period};
    FixedLines lines;
    StreamEnd end{stream};
    for (std::size_t begin = 0; begin < source.size(); begin += FixedLines::capacity) {
        const std::size_t count = std::min(FixedLines::capacity, source.size() - begin);
        if (MapLines<true>(map, limits, source, begin, count, lines)) {
            FillLines<true>(map, limits, source, begin, count, lines, end);
        } else {
            MapLines<false>(map, limits, source, begin, count, lines);
            FillLines<false>(map, limits, source, begin, count, lines, end);
        }
    }
    return end.planes;
}

HWY_ATTR double FillStream(const Affine3& map, int doublings, double period,
                           std::span<const Piece> pieces, LatticeStream& stream) {
    return FillStreamFrom(map, doublings, period, PieceSource{pieces}, stream);
}

HWY_ATTR double FillStreamOfSpans(const Affine3& map, int doublings, double period,
                                  const SpanLines& spans, LatticeStream& stream) {
    return FillStreamFrom(map, doublings, period, SpanSource{spans}, stream);
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddOctaveOf(const StreamOctave& octave, const LatticeStream& stream,
                          std::size_t count, float* sums) {
    const Floats d;
    const Bit seed = hn::Set(Bits(), octave.seed * LatticeHash::prime_seed);
    const Float weight = hn::Set(d, octave.weight);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto cell = [&](int axis)
                              HWY_ATTR { return CellsOf(stream, axis, j, octave.doublings); };
        const StreamPlaces<FadeFunction> at(stream, j, octave.doublings);
        const Bit h = CellHash(seed, cell(0), cell(1), cell(2));
        const Float noise = WithPlanesOf<Corner>(
            h, [&](const auto& low, const auto& high) HWY_ATTR { return NoiseOf(at, low, high); });
        AddScaled(weight, noise, sums + j);
    }
}

HWY_ATTR void AddOctaveDirect(NoiseKind kind, Fade fade, const StreamOctave& octave,
                              const LatticeStream& stream, std::size_t count, float* sums) {
    with_noise(kind, fade, [&]<class Corner, class FadeFunction>() HWY_ATTR {
        AddOctaveOf<Corner, FadeFunction>(octave, stream, count, sums);
    });
}

HWY_ATTR void AddScaledNoise(float weight, const float* noise, std::size_t count, float* sums) {
    const Floats d;
    const auto weights = hn::Set(d, weight);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d))
        hn::Store(hn::Add(hn::Load(d, sums + j), hn::Mul(weights, hn::LoadU(d, noise + j))), d,
                  sums + j);
}

HWY_ATTR void AddSumsTo(const double* from, double scale, const float* sums, std::size_t count,
                        double* values) {
    const Doubles d;
    const auto scales = hn::Set(d, scale);
    std::size_t j = 0;
    for (; j + hn::Lanes(d) <= count; j += hn::Lanes(d)) {
        const auto sum = hn::PromoteTo(d, hn::Load(HalfFloats(), sums + j));
        hn::StoreU(hn::Add(hn::LoadU(d, from + j), hn::Mul(sum, scales)), d, values + j);
    }
    for (; j < count; ++j) values[j] = from[j] + double(sums[j]) * scale;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FillStream);
HWY_EXPORT(FillStreamOfSpans);
HWY_EXPORT(AddOctaveDirect);
HWY_EXPORT(AddScaledNoise);
HWY_EXPORT(AddSumsTo);

double fill_stream(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                   LatticeStream& stream, double period) {
    return HWY_DYNAMIC_DISPATCH(FillStream)(lattice_from_solid, doublings, period, pieces, stream);
}

double fill_stream(const Affine3& lattice_from_solid, int doublings, const SpanLines& lines,
                   LatticeStream& stream, double period) {
    return HWY_DYNAMIC_DISPATCH(FillStreamOfSpans)(lattice_from_solid, doublings, period, lines,
                                                   stream);
}

void add_octave_direct(NoiseKind kind, Fade fade, const StreamOctave& octave,
                       const LatticeStream& stream, std::size_t count, float* sums) {
    HWY_DYNAMIC_DISPATCH(AddOctaveDirect)
    (kind, fade, octave, stream, count, sums);
}

void add_scaled(float weight, const float* noise, std::size_t count, float* sums) {
    HWY_DYNAMIC_DISPATCH(AddScaledNoise)(weight, noise, count, sums);
}

void add_sums_to(const double* from, double scale, const float* sums, std::size_t count,
                 double* values) {
    HWY_DYNAMIC_DISPATCH(AddSumsTo)(from, scale, sums, count, values);
}

void add_sums(double scale, const float* sums, std::size_t count, double* values) {
    add_sums_to(values, scale, sums, count, values);
}

}  // namespace burl
#endif
