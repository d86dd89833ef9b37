// The nodes of the regular patterns of Chuang's slides on pbrt's textures (2008): all are
// discontinuous functions of smooth ones, so their means over a sample follow from the gradient
// (box_means.h).
#include <bit>
#include <numbers>
#include <optional>

#include "procedural/batch/sample_pattern.h"
#include "procedural/color/map_filter.h"
#include "procedural/graph/box_means.h"
#include "procedural/graph/nodes.h"

namespace burl::nodes {

namespace {

// The strata along a side, as in pbrt.
constexpr int strata = 4;

enum class Antialiasing { none, closed_form, supersample, trapezoid };

/// A random number in [0, 1) from a point and a stratum of the sample: the same in every run and
/// thread.
double jitter(const DualPoint& p, std::uint32_t stratum) {
    std::uint32_t h = 0x9e3779b1u * (stratum + 1);
    for (const Dual* x : {&p.x, &p.y, &p.z}) {
        // Adding 0 makes -0 equal to 0.
        const auto bits = std::bit_cast<std::uint64_t>(x->value + 0.0);
        for (const std::uint32_t half : {std::uint32_t(bits), std::uint32_t(bits >> 32)}) {
            h = (h ^ half) * 0x7feb352du;
            h ^= h >> 15;
        }
    }
    h *= 0x846ca68bu;
    return 0x1p-32 * (h ^ (h >> 16));
}

/// A checkerboard in the first N coordinates of the point: the weight of input 1.
template <std::size_t N>
class Checkers {
  public:
    explicit Checkers(const NodeCall& call)
        : call_(call), antialiasing_(Antialiasing(int(call.parameter("aa")))) {
        if (antialiasing_ == Antialiasing::trapezoid) stripes_.emplace(two_stripes());
    }

    Dual operator()(std::size_t i) const {
        const DualPoint point = call_.point(i);
        const std::array<Dual, 3> p{point.x, point.y, point.z};
        if (antialiasing_ == Antialiasing::closed_form) return closed_form(p, i);
        if (antialiasing_ == Antialiasing::trapezoid) return trapezoid(p, i);
        if (antialiasing_ == Antialiasing::supersample) return supersample(point, p, i);
        return odd({p[0].value, p[1].value, p[2].value});
    }

  private:
    static double odd(const std::array<double, 3>& p) {
        double sign = 1.0;
        for (std::size_t axis = 0; axis < N; ++axis) sign *= 1.0 - 2.0 * odd_cell(p[axis]);
        return 0.5 - 0.5 * sign;
    }

    /// The weight by the product of the axes' mean stripes (1 in even cells, -1 in odd ones), each
    /// over a box whose half width is the longer of the axis' two steps, as in pbrt.
    Dual closed_form(const std::array<Dual, 3>& p, std::size_t i) const {
        Dual sign = 1.0;
        for (std::size_t axis = 0; axis < N; ++axis) {
            const double half =
                std::max(std::abs(call_.along_u(p[axis], i)), std::abs(call_.along_v(p[axis], i)));
            if (!(half <= 1.0)) return 0.5;
            sign = sign * (1.0 - 2.0 * box_odd(p[axis], 2.0 * half));
        }
        return 0.5 - 0.5 * sign;
    }

    /// An even and an odd cell as a colour map with period 1 in half the coordinate.
    static ColorMap two_stripes() {
        const Rgb8 black{0, 0, 0}, white{255, 255, 255};
        return {Wrap::repeat, {{0.0, black}, {0.5, black}, {0.5, white}, {1.0, white}}};
    }

    /// The weight by the product of the axes' mean stripes (1 in even cells, -1 in odd ones), each
    /// averaged exactly over both of the axis' moves across the sample. It is right where the
    /// sample holds edges of one axis only, and where each of the sample's sides moves along one
    /// axis.
    Dual trapezoid(const std::array<Dual, 3>& p, std::size_t i) const {
        Dual sign = 1.0;
        for (std::size_t axis = 0; axis < N; ++axis) {
            const Dual half = 0.5 * p[axis];
            const auto widths = FilterWidths::of(call_.along_u(half, i), call_.along_v(half, i));
            const Dual box = box_odd(p[axis], 2.0 * (widths.wide + widths.narrow));
            const bool edge = box.value > 0.0 && box.value < 1.0;
            const double share =
                edge ? trapezoid_filtered(*stripes_, half.value, widths).x : box.value;
            sign = sign * (1.0 - 2.0 * Dual(share, box.slope));
        }
        return 0.5 - 0.5 * sign;
    }

    double supersample(const DualPoint& point, const std::array<Dual, 3>& p, std::size_t i) const {
        double sum = 0.0, weights = 0.0;
        for (std::uint32_t stratum = 0; stratum < strata * strata; ++stratum) {
            const double du = (stratum % strata + jitter(point, 2 * stratum)) / strata - 0.5;
            const double dv = (stratum / strata + jitter(point, 2 * stratum + 1)) / strata - 0.5;
            std::array<double, 3> q{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                q[axis] =
                    p[axis].value + du * call_.along_u(p[axis], i) + dv * call_.along_v(p[axis], i);
            const double weight = gaussian_weight(du, dv);
            sum += weight * odd(q);
            weights += weight;
        }
        return sum / weights;
    }

    const NodeCall& call_;
    Antialiasing antialiasing_;
    std::optional<MapPieces> stripes_;
};

/// The coordinate along `direction`, in periods.
class Along {
  public:
    explicit Along(const NodeCall& call)
        : call_(call), direction_(call.vector("direction") / call.parameter("period")) {}
    Dual operator()(std::size_t i) const {
        const DualPoint p = call_.point(i);
        return direction_.x * p.x + direction_.y * p.y + direction_.z * p.z;
    }

  private:
    const NodeCall& call_;
    Vec3d direction_;
};

}  // namespace

void uv(const NodeCall& call) {
    for_each_channel(call, [&](std::size_t i, std::size_t c) -> Dual {
        if (c >= 2) return c == 3 ? 1.0 : 0.0;
        const Dual x = call.place[c].get(i);
        return box_fract(x, call.box_width(x, i));
    });
}

void checkerboard(const NodeCall& call) {
    blend_inputs(call, Checkers<2>(call));
}

void checkerboard_3d(const NodeCall& call) {
    blend_inputs(call, Checkers<3>(call));
}

void stripes(const NodeCall& call) {
    const Along along(call);
    blend_inputs(call, [&](std::size_t i) {
        const Dual x = along(i);
        return box_odd(x, call.box_width(x, i));
    });
}

void ramp(const NodeCall& call) {
    const Along along(call);
    blend_inputs(call, [&](std::size_t i) {
        const Dual x = along(i);
        return box_fract(x, call.box_width(x, i));
    });
}

void sine(const NodeCall& call) {
    const Along along(call);
    blend_inputs(call, [&](std::size_t i) {
        const Dual x = 2.0 * std::numbers::pi * along(i);
        return 0.5 + 0.5 * box_sin(x, call.box_width(x, i));
    });
}

void rings(const NodeCall& call) {
    const double spacing = call.parameter("spacing");
    blend_inputs(call, [&](std::size_t i) {
        const DualPoint p = call.point(i);
        const Dual x = 1.0 / spacing * dual_length(p.x, p.y);
        return box_odd(x, call.box_width(x, i));
    });
}

void wood_grain(const NodeCall& call) {
    const double spacing = call.parameter("spacing"), wobble = call.parameter("wobble"),
                 turns = call.parameter("wobbles"), twist = call.parameter("twist");
    const bool ramped = call.parameter("profile") == 1.0;
    blend_inputs(call, [&](std::size_t i) {
        const DualPoint p = call.point(i);
        const Dual angle = turns * dual_angle(p.y, p.x) + twist * p.z;
        const Dual x = 1.0 / spacing * dual_length(p.x, p.y) + wobble * dual_sin(angle);
        const double width = call.box_width(x, i);
        return ramped ? box_fract(x, width) : box_odd(x, width);
    });
}

}  // namespace burl::nodes
