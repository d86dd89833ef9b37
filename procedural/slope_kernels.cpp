#include "procedural/slope_kernels.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/slope_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/noise_corners-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// What a texel's step does to the value at a corner itself: nothing for value noise.
template <class Corner>
struct CornerSlope {
    static constexpr bool any = true;
};
template <>
struct CornerSlope<ValueCorner> {
    static constexpr bool any = false;
};

/// One vector of texels: eight times the noise, and its changes along u and v. Corners are
/// interpolated as EightfoldNoise does, so that values have the same bits.
template <class Corner, class FadeFunction>
HWY_ATTR HWY_INLINE void NoiseAndSlopes(Bit seed, const LatticeBatch& batch,
                                        const DirectionBatch& directions, std::size_t j,
                                        Float& noise, Float& slope_u, Float& slope_v) {
    const Floats d;
    const Corner corner;
    const FadeFunction fade;
    const Float x = hn::Load(d, batch.places[0] + j), y = hn::Load(d, batch.places[1] + j),
                z = hn::Load(d, batch.places[2] + j);
    const Float half = hn::Set(d, 0.5f);
    const Float x0 = hn::Add(x, half), y0 = hn::Add(y, half), z0 = hn::Add(z, half);
    const Float x1 = hn::Sub(x, half), y1 = hn::Sub(y, half), z1 = hn::Sub(z, half);
    const Float tx = hn::Add(x, x), ty = hn::Add(y, y), tz = hn::Add(z, z);
    const Float fx = fade(tx), fy = fade(ty), fz = fade(tz);
    const auto& along_u = directions.along_u;
    const auto& along_v = directions.along_v;
    const Float ux = hn::Load(d, along_u[0] + j), vx = hn::Load(d, along_v[0] + j),
                uy = hn::Load(d, along_u[1] + j), vy = hn::Load(d, along_v[1] + j),
                uz = hn::Load(d, along_u[2] + j), vz = hn::Load(d, along_v[2] + j);
    const Bit next_x = hn::Set(Bits(), LatticeHash::prime_x);
    const Bit h00 = CellHash(seed, batch, j), h10 = hn::Add(h00, next_x);
    const Bit h01 = hn::Add(h00, hn::Set(Bits(), LatticeHash::prime_y));
    const Bit h11 = hn::Add(h01, next_x);

    // The four corners of a plane: interpolated, its differences along x and y, and the corners'
    // own changes, interpolated.
    const auto plane = [&](Bit hz, Float dz, Float& value, Float& dx, Float& dy, Float& du,
                           Float& dv) HWY_ATTR {
        const Bit ha = Mix(hn::Add(h00, hz)), hb = Mix(hn::Add(h10, hz));
        const Bit he = Mix(hn::Add(h01, hz)), hf = Mix(hn::Add(h11, hz));
        const Float a = corner(ha, x0, y0, dz), b = corner(hb, x1, y0, dz);
        const Float e = corner(he, x0, y1, dz), f = corner(hf, x1, y1, dz);
        const Float low = TwiceLerp(fx, a, b), high = TwiceLerp(fx, e, f);
        value = TwiceLerp(fy, low, high);
        dx = TwiceLerp(fy, hn::Sub(b, a), hn::Sub(f, e));
        dy = hn::Sub(high, low);
        du = dv = hn::Zero(d);
        if constexpr (CornerSlope<Corner>::any) {
            du = TwiceLerp(fy, TwiceLerp(fx, corner(ha, ux, uy, uz), corner(hb, ux, uy, uz)),
                           TwiceLerp(fx, corner(he, ux, uy, uz), corner(hf, ux, uy, uz)));
            dv = TwiceLerp(fy, TwiceLerp(fx, corner(ha, vx, vy, vz), corner(hb, vx, vy, vz)),
                           TwiceLerp(fx, corner(he, vx, vy, vz), corner(hf, vx, vy, vz)));
        }
    };
    Float low, low_x, low_y, low_u, low_v, high, high_x, high_y, high_u, high_v;
    plane(hn::Zero(Bits()), z0, low, low_x, low_y, low_u, low_v);
    plane(hn::Set(Bits(), LatticeHash::prime_z), z1, high, high_x, high_y, high_u, high_v);
    noise = TwiceLerp(fz, low, high);
    // d(fade)/d(place) is twice the slope, t being twice the place.
    const Float gx = hn::Mul(TwiceLerp(fz, low_x, high_x), hn::Add(fade.Slope(tx), fade.Slope(tx)));
    const Float gy = hn::Mul(TwiceLerp(fz, low_y, high_y), hn::Add(fade.Slope(ty), fade.Slope(ty)));
    const Float gz = hn::Mul(hn::Sub(high, low), hn::Add(fade.Slope(tz), fade.Slope(tz)));
    const auto along = [&](Float dx, Float dy, Float dz) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(gx, dx), hn::Mul(gy, dy)), hn::Mul(gz, dz));
    };
    slope_u = hn::Add(along(ux, uy, uz), TwiceLerp(fz, low_u, high_u));
    slope_v = hn::Add(along(vx, vy, vz), TwiceLerp(fz, low_v, high_v));
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddNoiseAndSlopesOf(std::uint32_t seed, double scale, const LatticeBatch& batch,
                                  const DirectionBatch& directions, std::size_t count, double* sums,
                                  SlopeBatch& slopes) {
    const Floats d;
    const Doubles doubles;
    HWY_ALIGN float noise[batch_capacity + batch_padding];
    const Bit seeds = hn::Set(Bits(), seed * LatticeHash::prime_seed);
    const Float slope_scale = hn::Set(d, float(scale));
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        Float n, u, v;
        NoiseAndSlopes<Corner, FadeFunction>(seeds, batch, directions, j, n, u, v);
        hn::Store(n, d, noise + j);
        const auto add = [&](Float slope, float* sum) HWY_ATTR {
            hn::Store(hn::Add(hn::Load(d, sum), hn::Mul(slope, slope_scale)), d, sum);
        };
        add(u, slopes.u + j);
        add(v, slopes.v + j);
    }
    const auto scales = hn::Set(doubles, scale);
    for (std::size_t j = 0; j < count; j += hn::Lanes(doubles)) {
        const auto n = hn::PromoteTo(doubles, hn::Load(HalfFloats(), noise + j));
        hn::StoreU(hn::Add(hn::LoadU(doubles, sums + j), hn::Mul(n, scales)), doubles, sums + j);
    }
}

HWY_ATTR void AddNoiseAndSlopes(NoiseKind kind, Fade fade, std::uint32_t seed, double scale,
                                const LatticeBatch& batch, const DirectionBatch& directions,
                                std::size_t count, double* sums, SlopeBatch& slopes) {
    with_noise(kind, fade, [&]<class Corner, class FadeFunction>() HWY_ATTR {
        AddNoiseAndSlopesOf<Corner, FadeFunction>(seed, scale * noise_unit(kind), batch, directions,
                                                  count, sums, slopes);
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(AddNoiseAndSlopes);

void add_noise_and_slopes(NoiseKind kind, Fade fade, std::uint32_t seed, double scale,
                          const LatticeBatch& batch, const DirectionBatch& directions,
                          std::size_t count, double* sums, SlopeBatch& slopes) {
    HWY_DYNAMIC_DISPATCH(AddNoiseAndSlopes)
    (kind, fade, seed, scale, batch, directions, count, sums, slopes);
}

}  // namespace burl
#endif
