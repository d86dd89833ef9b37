#include "procedural/noise_kernels.h"

#include <iterator>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/noise_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/noise_corners-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

HWY_ATTR void SplitLine(const LatticeLine& line, int axis, std::size_t at, LatticeBatch& batch) {
    const Doubles d;
    const auto magic = hn::Set(d, round_magic);
    const auto start = hn::Set(d, line.start[axis] - 0.5), step = hn::Set(d, line.step[axis]);
    const auto lanes = hn::Set(d, double(hn::Lanes(d)));
    auto index = hn::Add(LaneNumbers(), hn::Set(d, line.first));
    for (std::size_t j = 0; j < line.count; j += hn::Lanes(d)) {
        // The nearest integer to x - 1/2 is floor(x), up to ties, where both cells agree.
        const auto y = hn::Add(start, hn::Mul(index, step));
        const auto shifted = hn::Add(y, magic);
        const auto place = hn::Sub(y, hn::Sub(shifted, magic));
        const auto cell =
            hn::TruncateTo(HalfBits(), hn::BitCast(hn::RebindToUnsigned<Doubles>(), shifted));
        hn::StoreU(hn::BitCast(HalfInts(), cell), HalfInts(), batch.cells[axis] + at + j);
        hn::StoreU(hn::DemoteTo(HalfFloats(), place), HalfFloats(), batch.places[axis] + at + j);
        index = hn::Add(index, lanes);
    }
}

HWY_ATTR void SplitLatticeLines(std::span<const LatticeLine> lines, LatticeBatch& batch) {
    std::size_t at = 0;
    for (const LatticeLine& line : lines) {
        for (int axis = 0; axis < 3; ++axis) SplitLine(line, axis, at, batch);
        at += line.count;
    }
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddNoiseOf(std::uint32_t seed, double scale, const LatticeBatch& batch,
                         std::size_t count, double* sums) {
    const Floats d;
    const Doubles doubles;
    HWY_ALIGN float noise[batch_capacity + batch_padding];
    const Bit seeds = hn::Set(Bits(), seed * LatticeHash::prime_seed);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d))
        hn::Store(EightfoldNoise<Corner, FadeFunction>(
                      CellHash(seeds, batch, j), hn::Load(d, batch.places[0] + j),
                      hn::Load(d, batch.places[1] + j), hn::Load(d, batch.places[2] + j)),
                  d, noise + j);
    const auto scales = hn::Set(doubles, scale);
    for (std::size_t j = 0; j < count; j += hn::Lanes(doubles)) {
        const auto n = hn::PromoteTo(doubles, hn::Load(HalfFloats(), noise + j));
        hn::StoreU(hn::Add(hn::LoadU(doubles, sums + j), hn::Mul(n, scales)), doubles, sums + j);
    }
}

HWY_ATTR void AddNoise(NoiseKind kind, Fade fade, std::uint32_t seed, double scale,
                       const LatticeBatch& batch, std::size_t count, double* sums) {
    with_noise(kind, fade, [&]<class Corner, class FadeFunction>() HWY_ATTR {
        AddNoiseOf<Corner, FadeFunction>(seed, scale * noise_unit(kind), batch, count, sums);
    });
}

HWY_ATTR void FillParabolas(std::span<const ParabolaLine> lines, double* values) {
    const Doubles d;
    const auto lanes = hn::Set(d, double(hn::Lanes(d)));
    for (const ParabolaLine& line : lines) {
        const auto c0 = hn::Set(d, line.c0), c1 = hn::Set(d, line.c1), c2 = hn::Set(d, line.c2);
        auto x = hn::Add(LaneNumbers(), hn::Set(d, line.first));
        for (std::size_t j = 0; j < line.count; j += hn::Lanes(d)) {
            const auto slope = hn::Add(c1, hn::Mul(x, c2));
            hn::StoreU(hn::Add(c0, hn::Mul(x, slope)), d, values + j);
            x = hn::Add(x, lanes);
        }
        values += line.count;
    }
}

const char* SimdLevel() {
    return hwy::TargetName(HWY_TARGET);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(SplitLatticeLines);
HWY_EXPORT(AddNoise);
HWY_EXPORT(FillParabolas);
HWY_EXPORT(SimdLevel);

void split_lattice_lines(std::span<const LatticeLine> lines, LatticeBatch& batch) {
    HWY_DYNAMIC_DISPATCH(SplitLatticeLines)(lines, batch);
}

void add_noise(NoiseKind kind, Fade fade, std::uint32_t seed, double scale,
               const LatticeBatch& batch, std::size_t count, double* sums) {
    HWY_DYNAMIC_DISPATCH(AddNoise)(kind, fade, seed, scale, batch, count, sums);
}

void fill_parabolas(std::span<const ParabolaLine> lines, double* values) {
    HWY_DYNAMIC_DISPATCH(FillParabolas)(lines, values);
}

std::string simd_level() {
    return HWY_DYNAMIC_DISPATCH(SimdLevel)();
}

}  // namespace burl
#endif
