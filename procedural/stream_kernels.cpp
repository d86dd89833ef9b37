#include "procedural/stream_kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/stream_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/piece_lanes-inl.h"
#include "procedural/stream_sites-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Between 2^20 and 2^21 doubles are 2^-32 apart: a sum with this one is a fixed-point number.
constexpr double fixed_magic = 0x1.8p20;
/// Lines that stay this close to the cell of their start can be worked out that way.
constexpr double fixed_reach = 0x1p18;

/// Starts and steps of up to `capacity` pieces in the lattice, by axis.
struct PieceLines {
    static constexpr std::size_t capacity = 64;
    alignas(64) double start[3][capacity], step[3][capacity];
};

/// What an axis of a line needs: texel j has the fixed-point bits of `from` + j * step, plus
/// offset.
struct FixedAxis {
    hn::Vec<Doubles> from, step;
    hn::Vec<hn::RebindToUnsigned<Doubles>> offset;

    HWY_ATTR HWY_INLINE FixedAxis(double start, double line_step) {
        const Doubles d;
        // The nearest cell: added to the magic number, it makes the low bits of a double.
        const double shifted = start + round_magic, local = start - (shifted - round_magic);
        constexpr auto zero = std::bit_cast<std::uint64_t>(fixed_magic);
        from = hn::Set(d, local + fixed_magic);
        step = hn::Set(d, line_step);
        offset = hn::Set(hn::RebindToUnsigned<Doubles>(),
                         (std::bit_cast<std::uint64_t>(shifted) << 32) - zero);
    }

    HWY_ATTR HWY_INLINE void Store(hn::Vec<Doubles> index, std::uint64_t* out) const {
        const hn::RebindToUnsigned<Doubles> bits;
        const auto fixed = hn::BitCast(bits, hn::Add(from, hn::Mul(index, step)));
        hn::StoreU(hn::Add(fixed, offset), bits, out);
    }
};

HWY_ATTR HWY_INLINE void FillLine(const PieceLines& lines, std::size_t i, const LatticeLine& line,
                                  std::size_t at, LatticeStream& stream) {
    const Doubles d;
    const FixedAxis x(lines.start[0][i], lines.step[0][i]), y(lines.start[1][i], lines.step[1][i]),
        z(lines.start[2][i], lines.step[2][i]);
    const auto lanes = hn::Set(d, double(hn::Lanes(d)));
    auto index = hn::Add(LaneNumbers(), hn::Set(d, line.first));
    for (std::size_t j = 0; j < line.count; j += hn::Lanes(d)) {
        x.Store(index, stream.at[0] + at + j);
        y.Store(index, stream.at[1] + at + j);
        z.Store(index, stream.at[2] + at + j);
        index = hn::Add(index, lanes);
    }
}

/// For lines that FillLine cannot hold: far from the origin, or crossing very many cells.
HWY_ATTR void FillHardLine(const PieceLines& lines, std::size_t i, const LatticeLine& line,
                           double length, double limit, std::size_t at, LatticeStream& stream) {
    for (int axis = 0; axis < 3; ++axis) {
        const double start = lines.start[axis][i], step = lines.step[axis][i];
        const bool near = std::abs(start) + length * std::abs(step) < limit;
        for (std::size_t j = 0; j < line.count; ++j) {
            const double x = near ? start + (line.first + double(j)) * step : 0.0;
            const double cell = std::floor(x);
            // A sum: just below a cell's border x - cell rounds to 1, the next cell's place 0.
            stream.at[axis][at + j] =
                (std::uint64_t(std::int64_t(cell)) << 32) + std::uint64_t((x - cell) * 0x1p32);
        }
    }
}

/// lines = map of the pieces' lines.
HWY_ATTR void MapPieces(const Affine3& map, std::span<const Piece> pieces, PieceLines& lines) {
    const Doubles d;
    for (std::size_t i = 0; i < pieces.size(); i += hn::Lanes(d)) {
        const PieceLanes p(pieces, i);
        for (int axis = 0; axis < 3; ++axis) {
            const double a = map.linear[0][axis], b = map.linear[1][axis], c = map.linear[2][axis];
            const auto start = hn::Add(Dot(a, b, c, p.x, p.y, p.z), hn::Set(d, map.offset[axis]));
            hn::Store(start, d, lines.start[axis] + i);
            hn::Store(Dot(a, b, c, p.u, p.v, p.w), d, lines.step[axis] + i);
        }
    }
}

HWY_ATTR double FillStream(const Affine3& map, int doublings, std::span<const Piece> pieces,
                           LatticeStream& stream) {
    const double limit = std::ldexp(lattice_limit, -doublings);
    PieceLines lines;
    std::size_t at = 0;
    double planes = 0.0;
    for (std::size_t first = 0; first < pieces.size(); first += PieceLines::capacity) {
        const auto part =
            pieces.subspan(first, std::min(PieceLines::capacity, pieces.size() - first));
        MapPieces(map, part, lines);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const auto& [start, step, begin, count] = part[i].solid;
            const double length = std::max(part[i].length, begin + double(count));
            const auto extent = [&](int axis) { return length * std::abs(lines.step[axis][i]); };
            const auto easy = [&](int axis) {
                return extent(axis) < fixed_reach &&
                       std::abs(lines.start[axis][i]) + extent(axis) < limit;
            };
            if (easy(0) && easy(1) && easy(2))
                FillLine(lines, i, part[i].solid, at, stream);
            else
                FillHardLine(lines, i, part[i].solid, length, limit, at, stream);
            at += part[i].solid.count;
            planes += double(part[i].solid.count) *
                      (std::abs(lines.step[0][i]) + std::abs(lines.step[1][i]) +
                       std::abs(lines.step[2][i]));
        }
    }
    return planes;
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddOctaveOf(const StreamOctave& octave, const LatticeStream& stream,
                          std::size_t count, float* sums) {
    const Floats d;
    const Bit seed = hn::Set(Bits(), octave.seed * LatticeHash::prime_seed);
    const Float weight = hn::Set(d, octave.weight);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        Bit cell[3];
        Float place[3];
        for (int axis = 0; axis < 3; ++axis) {
            cell[axis] = CellsOf(stream.at[axis] + j, octave.doublings);
            place[axis] = PlacesOf(stream.at[axis] + j, octave.doublings);
        }
        const Float noise = EightfoldNoise<Corner, FadeFunction>(
            CellHash(seed, cell[0], cell[1], cell[2]), place[0], place[1], place[2]);
        hn::Store(hn::Add(hn::Load(d, sums + j), hn::Mul(weight, noise)), d, sums + j);
    }
}

HWY_ATTR void AddOctaveDirect(NoiseKind kind, Fade fade, const StreamOctave& octave,
                              const LatticeStream& stream, std::size_t count, float* sums) {
    with_noise(kind, fade, [&]<class Corner, class FadeFunction>() HWY_ATTR {
        AddOctaveOf<Corner, FadeFunction>(octave, stream, count, sums);
    });
}

HWY_ATTR void AddSums(double scale, const float* sums, std::size_t count, double* values) {
    const Doubles d;
    const auto scales = hn::Set(d, scale);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto sum = hn::PromoteTo(d, hn::Load(HalfFloats(), sums + j));
        hn::StoreU(hn::Add(hn::LoadU(d, values + j), hn::Mul(sum, scales)), d, values + j);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FillStream);
HWY_EXPORT(AddOctaveDirect);
HWY_EXPORT(AddSums);

double fill_stream(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                   LatticeStream& stream) {
    return HWY_DYNAMIC_DISPATCH(FillStream)(lattice_from_solid, doublings, pieces, stream);
}

void add_octave_direct(NoiseKind kind, Fade fade, const StreamOctave& octave,
                       const LatticeStream& stream, std::size_t count, float* sums) {
    HWY_DYNAMIC_DISPATCH(AddOctaveDirect)
    (kind, fade, octave, stream, count, sums);
}

void add_sums(double scale, const float* sums, std::size_t count, double* values) {
    HWY_DYNAMIC_DISPATCH(AddSums)(scale, sums, count, values);
}

}  // namespace burl
#endif
