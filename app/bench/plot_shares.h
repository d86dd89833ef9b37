#pragma once
// The report of `burl bench stability` as bars: how much of the error that
// docs/reference/numerics.md allows each group of inputs takes at worst.
#include <string>

#include "app/base/json_text.h"

namespace burl {

/// Whether the rows are of that kind.
bool has_shares(const Json& rows);

/// SVG: a bar per group on a logarithmic axis with a line at all that is allowed, and the error
/// there.
std::string share_plot(const Json& report, const Json& rows);

}  // namespace burl
