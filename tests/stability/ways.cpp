#include "tests/stability/ways.h"

#include <algorithm>
#include <cmath>

#include "procedural/bresenham/field.h"
#include "procedural/fill/forward.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fill/texels.h"

namespace burl {

namespace {

template <class Number>
std::vector<double> of_spans(const SolidAtlas& solid, const Image<Number>& image) {
    std::vector<double> values;
    for_each_span(solid, [&](const Span& span, const TexelMap&, std::int64_t y) {
        for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
            values.push_back(double(image(x, std::size_t(y))));
    });
    return values;
}

/// Returns the error bound of forward differences for amplitudes with the sum 2, as a share of 1 +
/// the magnitudes of the quadric's terms.
double forward_error(ForwardPrecision precision) {
    if (precision == ForwardPrecision::float32) return 4e-6;
    return precision == ForwardPrecision::float64 ? 4e-12 : 4e-8;
}

}  // namespace

std::vector<StabilityWay> stability_ways() {
    std::vector<StabilityWay> ways;
    for (const NamedKernel& one : kernel_names)
        ways.push_back({"--kernel " + std::string(one.name), "float32", one.kernel});
    ways.push_back({"--precision float64", "float64", Float64Way{}});
    using enum ForwardPrecision;
    ways.push_back({"--kernel forward --precision float32", "forward float32", float32});
    ways.push_back({"--kernel forward", "forward float64", float64});
    ways.push_back({"forward differences in fixed64", "forward fixed64", fixed64});
    return ways;
}

bool can_fill(const StabilityWay& way, const Texture& texture) {
    return !std::holds_alternative<ForwardPrecision>(way.how) ||
           no_forward_form(expand_octaves(texture)).empty();
}

std::vector<double> fill_texels(const StabilityCase& one, const StabilityWay& way, int threads) {
    const auto& [input, texture, solid, map] = one;
    if (const auto* kernel = std::get_if<Kernel>(&way.how))
        return of_spans(solid, synthesize_field(solid, texture, map, threads, *kernel));
    if (const auto* precision = std::get_if<ForwardPrecision>(&way.how))
        return of_spans(solid, forward_field_of_atlas(solid, texture, map, *precision, threads));
    return of_spans(solid,
                    field_of_texels(solid, texture, map, {PrecisionKind::float64, {}}, threads));
}

double allowed_error(const StabilityWay& way, const StabilityTruth& truth, const SpanSizes& sizes,
                     double f) {
    const double size = std::abs(f) + truth.amplitudes(), rounding = truth.rounding(sizes);
    if (std::holds_alternative<Kernel>(way.how))
        return 2.5e-7 * size + truth.special_errors() + rounding;
    if (const auto* precision = std::get_if<ForwardPrecision>(&way.how))
        return forward_error(*precision) *
                   (std::max(1.0, 0.5 * truth.amplitudes()) + sizes.quadric) +
               rounding;
    return 1e-15 * size + rounding;
}

double place_error(const StabilityWay& way) {
    return way.arithmetic == "float32" ? 0x1p-23 : 0x1p-50;
}

}  // namespace burl
