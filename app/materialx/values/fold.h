#pragma once
// Arithmetic of constants, as the recipe's nodes compute it.
#include <optional>
#include <string_view>
#include <vector>

namespace burl::materialx {

/// The result of one of MaterialX's operations on constant numbers; none where the recipe's nodes
/// are left to compute it, or the result is none that a recipe can hold.
std::optional<double> folded_constant(std::string_view operation,
                                      const std::vector<double>& inputs);

}  // namespace burl::materialx
