#pragma once
// All ways there are to fill texels with a texture's field, and how far each may be from the
// definition: `burl bench stability` looks at every one of them.
#include <string>
#include <variant>
#include <vector>

#include "app/bench/stability_cases.h"
#include "app/bench/stability_truth.h"
#include "procedural/batch/kernel.h"
#include "procedural/bresenham/noise.h"

namespace burl {

struct Float64Way {};  ///< --precision float64

struct StabilityWay {
    std::string name;        ///< as options of `burl bake`; fixed64 has none
    std::string arithmetic;  ///< ways of one arithmetic have one bound and share a row
    std::variant<Kernel, Float64Way, ForwardPrecision> how;
};

/// Every kernel of kernel_names, the reference evaluation and forward differences.
std::vector<StabilityWay> stability_ways();

/// Whether the way knows the texture's noises.
bool can_fill(const StabilityWay& way, const Texture& texture);

/// f of every texel that a span owns, span by span.
std::vector<double> fill_texels(const StabilityCase& one, const StabilityWay& way, int threads);

/// What |f - f64| may be on a span of these sizes (docs/reference/numerics.md).
double allowed_error(const StabilityWay& way, const StabilityTruth& truth, const SpanSizes& sizes,
                     double f);

/// By how much of a cell the way rounds a place in it.
double place_error(const StabilityWay& way);

/// visit(span, map, y) for every span.
template <class Visit>
void for_each_span(const SolidAtlas& solid, const Visit& visit) {
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y)) visit(span, solid.maps[span.map], std::int64_t(y));
}

}  // namespace burl
