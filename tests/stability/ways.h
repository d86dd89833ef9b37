#pragma once
// All ways to fill texels with a texture's field, with their error bounds; `burl bench stability`
// checks each of them.
#include <string>
#include <variant>
#include <vector>

#include "procedural/batch/kernel.h"
#include "procedural/bresenham/noise.h"
#include "tests/stability/cases.h"
#include "tests/stability/truth.h"

namespace burl {

struct Float64Way {};  ///< evaluation with --precision float64

/// A way to fill texels.
struct StabilityWay {
    std::string name;        ///< options of `burl bake`; fixed64 has none
    std::string arithmetic;  ///< ways of the same arithmetic have one bound and share a row
    std::variant<Kernel, Float64Way, ForwardPrecision> how;
};

/// Returns every kernel of kernel_names, the reference evaluation and forward differences.
std::vector<StabilityWay> stability_ways();

/// Whether the way supports the texture's noises.
bool can_fill(const StabilityWay& way, const Texture& texture);

/// Returns f of every texel that a span owns, span by span.
std::vector<double> fill_texels(const StabilityCase& one, const StabilityWay& way, int threads);

/// Returns the bound on |f - f64| in a span of these magnitudes (docs/reference/numerics.md).
double allowed_error(const StabilityWay& way, const StabilityTruth& truth, const SpanSizes& sizes,
                     double f);

/// Returns the rounding of a position within its cell, in cells.
double place_error(const StabilityWay& way);

/// Calls visit(span, map, y) for every span.
template <class Visit>
void for_each_span(const SolidAtlas& solid, const Visit& visit) {
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y)) visit(span, solid.maps[span.map], std::int64_t(y));
}

}  // namespace burl
