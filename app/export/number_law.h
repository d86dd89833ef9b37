#pragma once
// Laws that a shader's numbers follow when one of a recipe's numbers changes: found from samples,
// written as GLSL. The samples have the accuracy of float32.
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burl {

/// A quantity made of a variable u: the power (u + shift)^power. Whatever a texture makes of a
/// number is proportional to one, but for a constant.
struct Quantity {
    int power = 1;       ///< from -8 to 8, not 0
    double shift = 0.0;  ///< 0 unless the power is -1
    double at(double u) const;
};

/// The law y = constant + factor * quantity.
struct SimpleLaw {
    Quantity quantity;
    double constant = 0.0, factor = 0.0;
};

/// The simplest law, with the fewest digits, that all samples follow but for rounding to float32;
/// none where there is no such law. At least two samples with distinct u.
std::optional<SimpleLaw> find_law(std::span<const double> u, std::span<const double> y);

/// A quantity of a variable that a shader knows by an expression.
struct NamedQuantity {
    std::string name;  ///< the variable: a name or an expression in parentheses
    Quantity quantity;
};

/// A sum of products of quantities: factors[s] is that of the product of the quantities whose bits
/// s has, factors[0] the constant.
struct ProductLaw {
    std::vector<NamedQuantity> quantities;  ///< at most most_quantities
    std::vector<double> factors;            ///< 2^quantities.size() of them

    /// The number where the quantities have these values.
    double at(std::span<const double> values) const;
    /// Whether `y` is that number but for rounding to float32.
    bool agrees(std::span<const double> values, double y) const;
    /// The law as a GLSL expression.
    std::string text() const;
};
inline constexpr std::size_t most_quantities = 4;

/// The law of a number that is a sum of a constant and of quantities times factors, and is `number`
/// where they have these values.
ProductLaw sum_law(std::vector<NamedQuantity> quantities, std::span<const double> factors,
                   std::span<const double> values, double number);

/// The law of a number that is affine in each of the quantities: `corners[s]` is the number where
/// those of s have their values `high`, the others `low`.
ProductLaw law_between(std::vector<NamedQuantity> quantities, std::span<const double> low,
                       std::span<const double> high, std::span<const double> corners);

}  // namespace burl
