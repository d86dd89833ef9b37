#include "procedural/kernels/quadric_kernel.h"

#include <algorithm>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/quadric_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/piece_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

HWY_ATTR void MakeParabolas(const Quadric& q, double constant, std::span<const Piece> pieces,
                            std::span<ParabolaLine> parabolas) {
    const Doubles d;
    constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
    HWY_ALIGN double c0[most], c1[most], c2[most];
    for (std::size_t i = 0; i < pieces.size(); i += hn::Lanes(d)) {
        const PieceLanes p(pieces, i);
        // The rows of Q s without the last one, eq. (11), their linear part apart.
        const auto hx = Dot(q.a, q.b, q.c, p.x, p.y, p.z), hy = Dot(q.b, q.e, q.f, p.x, p.y, p.z),
                   hz = Dot(q.c, q.f, q.h, p.x, p.y, p.z);
        const auto lx = hn::Set(d, q.d), ly = hn::Set(d, q.g), lz = hn::Set(d, q.i);
        const auto two = hn::Set(d, 2.0);
        const auto value = Dot(hn::Add(hx, hn::Mul(two, lx)), hn::Add(hy, hn::Mul(two, ly)),
                               hn::Add(hz, hn::Mul(two, lz)), p.x, p.y, p.z);
        const auto slope = Dot(hn::Add(hx, lx), hn::Add(hy, ly), hn::Add(hz, lz), p.u, p.v, p.w);
        const auto turn = Dot(Dot(q.a, q.b, q.c, p.u, p.v, p.w), Dot(q.b, q.e, q.f, p.u, p.v, p.w),
                              Dot(q.c, q.f, q.h, p.u, p.v, p.w), p.u, p.v, p.w);
        hn::Store(hn::Add(value, hn::Set(d, q.j + constant)), d, c0);
        hn::Store(hn::Mul(two, slope), d, c1);
        hn::Store(turn, d, c2);
        const std::size_t end = std::min(hn::Lanes(d), pieces.size() - i);
        for (std::size_t k = 0; k < end; ++k)
            parabolas[i + k] = {c0[k], c1[k], c2[k], pieces[i + k].solid.first,
                                pieces[i + k].solid.count};
    }
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

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(MakeParabolas);
HWY_EXPORT(FillParabolas);

void make_parabolas(const Quadric& quadric, double constant, std::span<const Piece> pieces,
                    std::span<ParabolaLine> parabolas) {
    HWY_DYNAMIC_DISPATCH(MakeParabolas)(quadric, constant, pieces, parabolas);
}

void fill_parabolas(std::span<const ParabolaLine> lines, double* values) {
    HWY_DYNAMIC_DISPATCH(FillParabolas)(lines, values);
}

}  // namespace burl
#endif
