#include "procedural/color/map_filter_kernels.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/color/map_filter_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

HWY_ATTR HWY_INLINE Double Number(double x) {
    return hn::Set(Doubles(), x);
}

/// A break's shares in the mean: the mean gets `jump` times its jump plus `kink` times its kink.
struct Shares {
    Double jump, kink;
};

// A basis gives, at x, the antiderivatives of a unit jump and of a unit kink at the break
// `position`, up to terms that the filters' differences cancel: First is the first antiderivative,
// Second the second.

/// The basis of periodic maps, of zero mean: -B_k(u) / k!, where B_k is Bernoulli's polynomial
/// without its constant and u in [0, 1) the distance from the break, here y + 1/2.
struct PeriodicBasis {
    Double middle;
    HWY_ATTR explicit PeriodicBasis(double position) : middle(Number(position + 0.5)) {}
    HWY_ATTR HWY_INLINE Double Distance(Double x) const {
        const Double z = hn::Sub(x, middle);
        return hn::Sub(z, hn::Sub(hn::Add(z, Number(round_magic)), Number(round_magic)));
    }
    template <bool jumps, bool kinks>
    HWY_ATTR HWY_INLINE Shares First(Double x) const {
        const Double y = Distance(x), square = hn::Mul(y, y);
        return {jumps ? hn::Mul(square, Number(-0.5)) : hn::Zero(Doubles()),
                kinks ? Cubic(y, square) : hn::Zero(Doubles())};
    }
    template <bool jumps, bool kinks>
    HWY_ATTR HWY_INLINE Shares Second(Double x) const {
        const Double y = Distance(x), square = hn::Mul(y, y);
        const Double quartic = hn::Sub(Number(1.0 / 48.0), hn::Mul(square, Number(1.0 / 24.0)));
        return {jumps ? Cubic(y, square) : hn::Zero(Doubles()),
                kinks ? hn::Mul(square, quartic) : hn::Zero(Doubles())};
    }
    /// The unit jump and the unit kink themselves.
    HWY_ATTR HWY_INLINE Shares Value(Double x) const {
        const Double y = Distance(x), square = hn::Mul(y, y);
        return {hn::Neg(y), hn::Sub(Number(1.0 / 24.0), hn::Mul(square, Number(0.5)))};
    }
    /// The distance to the nearest break, negative where x lies to its left.
    HWY_ATTR HWY_INLINE Double Side(Double x) const {
        const Double y = Distance(x);
        return hn::CopySign(hn::Sub(Number(0.5), hn::Abs(y)), hn::Neg(y));
    }

  private:
    static HWY_ATTR HWY_INLINE Double Cubic(Double y, Double square) {
        return hn::Mul(y, hn::Sub(Number(1.0 / 24.0), hn::Mul(square, Number(1.0 / 6.0))));
    }
};

/// The basis of clamped maps: powers of x - position, or 0 to the left of the break. Beyond x = 1,
/// where all kinks of a map cancel, those of the kink go on without the highest power.
struct ClampedBasis {
    Double position;
    HWY_ATTR explicit ClampedBasis(double at) : position(Number(at)) {}
    HWY_ATTR HWY_INLINE Double Beyond(Double x) const {
        return hn::Max(hn::Sub(x, position), hn::Zero(Doubles()));
    }
    HWY_ATTR HWY_INLINE Double Within(Double x) const { return Beyond(hn::Min(x, Number(1.0))); }
    HWY_ATTR HWY_INLINE Double Rest(Double x) const {
        return hn::Max(hn::Sub(x, Number(1.0)), hn::Zero(Doubles()));
    }
    template <bool jumps, bool kinks>
    HWY_ATTR HWY_INLINE Shares First(Double x) const {
        const Double r = Within(x);
        return {Beyond(x), hn::Mul(r, hn::Add(hn::Mul(r, Number(0.5)), Rest(x)))};
    }
    template <bool jumps, bool kinks>
    HWY_ATTR HWY_INLINE Shares Second(Double x) const {
        const Double all = Beyond(x), r = Within(x), rest = Rest(x), half = Number(0.5);
        const Double square =
            hn::Mul(hn::Mul(r, r), hn::Add(hn::Mul(r, Number(1.0 / 6.0)), hn::Mul(rest, half)));
        return {hn::Mul(hn::Mul(all, all), half),
                hn::Add(square, hn::Mul(r, hn::Mul(hn::Mul(rest, rest), half)))};
    }
    HWY_ATTR HWY_INLINE Shares Value(Double x) const {
        const auto right = hn::Ge(x, position);
        return {hn::IfThenElseZero(right, Number(1.0)), Within(x)};
    }
    HWY_ATTR HWY_INLINE Double Side(Double x) const { return hn::Sub(x, position); }
};

// A shape gives a break's shares in the mean over a footprint.

/// A vector of footprints: the numbers that do not depend on the break.
struct Footprints {
    Double f, wide, narrow;
};

HWY_ATTR HWY_INLINE Shares Minus(const Shares& a, const Shares& b) {
    return {hn::Sub(a.jump, b.jump), hn::Sub(a.kink, b.kink)};
}

/// Footprints of one axis: differences of first antiderivatives over the width.
struct BoxShape {
    Double low, high, scale;
    HWY_ATTR explicit BoxShape(const Footprints& at) {
        const Double half = hn::Mul(at.wide, Number(0.5));
        low = hn::Sub(at.f, half);
        high = hn::Add(at.f, half);
        scale = hn::Div(Number(1.0), at.wide);
    }
    template <bool jumps, bool kinks, class Basis>
    HWY_ATTR HWY_INLINE Shares Of(const Basis& basis) const {
        return Minus(basis.template First<jumps, kinks>(high),
                     basis.template First<jumps, kinks>(low));
    }
};

/// Footprints of two axes: second differences of second antiderivatives over both widths.
struct TrapezoidShape {
    Double outer_low, outer_high, inner_low, inner_high, scale;
    HWY_ATTR explicit TrapezoidShape(const Footprints& at) {
        const Double half = Number(0.5);
        const Double sum = hn::Mul(hn::Add(at.wide, at.narrow), half);
        const Double difference = hn::Mul(hn::Sub(at.wide, at.narrow), half);
        outer_low = hn::Sub(at.f, sum);
        outer_high = hn::Add(at.f, sum);
        inner_low = hn::Sub(at.f, difference);
        inner_high = hn::Add(at.f, difference);
        scale = hn::Div(Number(1.0), hn::Mul(at.wide, at.narrow));
    }
    template <bool jumps, bool kinks, class Basis>
    HWY_ATTR HWY_INLINE Shares Of(const Basis& basis) const {
        const Shares high = Minus(basis.template Second<jumps, kinks>(outer_high),
                                  basis.template Second<jumps, kinks>(inner_high));
        const Shares low = Minus(basis.template Second<jumps, kinks>(inner_low),
                                 basis.template Second<jumps, kinks>(outer_low));
        return Minus(high, low);
    }
};

/// The map at f, plus the correction of every break inside the footprint: the smoothed step and
/// ramp (map_filter.cpp) less the sharp ones, both even in the distance but for the step's sign.
struct NarrowShape {
    Double f, half, flat, wide, slant, top, scale;
    HWY_ATTR explicit NarrowShape(const Footprints& at) {
        const Double one = Number(1.0), two = Number(2.0);
        f = at.f;
        half = hn::Mul(hn::Add(at.wide, at.narrow), Number(0.5));
        flat = hn::Mul(hn::Sub(at.wide, at.narrow), Number(0.5));
        wide = hn::Div(one, at.wide);
        slant = hn::Div(one, hn::Mul(two, hn::Mul(at.wide, at.narrow)));
        const Double ratio = hn::Mul(at.narrow, hn::Mul(at.narrow, wide));
        top = hn::Mul(hn::Add(at.wide, hn::Div(ratio, Number(3.0))), Number(0.125));
        scale = one;
    }
    template <bool jumps, bool kinks, class Basis>
    HWY_ATTR HWY_INLINE Shares Of(const Basis& basis) const {
        const Double side = basis.Side(f), away = hn::Abs(side), reach = hn::Sub(half, away);
        const Double outer = hn::Mul(hn::Mul(reach, reach), slant);
        const Double inner = hn::Sub(Number(0.5), hn::Mul(away, wide));
        const Double outer_ramp = hn::Mul(hn::Mul(outer, reach), Number(1.0 / 3.0));
        const Double middle = hn::Sub(Number(0.5), hn::Mul(hn::Mul(away, wide), Number(0.5)));
        const Double inner_ramp = hn::Sub(top, hn::Mul(away, middle));
        const auto sloping = hn::Ge(away, flat), inside = hn::Gt(reach, hn::Zero(Doubles()));
        const Double step = hn::IfThenElse(sloping, outer, inner);
        const Double ramp = hn::IfThenElse(sloping, outer_ramp, inner_ramp);
        const Shares sharp = basis.Value(f);
        return {hn::Sub(sharp.jump, hn::IfThenElseZero(inside, hn::CopySign(step, side))),
                hn::Add(sharp.kink, hn::IfThenElseZero(inside, ramp))};
    }
};

struct Sums {
    Double red, green, blue;
};

HWY_ATTR HWY_INLINE void AddShare(Double share, const Vec3d& color, Sums& sums) {
    sums.red = hn::Add(sums.red, hn::Mul(share, Number(color.x)));
    sums.green = hn::Add(sums.green, hn::Mul(share, Number(color.y)));
    sums.blue = hn::Add(sums.blue, hn::Mul(share, Number(color.z)));
}

template <class Basis, class Shape>
HWY_ATTR HWY_INLINE void AddBreak(const MapBreak& at, const Shape& shape, Sums& sums) {
    const Basis basis(at.position);
    const bool jumps = at.jump != Vec3d(0.0), kinks = at.kink != Vec3d(0.0);
    if (jumps && kinks) {
        const Shares both = shape.template Of<true, true>(basis);
        AddShare(both.jump, at.jump, sums);
        AddShare(both.kink, at.kink, sums);
    } else if (jumps) {
        AddShare(shape.template Of<true, false>(basis).jump, at.jump, sums);
    } else {
        AddShare(shape.template Of<false, true>(basis).kink, at.kink, sums);
    }
}

template <class Basis, class Shape>
HWY_ATTR void Filter(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    const Doubles d;
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const Shape shape(Footprints{hn::Load(d, stream.f + j), hn::Load(d, stream.wide + j),
                                     hn::Load(d, stream.narrow + j)});
        Sums sums{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        for (const MapBreak& at : map.breaks) AddBreak<Basis>(at, shape, sums);
        hn::Store(hn::Add(Number(map.base.x), hn::Mul(sums.red, shape.scale)), d,
                  stream.color[0] + j);
        hn::Store(hn::Add(Number(map.base.y), hn::Mul(sums.green, shape.scale)), d,
                  stream.color[1] + j);
        hn::Store(hn::Add(Number(map.base.z), hn::Mul(sums.blue, shape.scale)), d,
                  stream.color[2] + j);
    }
}

template <class Shape>
HWY_ATTR void FilterByWrap(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    if (map.wrap == Wrap::repeat)
        Filter<PeriodicBasis, Shape>(map, stream, count);
    else
        Filter<ClampedBasis, Shape>(map, stream, count);
}

HWY_ATTR void FilterNarrow(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    FilterByWrap<NarrowShape>(map, stream, count);
}

HWY_ATTR void FilterBoxes(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    FilterByWrap<BoxShape>(map, stream, count);
}

HWY_ATTR void FilterTrapezoids(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    FilterByWrap<TrapezoidShape>(map, stream, count);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FilterNarrow);
HWY_EXPORT(FilterBoxes);
HWY_EXPORT(FilterTrapezoids);

MapBreaks::MapBreaks(const MapPieces& map)
    : wrap(map.wrap()),
      base(map.wrap() == Wrap::repeat ? map.mean() : map.extended(-1.0, -1.0)),
      breaks(map.breaks()) {}

void filter_narrow(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(FilterNarrow)(map, stream, count);
}

void filter_boxes(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(FilterBoxes)(map, stream, count);
}

void filter_trapezoids(const MapBreaks& map, FootprintStream& stream, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(FilterTrapezoids)(map, stream, count);
}

}  // namespace burl
#endif
