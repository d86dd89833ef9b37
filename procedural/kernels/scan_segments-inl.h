// Segments of scan lines, the runs of texels that lie in one lattice cell, for every instruction
// set. The crossings of a line with lattice planes are computed per axis ("Bresenham Noise", Kameya
// & Hart, walks them one by one); a segment's cell is the cell of its middle, so that a crossing
// which rounding moves by a texel cannot put the whole segment into the wrong cell. Included once
// per instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_SCAN_SEGMENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_SCAN_SEGMENTS_INL_H
#undef BURL_SCAN_SEGMENTS_INL_H
#else
#define BURL_SCAN_SEGMENTS_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "procedural/kernels/scanline_kernel.h"
#include "procedural/numbers/set_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Begin of the segment of a piece's first texel (the largest lane) and end of the segment of its
/// last texel (the smallest lane), in texels relative to the piece's first texel.
struct PieceEnds {
    Double begin, end;
};

/// The step, in cells per texel, from which on every texel of a line is a segment: a plane is
/// crossed at least every other texel.
constexpr double fast_step = 0.5;
/// The change on a whole line, in cells, up to which an axis crosses no plane.
constexpr double no_step = 0x1p-40;

/// Marks the texels that are the first after a crossing on one axis, and narrows `ends` to the
/// segments of the piece's first and last texel: plane k, counted in the line's direction, is
/// crossed before texel ceil((k - start) / step).
HWY_ATTR HWY_INLINE void MarkCrossings(const ScanLine& scan, int axis, double scale,
                                       std::uint8_t* marks, PieceEnds& ends) {
    const Doubles d;
    const double step = scale * std::abs(scan.line.step[axis]);
    const double first = scan.line.first, count = double(scan.line.count);
    if (!(scan.length * step > no_step)) return;
    if (step >= fast_step) {
        std::memset(marks, 1, scan.line.count);
        ends = {hn::Zero(d), hn::Set(d, count)};
        return;
    }
    double start = scale * scan.line.start[axis];
    start -= std::floor(start);
    if (scan.line.step[axis] < 0.0) start = 1.0 - start;
    const double last_plane = std::floor(start + (first + count) * step) + 1.0;
    const auto zero = hn::Zero(d), all = hn::Set(d, count);
    const auto per_cell = hn::Set(d, scan.texels_per_cell[axis] / scale);
    HWY_ALIGN std::int32_t texels[HWY_MAX_BYTES / sizeof(double)];
    for (double plane = std::floor(start + first * step) - 1.0; plane <= last_plane;
         plane += double(hn::Lanes(d))) {
        const auto planes = hn::Add(LaneNumbers(), hn::Set(d, plane));
        const auto at = hn::Sub(hn::Ceil(hn::Mul(hn::Sub(planes, hn::Set(d, start)), per_cell)),
                                hn::Set(d, first));
        ends.begin = hn::IfThenElse(hn::Le(at, zero), hn::Max(ends.begin, at), ends.begin);
        ends.end = hn::IfThenElse(hn::Ge(at, all), hn::Min(ends.end, at), ends.end);
        hn::Store(hn::DemoteTo(HalfInts(), hn::Min(hn::Max(at, zero), all)), HalfInts(), texels);
        for (std::size_t i = 0; i < hn::Lanes(d); ++i) marks[texels[i]] = 1;
    }
}

/// Marks the first texels of a piece's segments; `begin` and `end` are those of PieceEnds.
HWY_ATTR void MarkPiece(const ScanLine& scan, double scale, std::uint8_t* marks, double& begin,
                        double& end) {
    const Doubles d;
    PieceEnds ends{hn::Set(d, -scan.line.first), hn::Set(d, scan.length - scan.line.first)};
    marks[0] = 1;
    for (int axis = 0; axis < 3; ++axis) MarkCrossings(scan, axis, scale, marks, ends);
    begin = hn::GetLane(hn::MaxOfLanes(d, ends.begin));
    end = hn::GetLane(hn::MinOfLanes(d, ends.end));
}

/// The number of segments that begin before `texel`.
HWY_ATTR HWY_INLINE std::size_t SegmentsBefore(std::size_t texel, const std::uint32_t* before,
                                               const ScanSegments& segments) {
    const std::uint64_t earlier = (std::uint64_t(1) << texel % 64) - 1;
    return before[texel / 64] + std::size_t(std::popcount(segments.borders[texel / 64] & earlier));
}

/// Bit set of 64 bytes: bit i is set if byte i is not 0.
HWY_ATTR HWY_INLINE std::uint64_t MarkedBits(const std::uint8_t* marks) {
    std::uint64_t bits = 0;
#if HWY_TARGET == HWY_SCALAR
    for (std::size_t i = 0; i < 64; ++i) bits |= std::uint64_t(marks[i] != 0) << i;
#else
    const hn::ScalableTag<std::uint8_t> d;
    for (std::size_t i = 0; i < 64; i += hn::Lanes(d)) {
        std::uint64_t part = 0;
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, hn::Ne(hn::Load(d, marks + i), hn::Zero(d)), bytes);
        std::memcpy(&part, bytes, sizeof(part));
        bits |= part << i;
    }
    static_assert(std::endian::native == std::endian::little);
#endif
    return bits;
}

/// Lists the segments of a batch from its marks, one byte per texel: `first` gets the segments'
/// first texels and then `count`; before[w] gets the number of segments that begin before texel 64
/// w.
HWY_ATTR void ListSegments(const std::uint8_t* marks, std::size_t count, std::uint32_t* first,
                           std::uint32_t* before, ScanSegments& segments) {
    std::uint32_t found = 0;
    for (std::size_t word = 0; word <= count / 64; ++word) {
        std::uint64_t borders = MarkedBits(marks + 64 * word);
        segments.borders[word] = borders, before[word] = found;
        for (std::size_t i = 64 * word; borders; i += 8, borders >>= 8) {
            const auto byte = std::uint8_t(borders);
            StoreEight(set_bits, byte, 8, std::uint32_t(i), first + found);
            found += bits_up_to[byte][7];
        }
    }
    segments.count = found;
    first[found] = std::uint32_t(count);
}

/// Sets the cells, positions and steps on one axis of `count` segments from number `at` on, whose
/// middles lie at start + middles[i] * step.
HWY_ATTR void PlaceMiddles(const double* middles, std::size_t count, double start, double step,
                           int axis, std::size_t at, ScanSegments& segments) {
    const Doubles d;
    const double base = std::floor(start);
    const auto local = hn::Set(d, (start - base) - 0.5), steps = hn::Set(d, step);
    const auto magic = hn::Set(d, round_magic);
    const auto base_cell = hn::Set(HalfBits(), std::uint32_t(std::int64_t(base)));
    const auto float_step = hn::Set(HalfFloats(), float(step));
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto y = hn::Add(local, hn::Mul(hn::Load(d, middles + i), steps));
        const auto shifted = hn::Add(y, magic);
        const auto place = hn::Sub(y, hn::Sub(shifted, magic));
        const auto cell =
            hn::TruncateTo(HalfBits(), hn::BitCast(hn::RebindToUnsigned<Doubles>(), shifted));
        hn::StoreU(hn::Add(cell, base_cell), HalfBits(), segments.cells[axis] + at + i);
        hn::StoreU(hn::DemoteTo(HalfFloats(), place), HalfFloats(), segments.places[axis] + at + i);
        hn::StoreU(float_step, HalfFloats(), segments.steps[axis] + at + i);
    }
}

/// Computes the middles of a piece's `count` segments as texel indices of its line (`middles`) and
/// of the batch (`batch_middles`). `first` holds count + 1 first texels of segments in the batch;
/// `begins` and `ends` are those of PieceEnds.
HWY_ATTR void FindMiddles(const ScanLine& scan, double begins, double ends, std::size_t at,
                          const std::uint32_t* first, std::size_t count, double* middles,
                          float* batch_middles) {
    const Doubles d;
    const double offset = scan.line.first - double(at);
    const auto middle = [&](auto begin, auto end) HWY_ATTR {
        return hn::Mul(hn::Add(begin, hn::Sub(end, hn::Set(d, 1.0))), hn::Set(d, 0.5));
    };
    const auto integers = [](const std::uint32_t* from) HWY_ATTR {
        return hn::BitCast(HalfInts(), hn::LoadU(HalfBits(), from));
    };
    const auto offsets = hn::Set(d, offset);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto begin = hn::PromoteTo(d, integers(first + i));
        const auto end = hn::PromoteTo(d, integers(first + i + 1));
        const auto m = middle(begin, end);
        hn::Store(hn::Add(m, offsets), d, middles + i);
        hn::StoreU(hn::DemoteTo(HalfFloats(), m), HalfFloats(), batch_middles + i);
    }
    const auto move = [&](std::size_t i, double by) {
        middles[i] += by;
        batch_middles[i] = float(middles[i] - offset);
    };
    // The first and the last segment may continue in other pieces.
    move(0, 0.5 * begins);
    move(count - 1, 0.5 * (ends - double(scan.line.count)));
}

/// Finds the segments of all lines in the lattice of the octave with `doublings`; returns the
/// number of texels.
HWY_ATTR std::size_t FindSegments(std::span<const ScanLine> lines, int doublings,
                                  ScanSegments& segments) {
    const double scale = std::ldexp(1.0, doublings);
    HWY_ALIGN std::uint8_t marks[batch_capacity + 64] = {};
    std::uint32_t first[batch_capacity + batch_padding], before[ScanSegments::words];
    HWY_ALIGN double middles[batch_capacity + batch_padding];
    std::size_t count = 0;
    struct {
        double begin, end;
    } ends[batch_capacity];
    for (std::size_t i = 0; i < lines.size(); ++i) {
        MarkPiece(lines[i], scale, marks + count, ends[i].begin, ends[i].end);
        count += lines[i].line.count;
    }
    marks[count] = 0;
    ListSegments(marks, count, first, before, segments);
    std::size_t at = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LatticeLine& line = lines[i].line;
        const std::size_t begin = SegmentsBefore(at, before, segments);
        const std::size_t part = SegmentsBefore(at + line.count, before, segments) - begin;
        FindMiddles(lines[i], ends[i].begin, ends[i].end, at, first + begin, part, middles,
                    segments.middle + begin);
        for (int axis = 0; axis < 3; ++axis)
            PlaceMiddles(middles, part, scale * line.start[axis], scale * line.step[axis], axis,
                         begin, segments);
        at += line.count;
    }
    return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
