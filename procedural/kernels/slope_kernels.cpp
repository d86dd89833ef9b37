#include "procedural/kernels/slope_kernels.h"

#include <algorithm>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/slope_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/noise_gradient-inl.h"
#include "procedural/kernels/piece_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

template <class Corner, class FadeFunction>
HWY_ATTR void AddOctaveAndGradient(const StreamOctave& octave, const LatticeStream& stream,
                                   const CellRuns*, std::size_t count, float* sums,
                                   GradientSums* gradients) {
    const Floats d;
    const Bit seed = hn::Set(Bits(), octave.seed * LatticeHash::prime_seed);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto cell = [&](int axis)
                              HWY_ATTR { return CellsOf(stream, axis, j, octave.doublings); };
        const StreamPlaces<FadeFunction> at(stream, j, octave.doublings);
        const auto planes = PlanesOf<Corner>(CellHash(seed, cell(0), cell(1), cell(2)));
        AddGradient(octave, GradientOf(at, planes.low, planes.high), j, sums, *gradients);
    }
}

HWY_ATTR OctaveKernel GradientKernel(NoiseKind kind, Fade fade) {
    return with_noise(kind, fade, []<class Corner, class FadeFunction>() -> OctaveKernel {
        return AddOctaveAndGradient<Corner, FadeFunction>;
    });
}

/// slope[j] += the gradient of texel at + j times the side (x, y, z), for `count` texels.
HWY_ATTR HWY_INLINE void AddSlope(const GradientSums& gradients, std::size_t at, std::size_t count,
                                  float x, float y, float z, float* slope) {
    const Floats d;
    const Float sx = hn::Set(d, x), sy = hn::Set(d, y), sz = hn::Set(d, z);
    const auto& [gx, gy, gz] = gradients.along;
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const Float xy =
            hn::Add(hn::Mul(hn::LoadU(d, gx + at + j), sx), hn::Mul(hn::LoadU(d, gy + at + j), sy));
        Float change = hn::Add(xy, hn::Mul(hn::LoadU(d, gz + at + j), sz));
        // The texels beyond `count` are another piece's.
        if (count - j < hn::Lanes(d)) change = hn::IfThenElseZero(FirstLanes(count - j), change);
        hn::StoreU(hn::Add(hn::LoadU(d, slope + j), change), d, slope + j);
    }
}

HWY_ATTR void AddSlopes(const Affine3& map, double scale, std::span<const Piece> pieces,
                        const GradientSums& gradients, SlopeBatch& slopes) {
    PieceSides sides;
    std::size_t at = 0;
    for (std::size_t first = 0; first < pieces.size(); first += PieceSides::capacity) {
        const auto part =
            pieces.subspan(first, std::min(PieceSides::capacity, pieces.size() - first));
        sides.Map(map, scale, part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::size_t count = part[i].solid.count;
            AddSlope(gradients, at, count, float(sides.u[0][i]), float(sides.u[1][i]),
                     float(sides.u[2][i]), slopes.u + at);
            AddSlope(gradients, at, count, float(sides.v[0][i]), float(sides.v[1][i]),
                     float(sides.v[2][i]), slopes.v + at);
            at += count;
        }
    }
}

/// The slopes of the quadric along the lines of pieces: lines[0] is the slope along u at the line's
/// start, lines[1] its change per texel; lines[2] and lines[3] are those along v.
HWY_ATTR void MakeSlopeLines(const Quadric& q, std::span<const Piece> pieces,
                             double (*lines)[PieceSides::capacity]) {
    const Doubles d;
    const auto two = hn::Set(d, 2.0);
    for (std::size_t i = 0; i < pieces.size(); i += hn::Lanes(d)) {
        const PieceLanes p(pieces, i);
        // Half the gradient at the start, and its change along a step.
        const auto gx = hn::Add(Dot(q.a, q.b, q.c, p.x, p.y, p.z), hn::Set(d, q.d)),
                   gy = hn::Add(Dot(q.b, q.e, q.f, p.x, p.y, p.z), hn::Set(d, q.g)),
                   gz = hn::Add(Dot(q.c, q.f, q.h, p.x, p.y, p.z), hn::Set(d, q.i));
        const auto hx = Dot(q.a, q.b, q.c, p.u, p.v, p.w), hy = Dot(q.b, q.e, q.f, p.u, p.v, p.w),
                   hz = Dot(q.c, q.f, q.h, p.u, p.v, p.w);
        const auto store = [&](Double half, double* out)
                               HWY_ATTR { hn::Store(hn::Mul(two, half), d, out + i); };
        store(Dot(gx, gy, gz, p.u, p.v, p.w), lines[0]);
        store(Dot(hx, hy, hz, p.u, p.v, p.w), lines[1]);
        store(Dot(gx, gy, gz, p.down_x, p.down_y, p.down_z), lines[2]);
        store(Dot(hx, hy, hz, p.down_x, p.down_y, p.down_z), lines[3]);
    }
}

HWY_ATTR void FillQuadricSlopes(const Quadric& quadric, std::span<const Piece> pieces,
                                SlopeBatch& slopes) {
    const Doubles d;
    alignas(64) double lines[4][PieceSides::capacity];
    const auto lanes = hn::Set(d, double(hn::Lanes(d)));
    float *u = slopes.u, *v = slopes.v;
    for (std::size_t first = 0; first < pieces.size(); first += PieceSides::capacity) {
        const auto part =
            pieces.subspan(first, std::min(PieceSides::capacity, pieces.size() - first));
        MakeSlopeLines(quadric, part, lines);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const LatticeLine& line = part[i].solid;
            const auto u0 = hn::Set(d, lines[0][i]), u1 = hn::Set(d, lines[1][i]),
                       v0 = hn::Set(d, lines[2][i]), v1 = hn::Set(d, lines[3][i]);
            auto x = hn::Add(LaneNumbers(), hn::Set(d, line.first));
            for (std::size_t j = 0; j < line.count; j += hn::Lanes(d)) {
                hn::StoreU(hn::DemoteTo(HalfFloats(), hn::Add(u0, hn::Mul(x, u1))), HalfFloats(),
                           u + j);
                hn::StoreU(hn::DemoteTo(HalfFloats(), hn::Add(v0, hn::Mul(x, v1))), HalfFloats(),
                           v + j);
                x = hn::Add(x, lanes);
            }
            u += line.count, v += line.count;
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(GradientKernel);
HWY_EXPORT(AddSlopes);
HWY_EXPORT(FillQuadricSlopes);

OctaveKernel gradient_kernel(NoiseKind kind, Fade fade) {
    return HWY_DYNAMIC_DISPATCH(GradientKernel)(kind, fade);
}

void add_slopes(const Affine3& lattice_from_solid, double scale, std::span<const Piece> pieces,
                const GradientSums& gradients, SlopeBatch& slopes) {
    HWY_DYNAMIC_DISPATCH(AddSlopes)(lattice_from_solid, scale, pieces, gradients, slopes);
}

void fill_quadric_slopes(const Quadric& quadric, std::span<const Piece> pieces,
                         SlopeBatch& slopes) {
    HWY_DYNAMIC_DISPATCH(FillQuadricSlopes)(quadric, pieces, slopes);
}

}  // namespace burl
#endif
