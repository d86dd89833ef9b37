#pragma once
// Reports that follow a quantity over many steps, as curves: what a texel takes, and errs by, over
// how far apart texels are in the lattice.
#include <string>

#include "app/base/json_text.h"

namespace burl {

/// Whether the rows are of that kind: the suites `forward` and `kernels`.
bool has_curves(const Json& rows);

/// SVG: a panel per function and quantity, both axes logarithmic; all panels of a quantity have the
/// same. Points without a number above 0 are left out. `rows` are the report's.
std::string curve_plot(const Json& report, const Json& rows);

}  // namespace burl
