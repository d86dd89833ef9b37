#include "procedural/graph/value_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "procedural/noise/bounds.h"

namespace burl {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ValueRange unknown{-infinity, infinity};

/// The range widened by the rounding of numbers computed a few steps from the bounds.
ValueRange widened(double low, double high) {
    if (!(std::isfinite(low) && std::isfinite(high))) return unknown;
    const double margin = 1e-12 * std::max(std::abs(low), std::abs(high));
    return {low - margin, high + margin};
}

ValueRange sum(const ValueRange& a, const ValueRange& b) {
    return widened(a.low + b.low, a.high + b.high);
}

ValueRange product(const ValueRange& a, const ValueRange& b) {
    if (!a.finite() || !b.finite()) return unknown;
    const auto [low, high] =
        std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return widened(low, high);
}

ValueRange times(double p, const ValueRange& a) {
    return product({p, p}, a);
}

double size(const ValueRange& a) {
    return std::max(std::abs(a.low), std::abs(a.high));
}

/// The range of a step that is 0 up to `low`, 1 from `high` on and in [0, 1] between.
ValueRange step_range(const ValueRange& a, double low, double high) {
    return {a.low >= high ? 1.0 : 0.0, a.high <= low && low < high ? 0.0 : 1.0};
}

ValueRange ratio(const ValueRange& a, const ValueRange& b) {
    if (!(b.low > 0.0)) return unknown;
    return product(a, widened(1.0 / b.high, 1.0 / b.low));
}

/// The range of a power of numbers in `a`, by the largest size of those.
ValueRange power(const ValueRange& a, double exponent) {
    if (!a.finite()) return unknown;
    const double most = 1.0 + std::pow(std::max(1.0, size(a)), exponent);
    return std::isfinite(most) ? ValueRange{-most, most} : unknown;
}

ValueRange range_of(const ValueOperation& work, std::span<const ValueRange> in) {
    const auto [p, q, r, s] = work.parameters;
    switch (work.op) {
        case ValueOp::constant:
            return std::isfinite(p) ? ValueRange{p, p} : unknown;
        case ValueOp::affine:
            return sum(sum(sum(times(p, in[0]), times(q, in[1])), times(r, in[2])), {s, s});
        case ValueOp::linear:
            return sum(times(p, in[0]), {q, q});
        case ValueOp::combine:
            return sum(sum(times(p, in[0]), times(q, in[1])), {r, r});
        case ValueOp::add:
            return sum(in[0], in[1]);
        case ValueOp::multiply:
            return product(in[0], in[1]);
        case ValueOp::products:
            return sum(product(in[0], in[1]), product(in[2], in[3]));
        case ValueOp::ratio:
            return ratio(in[0], in[1]);
        case ValueOp::minimum:
            return {std::min(in[0].low, in[1].low), std::min(in[0].high, in[1].high)};
        case ValueOp::maximum:
            return {std::max(in[0].low, in[1].low), std::max(in[0].high, in[1].high)};
        case ValueOp::absolute:
            return {in[0].low > 0.0    ? in[0].low
                    : in[0].high < 0.0 ? -in[0].high
                                       : 0.0,
                    size(in[0])};
        case ValueOp::floor:
            return {std::floor(in[0].low), std::floor(in[0].high)};
        case ValueOp::fract:
            return in[0].finite() ? ValueRange{0.0, 1.0} : unknown;
        case ValueOp::odd:
            return {0.0, 1.0};
        case ValueOp::at_least:
            return {in[0].low >= p ? 1.0 : 0.0, in[0].high < p ? 0.0 : 1.0};
        case ValueOp::smoothstep:
            return in[0].finite() ? step_range(in[0], p, q) : unknown;
        case ValueOp::lerp:
            return sum(product(sum({1.0, 1.0}, times(-1.0, in[0])), in[1]), product(in[0], in[2]));
        case ValueOp::length:
            return product({0.0, 1.5}, {0.0, std::max(size(in[0]), size(in[1]))});
        case ValueOp::power:
            return power(in[0], p);
        case ValueOp::sine:
            return in[0].finite() ? ValueRange{-1.001, 1.001} : unknown;
        case ValueOp::angle:
            return in[0].finite() && in[1].finite() ? ValueRange{-3.1416, 3.1416} : unknown;
    }
    return unknown;
}

/// The range of a sum of noise; unknown where the points may not be finite.
ValueRange range_of(const NoiseSum& work, std::span<const ValueRange> in) {
    if (!std::ranges::all_of(in, &ValueRange::finite)) return unknown;
    const NoiseBounds n = shaped(work.shape, noise_bounds(work.noise));
    ValueRange range{work.offset, work.offset};
    double sizes = 0.0;
    for (const SumOctave& octave : work.octaves) {
        const auto [low, high] = std::minmax({octave.weight * n.low, octave.weight * n.high});
        range.low += low, range.high += high;
        sizes += std::abs(octave.weight);
    }
    range.low -= 1e-5 * sizes, range.high += 1e-5 * sizes;
    return widened(range.low, range.high);
}

/// The range of all pieces for arguments in [0, 1].
ValueRange range_of(const ColorPieces& work) {
    double most = 0.0;
    for (std::size_t i = 0; i < work.begins.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            double bound = 0.0;
            for (std::size_t k = work.degree + 1; k-- > 0;)
                bound = std::abs(work.table[i * work.stride() + 1 + c * (work.degree + 1) + k]) +
                        // Pieces begin at -1 or later.
                        2.0 * bound;
            most = std::max(most, bound);
        }
    return widened(-most, most);
}

std::vector<ValueRange> ranges_of(const ValueStep& step, std::span<const ValueRange> in) {
    if (const auto* operation = std::get_if<ValueOperation>(&step.work))
        return {range_of(*operation, in)};
    if (const auto* noise = std::get_if<NoiseSum>(&step.work)) return {range_of(*noise, in)};
    if (const auto* pieces = std::get_if<ColorPieces>(&step.work))
        return std::vector(step.outputs.size(), range_of(*pieces));
    if (std::holds_alternative<DotsWeight>(step.work)) return {{0.0, 1.0}};
    return std::vector(step.outputs.size(), unknown);
}

}  // namespace

bool ValueRange::finite() const {
    return std::isfinite(low) && std::isfinite(high);
}

std::vector<ValueRange> value_ranges(std::span<const ValueStep> steps, std::size_t arrays,
                                     const std::array<ValueRange, 3>& points) {
    std::vector<ValueRange> ranges(std::max<std::size_t>(arrays, 3), unknown);
    std::ranges::copy(points, ranges.begin());
    for (const ValueStep& step : steps) {
        std::vector<ValueRange> inputs;
        for (const Register r : step.inputs) inputs.push_back(ranges[r]);
        const std::vector<ValueRange> results = ranges_of(step, inputs);
        for (std::size_t k = 0; k < step.outputs.size(); ++k) ranges[step.outputs[k]] = results[k];
    }
    return ranges;
}

}  // namespace burl
