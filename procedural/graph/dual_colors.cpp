// The steps of checkerboards and colours with gradients.
#include <bit>
#include <optional>

#include "procedural/batch/sample_pattern.h"
#include "procedural/color/filtered_colors.h"
#include "procedural/color/marble_spline.h"
#include "procedural/graph/box_means.h"
#include "procedural/graph/duals.h"

namespace burl {

namespace {

/// The number of strata along each side of a footprint, as in pbrt.
constexpr int strata = 4;

/// A pseudorandom number in [0, 1), a hash of a point and a stratum of its footprint.
double jitter(const DualPoint& p, std::uint32_t stratum) {
    std::uint32_t h = 0x9e3779b1u * (stratum + 1);
    for (const Dual* x : {&p.x, &p.y, &p.z}) {
        const auto bits = std::bit_cast<std::uint64_t>(x->value + 0.0);  // -0 is 0
        for (const std::uint32_t half : {std::uint32_t(bits), std::uint32_t(bits >> 32)}) {
            h = (h ^ half) * 0x7feb352du;
            h ^= h >> 15;
        }
    }
    h *= 0x846ca68bu;
    return 0x1p-32 * (h ^ (h >> 16));
}

/// The colour map of an even and an odd cell over half the coordinate.
ColorMap two_stripes() {
    const Rgb8 black{0, 0, 0}, white{255, 255, 255};
    return {Wrap::repeat, {{0.0, black}, {0.5, black}, {0.5, white}, {1.0, white}}};
}

/// The function of a checkerboard.
class Checkers {
  public:
    explicit Checkers(const Checkerboard& board) : board_(board) {
        if (board.antialiasing == Antialiasing::trapezoid) stripes_.emplace(two_stripes());
    }

    Dual operator()(const DualCall& call, std::size_t i) const {
        const DualPoint point = call.point(i);
        const std::array<Dual, 3> p{point.x, point.y, point.z};
        switch (board_.antialiasing) {
            case Antialiasing::closed_form:
                return closed_form(call, p, i);
            case Antialiasing::trapezoid:
                return trapezoid(call, p, i);
            case Antialiasing::supersample:
                return supersample(call, point, p, i);
            case Antialiasing::none:
                break;
        }
        return odd({p[0].value, p[1].value, p[2].value});
    }

  private:
    double odd(const std::array<double, 3>& p) const {
        double sign = 1.0;
        for (std::size_t axis = 0; axis < board_.axes; ++axis)
            sign *= 1.0 - 2.0 * odd_cell(p[axis]);
        return 0.5 - 0.5 * sign;
    }

    /// The mean from the product, over the axes, of black minus white in a box. The box's half
    /// width is the longer of the two steps, as in pbrt.
    Dual closed_form(const DualCall& call, const std::array<Dual, 3>& p, std::size_t i) const {
        Dual sign = 1.0;
        for (std::size_t axis = 0; axis < board_.axes; ++axis) {
            const double half =
                std::max(std::abs(call.along_u(p[axis], i)), std::abs(call.along_v(p[axis], i)));
            if (!(half <= 1.0)) return 0.5;
            sign = sign * (1.0 - 2.0 * box_odd(p[axis], 2.0 * half));
        }
        return 0.5 - 0.5 * sign;
    }

    /// The mean from the product, over the axes, of black minus white averaged over both steps of
    /// the footprint: exact where the footprint holds edges of one axis only, and where each of its
    /// sides is parallel to an axis.
    Dual trapezoid(const DualCall& call, const std::array<Dual, 3>& p, std::size_t i) const {
        Dual sign = 1.0;
        for (std::size_t axis = 0; axis < board_.axes; ++axis) {
            const Dual half = 0.5 * p[axis];
            const auto widths = FilterWidths::of(call.along_u(half, i), call.along_v(half, i));
            const Dual box = box_odd(p[axis], 2.0 * (widths.wide + widths.narrow));
            const bool edge = box.value > 0.0 && box.value < 1.0;
            const double share =
                edge ? trapezoid_filtered(*stripes_, half.value, widths).x : box.value;
            sign = sign * (1.0 - 2.0 * Dual(share, box.slope));
        }
        return 0.5 - 0.5 * sign;
    }

    double supersample(const DualCall& call, const DualPoint& point, const std::array<Dual, 3>& p,
                       std::size_t i) const {
        double sum = 0.0, weights = 0.0;
        for (std::uint32_t stratum = 0; stratum < strata * strata; ++stratum) {
            const double du = (stratum % strata + jitter(point, 2 * stratum)) / strata - 0.5;
            const double dv = (stratum / strata + jitter(point, 2 * stratum + 1)) / strata - 0.5;
            std::array<double, 3> q{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                q[axis] =
                    p[axis].value + du * call.along_u(p[axis], i) + dv * call.along_v(p[axis], i);
            const double weight = gaussian_weight(du, dv);
            sum += weight * odd(q);
            weights += weight;
        }
        return sum / weights;
    }

    Checkerboard board_;
    std::optional<MapPieces> stripes_;
};

/// The function of a colour map's mean over footprints.
class MeanColors {
  public:
    MeanColors(const ColorMap& colors, FilterKind kind) : map_(colors), mean_(colors, kind) {}

    void operator()(const DualCall& call) const {
        for (std::size_t i = 0; i < call.count(); ++i) {
            const Dual f = call.in(0, i);
            const double u = call.along_u(f, i), v = call.along_v(f, i);
            const double x = std::isfinite(f.value) ? f.value : 0.0;
            const Vec3d color = mean_(x, u, v), slope = derivative(x, length_of(u, v));
            for (int c = 0; c < 3; ++c)
                call.outputs[std::size_t(c)]->set(i, chain(f, color[c], slope[c]));
        }
    }

  private:
    Vec3d derivative(double x, double width) const {
        if (!(width > 1e-6)) return map_.extended(x, x + 1.0) - map_.extended(x, x);
        const double low = x - 0.5 * width, high = x + 0.5 * width;
        return (map_.extended(high, high) - map_.extended(low, low)) / width;
    }

    MapPieces map_;
    FilteredColors mean_;
};

/// The weights of four neighbouring control points at u in [0, 1]: Bernstein's (pbrt, which jumps
/// from one four to the next) or those of the uniform cubic B-spline (which does not).
std::array<Dual, 4> spline_weights(bool smooth, const Dual& u) {
    const Dual v = 1.0 - u;
    if (!smooth) return {v * v * v, 3.0 * u * v * v, 3.0 * u * u * v, u * u * u};
    const Dual a = v * v * v, d = u * u * u;
    const Dual b = 4.0 - 6.0 * u * u + 3.0 * d, c = 4.0 - 6.0 * v * v + 3.0 * a;
    return {1.0 / 6.0 * a, 1.0 / 6.0 * b, 1.0 / 6.0 * c, 1.0 / 6.0 * d};
}

std::array<Dual, 3> marble_color(bool smooth, const Dual& t) {
    constexpr double segments = double(marble_segments);
    const double first = std::clamp(std::floor(t.value * segments), 0.0, segments - 1.0);
    const auto weights = spline_weights(smooth, segments * t - first);
    std::array<Dual, 3> color;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < 4; ++k)
            color[c] = color[c] +
                       marble_brightness * marble_colors[std::size_t(first) + k][c] * weights[k];
    return color;
}

ImageSample image_sample(const ImageColors& image, const DualCall& call, const Dual& s,
                         const Dual& t, std::size_t i) {
    const Vec2d u(call.along_u(s, i), call.along_u(t, i)),
        v(call.along_v(s, i), call.along_v(t, i));
    if (image.ewa) return image.pixels->ewa(s.value, t.value, u, v, image.anisotropy);
    const double widest = std::max({std::abs(u.x), std::abs(u.y), std::abs(v.x), std::abs(v.y)});
    return image.pixels->trilinear(s.value, t.value, 2.0 * widest);
}

}  // namespace

DualFunction dual_function(const Checkerboard& work, const DualSettings&) {
    return for_each_point(Checkers(work));
}

DualFunction dual_function(const MapColors& work, const DualSettings& settings) {
    return MeanColors(work.map(), settings.filter.kind);
}

DualFunction dual_function(const MarbleColors& work, const DualSettings&) {
    return [smooth = work.smooth](const DualCall& call) {
        for (std::size_t i = 0; i < call.count(); ++i) {
            const auto color = marble_color(smooth, call.in(0, i));
            for (std::size_t c = 0; c < 3; ++c) call.outputs[c]->set(i, color[c]);
        }
    };
}

DualFunction dual_function(const ImageColors& work, const DualSettings&) {
    return [work](const DualCall& call) {
        for (std::size_t i = 0; i < call.count(); ++i) {
            const Dual s = call.in(0, i), t = call.in(1, i);
            const ImageSample sample = image_sample(work, call, s, t, i);
            for (int c = 0; c < 3; ++c)
                call.outputs[std::size_t(c)]->set(
                    i, {sample.color[c], sample.by_s[c] * s.slope + sample.by_t[c] * t.slope});
        }
    };
}

}  // namespace burl
