// Lattice noise as noise.h defines it at vectors of points, with or without gradient, for every
// instruction set: from LatticeHash, and from the tables of 1985 and 2002. The file is included
// once per instruction set (hence the toggled guard), after hwy/foreach_target.h.
#if defined(BURL_POINT_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_POINT_NOISE_INL_H
#undef BURL_POINT_NOISE_INL_H
#else
#define BURL_POINT_NOISE_INL_H
#endif

#include "procedural/kernels/noise_corners-inl.h"
#include "procedural/noise/perlin1985.h"
#include "procedural/noise/perlin_noise.h"

#ifndef BURL_PERMUTATION_NUMBERS
#define BURL_PERMUTATION_NUMBERS
namespace burl {

/// The published permutation as 32-bit integers, which vectors can gather.
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

/// Cells and places, in [-1/2, 1/2] about the cells' middles, of a vector of points.
struct VectorSite {
    Bit cell[3];
    Float place[3];
};

/// Noise and its gradient at a vector of points.
struct VectorSample {
    Float value, slope[3];
};

/// Offsets of a vector of points from the cells' lower and upper corners, by axis.
struct CornerOffsets {
    Float from[3][2];

    HWY_ATTR HWY_INLINE explicit CornerOffsets(const VectorSite& at)
        : from{{Lower(at.place[0]), Upper(at.place[0])},
               {Lower(at.place[1]), Upper(at.place[1])},
               {Lower(at.place[2]), Upper(at.place[2])}} {}

  private:
    static HWY_ATTR HWY_INLINE Float Lower(Float u) { return hn::Add(u, hn::Set(Floats(), 0.5f)); }
    static HWY_ATTR HWY_INLINE Float Upper(Float u) { return hn::Sub(u, hn::Set(Floats(), 0.5f)); }
};

/// Twice the blend of a and b with the fade v: the values, the gradients as far as they are not 0
/// (with `sloping` all components, else those along axes already blended), and the slope along
/// `axis`.
template <int axis, bool sloping>
HWY_ATTR HWY_INLINE VectorSample TwiceBlend(Float v, Float v_slope, const VectorSample& a,
                                            const VectorSample& b) {
    VectorSample r = a;
    r.value = TwiceLerp(v, a.value, b.value);
    const Float own = hn::Mul(v_slope, hn::Sub(b.value, a.value));
    for (int i = 0; i < (sloping ? 3 : axis); ++i)
        r.slope[i] = TwiceLerp(v, a.slope[i], b.slope[i]);
    r.slope[axis] = sloping ? hn::Add(r.slope[axis], own) : own;
    return r;
}

/// Eight times the noise and its gradient, from corner(x, y, z), whose arguments are 0 or 1.
template <class FadeFunction, bool sloping, class Corner>
HWY_ATTR HWY_INLINE VectorSample EightfoldSample(const VectorSite& at, const Corner& corner) {
    const FadeFunction fade;
    Float v[3] = {at.place[0], at.place[1], at.place[2]};
    Float slope[3] = {v[0], v[1], v[2]};
    for (int axis = 0; axis < 3; ++axis) {
        const Float t = hn::Add(v[axis], v[axis]);
        v[axis] = fade(t);
        // The slope per cell is twice the slope by t, because t is twice the place.
        slope[axis] = hn::Add(fade.Slope(t), fade.Slope(t));
    }
    const auto edge = [&](int y, int z) HWY_ATTR {
        return TwiceBlend<0, sloping>(v[0], slope[0], corner(0, y, z), corner(1, y, z));
    };
    const auto plane = [&](int z) HWY_ATTR {
        return TwiceBlend<1, sloping>(v[1], slope[1], edge(0, z), edge(1, z));
    };
    return TwiceBlend<2, sloping>(v[2], slope[2], plane(0), plane(1));
}

/// The slope (gx, gy, gz) through a corner, at offset (x, y, z) from it.
HWY_ATTR HWY_INLINE VectorSample SlopeSample(Float gx, Float gy, Float gz, Float x, Float y,
                                             Float z) {
    return {hn::Add(hn::Add(hn::Mul(gx, x), hn::Mul(gy, y)), hn::Mul(gz, z)), {gx, gy, gz}};
}

HWY_ATTR HWY_INLINE VectorSample SampleOf(ValueCorner corner, Bit h, Float x, Float y, Float z) {
    const Float zero = hn::Zero(Floats());
    return {corner(h, x, y, z), {zero, zero, zero}};
}
HWY_ATTR HWY_INLINE VectorSample SampleOf(PerlinCorner corner, Bit h, Float x, Float y, Float z) {
#if HWY_TARGET <= HWY_AVX3
    const PerlinGradient g(h);
    const Float gx = g.along[0], gy = g.along[1], gz = g.along[2];
#else
    const Float one = hn::Set(Floats(), 1.0f), zero = hn::Zero(Floats());
    const Float gx = corner(h, one, zero, zero), gy = corner(h, zero, one, zero),
                gz = corner(h, zero, zero, one);
#endif
    return {corner(h, x, y, z), {gx, gy, gz}};
}

// A noise gives, by seed, 1 / unit times its value, or value and gradient, at a vector of sites.

/// Noise whose corners come from LatticeHash; 2^-exponent is its unit.
template <class Corner, class FadeFunction, int exponent>
struct HashedNoise {
    static constexpr double unit = exponent == 3 ? 0x1p-3 : 0x1p-26;

    static HWY_ATTR HWY_INLINE Bit Hash(std::uint32_t seed, const VectorSite& at) {
        return CellHash(hn::Set(Bits(), seed * LatticeHash::prime_seed), at.cell[0], at.cell[1],
                        at.cell[2]);
    }
    HWY_ATTR HWY_INLINE Float operator()(std::uint32_t seed, const VectorSite& at) const {
        return EightfoldNoise<Corner, FadeFunction>(Hash(seed, at), at.place[0], at.place[1],
                                                    at.place[2]);
    }
    HWY_ATTR HWY_INLINE VectorSample Sample(std::uint32_t seed, const VectorSite& at) const {
        const Bit low = Hash(seed, at);
        const CornerOffsets offsets(at);
        return EightfoldSample<FadeFunction, exponent == 3>(at, [&](int x, int y, int z) HWY_ATTR {
            const std::uint32_t step = std::uint32_t(x) * LatticeHash::prime_x +
                                       std::uint32_t(y) * LatticeHash::prime_y +
                                       std::uint32_t(z) * LatticeHash::prime_z;
            return SampleOf(Corner(), Mix(hn::Add(low, hn::Set(Bits(), step))), offsets.from[0][x],
                            offsets.from[1][y], offsets.from[2][z]);
        });
    }
};

/// Noise whose corners come from tables of 256 numbers: `Tables` has Hash(h) for the first two axes
/// and Corner(h, x, y, z) for the corner's sample.
template <class Tables, class FadeFunction>
struct TableNoise {
    static constexpr double unit = 0x1p-3;
    Tables tables;

    HWY_ATTR HWY_INLINE Float operator()(std::uint32_t seed, const VectorSite& at) const {
        return Sample(seed, at).value;
    }
    HWY_ATTR HWY_INLINE VectorSample Sample(std::uint32_t seed, const VectorSite& at) const {
        const Bit one = hn::Set(Bits(), 1);
        const auto shifted = [&](std::size_t axis) HWY_ATTR {
            return hn::Add(at.cell[axis], hn::Set(Bits(), LatticeHash::shift(seed, axis)));
        };
        const CornerOffsets offsets(at);
        const Bit x = shifted(0), y = shifted(1), z = shifted(2);
        const Bit low = hn::Add(tables.Hash(x), y), high = hn::Add(tables.Hash(hn::Add(x, one)), y);
        const Bit columns[2][2] = {
            {hn::Add(tables.Hash(low), z), hn::Add(tables.Hash(hn::Add(low, one)), z)},
            {hn::Add(tables.Hash(high), z), hn::Add(tables.Hash(hn::Add(high, one)), z)}};
        return EightfoldSample<FadeFunction, true>(at, [&](int i, int j, int k) HWY_ATTR {
            const Bit h = columns[i][j];
            return tables.Corner(k == 0 ? h : hn::Add(h, one), offsets.from[0][i],
                                 offsets.from[1][j], offsets.from[2][k]);
        });
    }
};

HWY_ATTR HWY_INLINE hn::Vec<Ints> LowByte(Bit h) {
    return hn::BitCast(Ints(), hn::And(h, hn::Set(Bits(), 255)));
}

/// The tables of 2002: the published permutation and the edges of a cube.
struct PublishedTables {
    HWY_ATTR HWY_INLINE Bit Hash(Bit h) const {
        return hn::BitCast(Bits(), hn::GatherIndex(Ints(), permutation_numbers.data(), LowByte(h)));
    }
    HWY_ATTR HWY_INLINE VectorSample Corner(Bit h, Float x, Float y, Float z) const {
        return SampleOf(PerlinCorner(), hn::ShiftLeft<28>(Hash(h)), x, y, z);
    }
};

/// The tables of 1985: ClassicTables' permutation and gradients.
struct Tables1985 {
    const std::int32_t* permutation = nullptr;
    const float* gradients = nullptr;
    HWY_ATTR HWY_INLINE Bit Hash(Bit h) const {
        return hn::BitCast(Bits(), hn::GatherIndex(Ints(), permutation, LowByte(h)));
    }
    HWY_ATTR HWY_INLINE VectorSample Corner(Bit h, Float x, Float y, Float z) const {
        const auto number = LowByte(h), at = hn::Add(number, hn::Add(number, number));
        const auto component = [&](int axis) HWY_ATTR {
            return hn::GatherIndex(Floats(), gradients + axis, at);
        };
        return SlopeSample(component(0), component(1), component(2), x, y, z);
    }
};

/// Calls visit(noise) with the kernel of the noise, which has_point_kernel must allow.
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

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
