#include "procedural/kernels/simplex_kernel.h"

#include <cmath>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/simplex_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/stream_sites-inl.h"
#include "procedural/noise/simplex_hash.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

using Bytes = hn::Repartition<std::uint8_t, Bits>;
using IntMask = hn::Mask<Ints>;

/// x + step where `mask` is set, else x.
HWY_ATTR HWY_INLINE Bit AddIf(IntMask mask, Bit x, std::uint32_t step) {
    return hn::IfThenElse(hn::RebindMask(Bits(), mask), hn::Add(x, hn::Set(Bits(), step)), x);
}
HWY_ATTR HWY_INLINE Float AddIf(IntMask mask, Float x, float step) {
    return hn::IfThenElse(hn::RebindMask(Floats(), mask), hn::Add(x, hn::Set(Floats(), step)), x);
}

/// n divided by 3, modulo 2^32: n = 3 quotient + 0, 1 or 2, and the masks of rests 1 and 2.
struct Thirds {
    Bit quotient;
    IntMask one, two;
};

/// The division by 3 of -2^31 < n < 2^31 - 2. With the inverse of 3 modulo 2^32, n * inverse =
/// quotient + rest * inverse, where the three rests make numbers that lie far apart.
HWY_ATTR HWY_INLINE Thirds ThirdsOf(Bit n) {
    constexpr std::uint32_t inverse = 0xaaaaaaabu;
    const Bit product = hn::Mul(n, hn::Set(Bits(), inverse));
    const auto signed_product = hn::BitCast(Ints(), product);
    const auto one = hn::Lt(signed_product, hn::Set(Ints(), -0x2aaaaaaa));
    const auto two = hn::Gt(signed_product, hn::Set(Ints(), 0x2aaaaaaa));
    return {AddIf(two, AddIf(one, product, 0u - inverse), 0u - 2 * inverse), one, two};
}

/// The places of a vector of texels in the skewed lattice.
struct SimplexSites {
    Bit corner[3];              ///< lowest corner of the skewed cube, less 1
    Float offset[3];            ///< the texel less the cube's lowest corner, unskewed
    IntMask first[3], last[3];  ///< axis of the walk's first and last step
};

/// The sites of texels at cells and places (in units of 2^-32 cells). Whole numbers decide the
/// simplex: a texel at a multiple of 2^-29 gets that of exact arithmetic, like simplex_place; other
/// texels are moved down to such a multiple.
HWY_ATTR HWY_INLINE SimplexSites SitesOf(const Bit* cell, const Bit* place) {
    const Floats d;
    const Bits bits;
    constexpr std::uint32_t one = 1u << 29;
    const Bit p[3] = {hn::ShiftRight<3>(place[0]), hn::ShiftRight<3>(place[1]),
                      hn::ShiftRight<3>(place[2])};
    // The skew is a third of the coordinates' sum; it is 1 too small, so that small sums are
    // negative numbers.
    const Thirds cells = ThirdsOf(hn::Add(hn::Add(cell[0], cell[1]), cell[2]));
    const Bit places = hn::Add(hn::Add(p[0], p[1]), hn::Add(p[2], hn::Set(bits, 0u - 3 * one)));
    const Bit skew = ThirdsOf(AddIf(cells.two, AddIf(cells.one, places, one), 2 * one)).quotient;
    SimplexSites sites;
    hn::Vec<Ints> way[3];
    Float y[3];
    for (int axis = 0; axis < 3; ++axis) {
        const Bit skewed = hn::Add(p[axis], skew);
        const Bit step = hn::BitCast(bits, hn::ShiftRight<29>(hn::BitCast(Ints(), skewed)));
        sites.corner[axis] = hn::Add(hn::Add(cell[axis], cells.quotient), step);
        way[axis] =
            hn::BitCast(Ints(), hn::Xor(hn::ShiftLeft<3>(skewed), hn::Set(bits, 0x80000000u)));
        y[axis] = hn::Mul(hn::ConvertTo(d, way[axis]), hn::Set(d, 0x1p-32f));
    }
    // y is the place in the skewed cube, from its middle; unskewing subtracts a sixth of the sum.
    const Float sum = hn::Add(hn::Add(y[0], y[1]), y[2]);
    const Float back = hn::Sub(hn::Set(d, 0.25f), hn::Mul(sum, hn::Set(d, 1.0f / 6.0f)));
    for (int axis = 0; axis < 3; ++axis) sites.offset[axis] = hn::Add(y[axis], back);
    // The largest offset goes first; of equal ones that along the lower axis, as the appendix has
    // it.
    const auto x_below_y = hn::Lt(way[0], way[1]), x_below_z = hn::Lt(way[0], way[2]),
               y_below_z = hn::Lt(way[1], way[2]);
    sites.first[0] = hn::Not(hn::Or(x_below_y, x_below_z));
    sites.first[1] = hn::AndNot(y_below_z, x_below_y);
    sites.first[2] = hn::And(x_below_z, y_below_z);
    sites.last[0] = hn::And(x_below_y, x_below_z);
    sites.last[1] = hn::AndNot(x_below_y, y_below_z);
    sites.last[2] = hn::Not(hn::Or(x_below_z, y_below_z));
    return sites;
}

#if HWY_TARGET == HWY_SCALAR

/// A corner's coordinate as its hash takes it.
using AxisHash = Bit;

template <std::size_t axis>
HWY_ATTR HWY_INLINE AxisHash HashAxis(Bit index) {
    return index;
}

HWY_ATTR HWY_INLINE AxisHash Choose(IntMask mask, AxisHash yes, AxisHash no) {
    return hn::IfThenElse(hn::RebindMask(Bits(), mask), yes, no);
}

HWY_ATTR HWY_INLINE Bit GradientCode(AxisHash x, AxisHash y, AxisHash z) {
    return hn::Set(Bits(),
                   simplex_code(bit_pattern_sum(hn::GetLane(x), hn::GetLane(y), hn::GetLane(z))));
}

#else

/// table[byte] for every byte: 0 where its bit 7 is set; otherwise its lower four bits are the
/// index.
HWY_ATTR HWY_INLINE Bit LookUp(const ByteTable& table, Bit bytes) {
    const Bytes d8;
    return hn::BitCast(
        Bits(), hn::TableLookupBytes(hn::LoadDup128(d8, table.data()), hn::BitCast(d8, bytes)));
}

/// Byte i of the result is byte (i & keep) ^ flip of x.
template <std::size_t keep, std::size_t flip>
HWY_ATTR HWY_INLINE Bit Reorder(Bit x) {
    HWY_ALIGN static constexpr ByteTable order = byte_order(keep, flip);
    const Bytes d8;
    return hn::BitCast(Bits(),
                       hn::TableLookupBytes(hn::BitCast(d8, x), hn::LoadDup128(d8, order.data())));
}

HWY_ATTR HWY_INLINE Bit AddBytes(Bit x, Bit y) {
    const Bytes d8;
    return hn::BitCast(Bits(), hn::Add(hn::BitCast(d8, x), hn::BitCast(d8, y)));
}

/// The bits that a corner's coordinate along an axis contributes to the numbers of the patterns 0
/// to 3 and 4 to 7.
struct AxisHash {
    Bit low, high;
};

template <std::size_t axis>
HWY_ATTR HWY_INLINE AxisHash HashAxis(Bit index) {
    HWY_ALIGN static constexpr ByteTable low = pattern_bits(axis, 0), high = pattern_bits(axis, 1);
    const Bit each = hn::Set(Bits(), 0x08040201u), bytes = Reorder<12, 0>(index);
    return {LookUp(low, hn::And(bytes, each)),
            LookUp(high, hn::And(hn::ShiftRight<4>(bytes), each))};
}

HWY_ATTR HWY_INLINE AxisHash Choose(IntMask mask, AxisHash yes, AxisHash no) {
    const auto m = hn::RebindMask(Bits(), mask);
    return {hn::IfThenElse(m, yes.low, no.low), hn::IfThenElse(m, yes.high, no.high)};
}

/// The top bytes of twice a corner's gradient along x, y and z, in bytes 3, 2 and 1 of every lane.
HWY_ATTR HWY_INLINE Bit GradientCode(AxisHash x, AxisHash y, AxisHash z) {
    HWY_ALIGN static constexpr ByteTable patterns = pattern_table(), roles = role_table(),
                                         signs = sign_bits(), values = sign_table();
    const Bits d;
    const Bit low = LookUp(patterns, hn::Or(hn::Or(x.low, y.low), z.low));
    const Bit high = LookUp(patterns, hn::Or(hn::Or(x.high, y.high), z.high));
    const Bit four = AddBytes(low, high), two = AddBytes(four, Reorder<15, 2>(four));
    const Bit hash = AddBytes(two, Reorder<15, 1>(two));  // the hash in every byte
    const Bit role =
        LookUp(roles, hn::Or(hn::And(hash, hn::Set(d, 0x03030303u)), hn::Set(d, 0x0c080400u)));
    const Bit sign = LookUp(signs, hn::Or(role, hn::And(hash, hn::Set(d, 0x04040404u))));
    const Bit upper = hn::And(hn::ShiftRight<3>(hash), hn::Set(d, 0x07070707u));
    return LookUp(values, hn::Or(sign, upper));
}

#endif

/// Twice the gradient of a code, components 2, 0 or -2, whose floats are 0 but for the top byte.
HWY_ATTR HWY_INLINE void DecodeGradient(Bit code, Float* g) {
    const Floats d;
    const Bit top = hn::Set(Bits(), 0xff000000u);
    g[0] = hn::BitCast(d, hn::And(code, top));
    g[1] = hn::BitCast(d, hn::And(hn::ShiftLeft<8>(code), top));
    g[2] = hn::BitCast(d, hn::ShiftLeft<16>(code));
}

/// Calls visit(g, d) for the corners of the simplices from the lowest to the highest: twice the
/// gradient (components 2, 0 and -2) and the texel's offset. `shift` is added to the corners'
/// coordinates.
template <class Visit>
HWY_ATTR HWY_INLINE void ForEachCorner(const SimplexSites& sites, const std::uint32_t* shift,
                                       const Visit& visit) {
    const Floats d;
    const Bits bits;
    const Bit next = hn::Set(bits, 1u);
    // The 1 makes up for the skew, which SitesOf leaves 1 too small.
    const Bit x = hn::Add(sites.corner[0], hn::Set(bits, shift[0] + 1)),
              y = hn::Add(sites.corner[1], hn::Set(bits, shift[1] + 1)),
              z = hn::Add(sites.corner[2], hn::Set(bits, shift[2] + 1));
    const AxisHash x0 = HashAxis<0>(x), x1 = HashAxis<0>(hn::Add(x, next));
    const AxisHash y0 = HashAxis<1>(y), y1 = HashAxis<1>(hn::Add(y, next));
    const AxisHash z0 = HashAxis<2>(z), z1 = HashAxis<2>(hn::Add(z, next));
    const IntMask *first = sites.first, *last = sites.last;
    Float g[3], offset[3];
    DecodeGradient(GradientCode(x0, y0, z0), g);
    visit(g, sites.offset);
    DecodeGradient(
        GradientCode(Choose(first[0], x1, x0), Choose(first[1], y1, y0), Choose(first[2], z1, z0)),
        g);
    for (int axis = 0; axis < 3; ++axis)
        offset[axis] =
            AddIf(first[axis], hn::Add(sites.offset[axis], hn::Set(d, 1.0f / 6.0f)), -1.0f);
    visit(g, offset);
    DecodeGradient(
        GradientCode(Choose(last[0], x0, x1), Choose(last[1], y0, y1), Choose(last[2], z0, z1)), g);
    for (int axis = 0; axis < 3; ++axis)
        offset[axis] =
            AddIf(last[axis], hn::Sub(sites.offset[axis], hn::Set(d, 2.0f / 3.0f)), 1.0f);
    visit(g, offset);
    DecodeGradient(GradientCode(x1, y1, z1), g);
    for (int axis = 0; axis < 3; ++axis)
        offset[axis] = hn::Sub(sites.offset[axis], hn::Set(d, 0.5f));
    visit(g, offset);
}

HWY_ATTR HWY_INLINE Float Dot(const Float* a, const Float* b) {
    return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}

HWY_ATTR HWY_INLINE SimplexSites SitesAt(const LatticeStream& stream, int doublings,
                                         std::size_t j) {
    Bit cell[3], place[3];
    for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = CellsOf(stream, axis, j, doublings);
        place[axis] = PlaceBitsOf(stream, axis, j, doublings);
    }
    return SitesOf(cell, place);
}

/// The shift of the corners of cubes by a seed, along each axis.
struct SeedShift {
    std::uint32_t along[3];

    explicit SeedShift(std::uint32_t seed)
        : along{LatticeHash::shift(seed, 0), LatticeHash::shift(seed, 1),
                LatticeHash::shift(seed, 2)} {}
};

/// radius^2 less the squared distance, or 0 where that is negative. The squares are summed first,
/// because their sum is small where the kernel is large.
HWY_ATTR HWY_INLINE Float Height(Float radius, const Float* offset) {
    return hn::Max(hn::Sub(radius, Dot(offset, offset)), hn::Zero(Floats()));
}

HWY_ATTR HWY_INLINE void AddScaledTo(float* sum, Float weight, Float term) {
    const Floats d;
    hn::Store(hn::Add(hn::Load(d, sum), hn::Mul(weight, term)), d, sum);
}

HWY_ATTR void AddSimplexOctave(const StreamOctave& octave, const LatticeStream& stream,
                               const CellRuns*, std::size_t count, float* sums, GradientSums*) {
    const Floats d;
    const SeedShift shift(octave.seed);
    const Float radius = hn::Set(d, float(octave.radius2)), weight = hn::Set(d, octave.weight);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        Float noise = hn::Zero(d);
        ForEachCorner(SitesAt(stream, octave.doublings, j), shift.along,
                      [&](const Float* g, const Float* offset) HWY_ATTR {
                          const Float t = Height(radius, offset), t2 = hn::Mul(t, t);
                          const Float t4 = hn::Mul(t2, t2);
                          noise = hn::Add(noise, hn::Mul(t4, Dot(g, offset)));
                      });
        AddScaledTo(sums + j, weight, noise);
    }
}

HWY_ATTR void AddSimplexOctaveAndGradient(const StreamOctave& octave, const LatticeStream& stream,
                                          const CellRuns*, std::size_t count, float* sums,
                                          GradientSums* gradients) {
    const Floats d;
    const SeedShift shift(octave.seed);
    const Float radius = hn::Set(d, float(octave.radius2)), weight = hn::Set(d, octave.weight);
    const Float steepness = hn::Set(d, std::ldexp(octave.weight, octave.doublings));
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        Float noise = hn::Zero(d), along[3] = {noise, noise, noise};
        ForEachCorner(
            SitesAt(stream, octave.doublings, j), shift.along,
            [&](const Float* g, const Float* offset) HWY_ATTR {
                const Float t = Height(radius, offset), t2 = hn::Mul(t, t);
                const Float t4 = hn::Mul(t2, t2), slope = Dot(g, offset);
                noise = hn::Add(noise, hn::Mul(t4, slope));
                // d(t^4) / d(offset) is -8 t^3 offset.
                const Float fall = hn::Mul(hn::Mul(hn::Set(d, 8.0f), hn::Mul(t2, t)), slope);
                for (int axis = 0; axis < 3; ++axis)
                    along[axis] = hn::Add(
                        along[axis], hn::Sub(hn::Mul(t4, g[axis]), hn::Mul(fall, offset[axis])));
            });
        AddScaledTo(sums + j, weight, noise);
        for (int axis = 0; axis < 3; ++axis)
            AddScaledTo(gradients->along[axis] + j, steepness, along[axis]);
    }
}

HWY_ATTR OctaveKernel SimplexKernel(bool gradients) {
    return gradients ? AddSimplexOctaveAndGradient : AddSimplexOctave;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(SimplexKernel);

OctaveKernel simplex_kernel(bool gradients) {
    return HWY_DYNAMIC_DISPATCH(SimplexKernel)(gradients);
}

}  // namespace burl
#endif
