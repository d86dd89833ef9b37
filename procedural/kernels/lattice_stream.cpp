#include "procedural/kernels/lattice_stream.h"

#include <algorithm>
#include <cmath>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/lattice_stream.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include <hwy/cache_control.h>

#include "procedural/kernels/piece_lanes-inl.h"
#include "procedural/numbers/fixed_point-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// The extent in cells below which a line is computed in fixed point from the cell of its start.
constexpr double fixed_reach = 0x1p18;
/// The largest distance from 0, in cells, of lines that are computed in fixed point from 0 instead
/// of from a cell: the same bits in fewer operations.
constexpr double origin_reach = 0x1p19;

/// At most `capacity` lines in the lattice: along an axis, the coordinate of texel x is the bits of
/// from + x * step, plus `offset` (without it where all lines are near 0).
struct FixedLines {
    static constexpr std::size_t capacity = 64;
    alignas(64) double from[3][capacity], step[3][capacity];
    alignas(64) std::uint64_t offset[3][capacity];
    alignas(64) double length[capacity + 8];  ///< texels of the whole line
    alignas(64) double planes[capacity];      ///< lattice planes crossed per texel
    alignas(64) double hard[capacity];        ///< 1 for a line out of reach of fixed point, else 0
};

/// The limits on the coordinates of lines.
struct LineLimits {
    double coordinate;  ///< a coordinate that reaches this size is 0 on the whole line
    double period;      ///< period of the cells; 0 for 2^32
};

/// x less the multiple of the period nearest to it, exactly.
HWY_ATTR HWY_INLINE Double Wrapped(Double x, double period) {
    const Doubles d;
    const Double magic = hn::Set(d, round_magic);
    const Double periods = hn::Sub(hn::Add(hn::Mul(x, hn::Set(d, 1.0 / period)), magic), magic);
    return hn::Sub(x, hn::Mul(periods, hn::Set(d, period)));
}

/// A source of lines: pieces.
struct PieceSource {
    std::span<const Piece> pieces;

    std::size_t size() const { return pieces.size(); }
    double Length(std::size_t i) const {
        return std::max(pieces[i].length, pieces[i].solid.first + double(pieces[i].solid.count));
    }
    const LatticeLine& Line(std::size_t i, std::size_t) const { return pieces[i].solid; }
    void Prefetch(std::size_t, std::size_t) const {}
    HWY_ATTR HWY_INLINE PieceLanes Lanes(std::size_t i) const { return {pieces, i}; }
};

/// Start and step of a vector of spans.
struct SpanLanes {
    Double x, y, z, u, v, w;

    HWY_ATTR HWY_INLINE SpanLanes(const SpanLines& lines, std::size_t i) {
        const Doubles d;
        const auto numbers = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from + i); };
        x = numbers(lines.start[0]), y = numbers(lines.start[1]), z = numbers(lines.start[2]);
        u = numbers(lines.step[0]), v = numbers(lines.step[1]), w = numbers(lines.step[2]);
    }
};

/// A source of lines: spans.
struct SpanSource {
    const SpanLines& lines;

    std::size_t size() const { return lines.spans; }
    double Length(std::size_t i) const { return double(lines.counts[i]); }
    LatticeLine Line(std::size_t i, std::size_t at) const { return lines.line(i, at); }
    /// Prefetches a cache line of `lines.needed` and one of the spans further on, which come from
    /// memory and which hardware does not prefetch.
    HWY_ATTR HWY_INLINE void Prefetch(std::size_t i, std::size_t at) const {
        constexpr std::size_t ahead = 160;
        if (lines.needed) hwy::Prefetch(lines.needed + at);
        const std::size_t k = i % 8;
        if (k < 6) hwy::Prefetch((k < 3 ? lines.start[k] : lines.step[k - 3]) + i + ahead);
    }
    HWY_ATTR HWY_INLINE SpanLanes Lanes(std::size_t i) const { return {lines, i}; }
};

/// Stores the start of lines along an axis for FixedLines.
template <bool near_origin>
HWY_ATTR HWY_INLINE void StoreStart(Double start, int axis, std::size_t i, FixedLines& lines) {
    const Doubles d;
    const Double magic = hn::Set(d, fixed_magic);
    if constexpr (near_origin) {
        hn::Store(hn::Add(start, magic), d, lines.from[axis] + i);
    } else {
        const NearestInteger cell(start);
        hn::Store(hn::Add(cell.rest, magic), d, lines.from[axis] + i);
        hn::Store(hn::Sub(cell.integer, hn::Set(Longs(), fixed_zero)), Longs(),
                  lines.offset[axis] + i);
    }
}

/// Maps `count` lines from number `begin` on into the lattice. Returns whether no line is hard and,
/// with near_origin, all are near 0.
template <bool near_origin, class Source>
HWY_ATTR bool MapLines(const Affine3& map, const LineLimits& limits, const Source& source,
                       std::size_t begin, std::size_t count, FixedLines& lines) {
    const Doubles d;
    const auto most =
        hn::Set(d, near_origin ? std::min(limits.coordinate, origin_reach) : limits.coordinate);
    for (std::size_t i = 0; i < count; ++i) lines.length[i] = source.Length(begin + i);
    std::fill_n(lines.length + count, hn::Lanes(d), 0.0);
    auto all_hard = hn::Zero(d);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto p = source.Lanes(begin + i);
        const auto length = hn::Load(d, lines.length + i);
        auto planes = hn::Zero(d), hard = hn::Zero(d);
        for (int axis = 0; axis < 3; ++axis) {
            const double a = map.linear[0][axis], b = map.linear[1][axis], c = map.linear[2][axis];
            const auto step = Dot(a, b, c, p.u, p.v, p.w);
            auto start = hn::Add(Dot(a, b, c, p.x, p.y, p.z), hn::Set(d, map.offset[axis]));
            const auto speed = hn::Abs(step), extent = hn::Mul(length, speed);
            const auto reach = hn::Add(hn::Abs(start), extent);
            const auto near = hn::And(hn::Lt(extent, hn::Set(d, fixed_reach)), hn::Lt(reach, most));
            hard = hn::IfThenElse(near, hard, hn::Set(d, 1.0));
            planes = hn::Add(planes, speed);
            if (limits.period > 0.0) start = Wrapped(start, limits.period);
            StoreStart<near_origin>(start, axis, i, lines);
            hn::Store(step, d, lines.step[axis] + i);
        }
        all_hard = hn::Max(all_hard, hard);
        hn::Store(planes, d, lines.planes + i);
        hn::Store(hard, d, lines.hard + i);
    }
    return hn::AllTrue(d, hn::Eq(all_hard, hn::Zero(d)));
}

/// One axis of one line, in every lane.
template <bool near_origin>
struct FixedAxis {
    Double from, step;
    Long offset;

    HWY_ATTR HWY_INLINE FixedAxis(const FixedLines& lines, std::size_t i, int axis)
        : from(hn::Set(Doubles(), lines.from[axis][i])),
          step(hn::Set(Doubles(), lines.step[axis][i])),
          offset(hn::Set(Longs(), near_origin ? 0 : lines.offset[axis][i])) {}

    HWY_ATTR HWY_INLINE Long At(Double x) const {
        const Long sum = hn::BitCast(Longs(), hn::Add(from, hn::Mul(x, step)));
        return near_origin ? sum : hn::Add(sum, offset);
    }
    /// Stores a vector of floats' worth of texels: half of them at x, half at x + lanes.
    HWY_ATTR HWY_INLINE void Store(Double x, Double lanes, std::uint32_t* cells,
                                   std::uint32_t* places) const {
        const Halves at(At(x), At(hn::Add(x, lanes)));
        const Bit zero = hn::Set(Bits(), std::uint32_t(fixed_zero >> 32));
        hn::StoreU(near_origin ? hn::Sub(at.upper, zero) : at.upper, Bits(), cells);
        hn::StoreU(at.lower, Bits(), places);
    }
};

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

/// Adds cells and places (the carry included) to the coordinates from texel `at` on.
HWY_ATTR HWY_INLINE void AddTo(Bit cells, Bit places, std::uint32_t* to_cells,
                               std::uint32_t* to_places) {
    const Bits d;
    const Bit before = hn::LoadU(d, to_places), after = hn::Add(before, places);
    const Bit carry = hn::VecFromMask(d, hn::Lt(after, before));  // -1 with a carry, else 0
    hn::StoreU(after, d, to_places);
    hn::StoreU(hn::Sub(hn::Add(hn::LoadU(d, to_cells), cells), carry), d, to_cells);
}

/// Moves `count` texels from number `at` on along an axis, by their offsets times the components u
/// and v of their sides.
HWY_ATTR HWY_INLINE void MoveTexels(const TexelOffsets& offsets, std::size_t at, std::size_t count,
                                    double u, double v, std::uint32_t* cells,
                                    std::uint32_t* places) {
    const Doubles d;
    // The move of a vector of texels from j on; 0 beyond the piece, where another piece's follow.
    const auto moved = [&](std::size_t j) HWY_ATTR {
        const auto offset = [&](const float* values) HWY_ATTR {
            return hn::PromoteTo(d, hn::LoadU(HalfFloats(), values + at + j));
        };
        const auto sum = hn::Add(hn::Mul(offset(offsets.u), hn::Set(d, u)),
                                 hn::Mul(offset(offsets.v), hn::Set(d, v)));
        const auto own = hn::Lt(LaneNumbers(), hn::Set(d, double(count) - double(j)));
        return FixedPoint(hn::IfThenElseZero(own, sum));
    };
    for (std::size_t j = 0; j < count; j += hn::Lanes(Bits())) {
        const Halves by(moved(j), moved(j + hn::Lanes(d)));
        AddTo(by.upper, by.lower, cells + at + j, places + at + j);
    }
}

HWY_ATTR void MoveStream(const Affine3& map, std::span<const Piece> pieces,
                         const TexelOffsets& offsets, LatticeStream& stream) {
    PieceSides sides;
    std::size_t at = 0;
    for (std::size_t first = 0; first < pieces.size(); first += PieceSides::capacity) {
        const auto part =
            pieces.subspan(first, std::min(PieceSides::capacity, pieces.size() - first));
        sides.Map(map, 1.0, part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::size_t count = part[i].solid.count;
            for (int axis = 0; axis < 3; ++axis)
                MoveTexels(offsets, at, count, sides.u[axis][i], sides.v[axis][i],
                           stream.cells[axis], stream.places[axis]);
            at += count;
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FillStream);
HWY_EXPORT(FillStreamOfSpans);
HWY_EXPORT(MoveStream);

double fill_stream(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                   LatticeStream& stream, double period) {
    return HWY_DYNAMIC_DISPATCH(FillStream)(lattice_from_solid, doublings, period, pieces, stream);
}

double fill_stream(const Affine3& lattice_from_solid, int doublings, const SpanLines& lines,
                   LatticeStream& stream, double period) {
    return HWY_DYNAMIC_DISPATCH(FillStreamOfSpans)(lattice_from_solid, doublings, period, lines,
                                                   stream);
}

void move_stream(const Affine3& lattice_from_solid, std::span<const Piece> pieces,
                 const TexelOffsets& offsets, LatticeStream& stream) {
    HWY_DYNAMIC_DISPATCH(MoveStream)(lattice_from_solid, pieces, offsets, stream);
}

}  // namespace burl
#endif
