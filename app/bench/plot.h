#pragma once
// A report as a picture: `burl bench plot`. Run time against error has one panel per group of a
// suite's report, both axes logarithmic and the same in all panels, methods that no other beats in
// both joined by a line (the Pareto front); suites that follow a quantity over steps are curves
// (plot_curves.h), the worst errors of `stability` bars (plot_shares.h).
#include <string>

#include "app/base/json_text.h"

namespace burl {

/// SVG of a report as `burl bench SUITE -o FILE` writes it; `origin` names it in messages. Methods
/// are told apart by number, shape and a palette for colour-blind readers (Okabe & Ito). What has
/// no error stands below the axis at 0, what has none known above it. Throws Error(invalid_file)
/// where the report is none or there is nothing of that kind in it.
std::string bench_plot(const Json& report, const std::string& origin);

}  // namespace burl
