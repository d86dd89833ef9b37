#include "app/export/number_law.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <fmt/format.h>

#include "app/base/shader_numbers.h"

namespace burl {

namespace {

/// Samples and factors are each rounded to float32, whose relative error is 6e-8.
constexpr double rounding = 1.3e-7, several_roundings = 4e-7;
/// A constant so many times the number itself would leave too little of it in float32.
constexpr double most_cancelled = 100.0;
constexpr int most_power = 8, most_digits = 9, most_divisor_digits = 4;

double with_digits(double x, int digits) {
    return std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr);
}

/// The law with its factors rounded, or the divisor in place of the factor.
SimpleLaw rounded(SimpleLaw law, int digits, bool divides) {
    law.constant = with_digits(law.constant, digits);
    law.factor =
        divides ? 1.0 / with_digits(1.0 / law.factor, digits) : with_digits(law.factor, digits);
    return law;
}

bool follows(const SimpleLaw& law, std::span<const double> u, std::span<const double> y) {
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double product = law.factor * law.quantity.at(u[i]);
        const double size = std::abs(law.constant) + std::abs(product);
        // Not true of what is not a number.
        if (!(std::abs(law.constant + product - y[i]) <= rounding * size)) return false;
    }
    return true;
}

/// The law with the fewest digits that the samples follow.
std::optional<SimpleLaw> with_fewest_digits(const SimpleLaw& law, std::span<const double> u,
                                            std::span<const double> y) {
    if (law.factor == 0.0 || !std::isfinite(law.factor)) return {};
    for (int digits = 1; digits <= most_digits; ++digits)
        for (const bool divides : {false, true}) {
            if (divides && (law.constant != 0.0 || digits > most_divisor_digits)) continue;
            const SimpleLaw simple = rounded(law, digits, divides);
            if (follows(simple, u, y)) return simple;
        }
    return {};
}

/// The two samples with the least and the greatest quantity.
std::pair<std::size_t, std::size_t> quantity_ends(const Quantity& quantity,
                                                  std::span<const double> u) {
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < u.size(); ++i) {
        if (quantity.at(u[i]) < quantity.at(u[low])) low = i;
        if (quantity.at(u[i]) > quantity.at(u[high])) high = i;
    }
    return {low, high};
}

/// The law with this quantity: without a constant if that is enough.
std::optional<SimpleLaw> law_of(const Quantity& quantity, std::span<const double> u,
                                std::span<const double> y) {
    const auto [low, high] = quantity_ends(quantity, u);
    const double first = quantity.at(u[low]), last = quantity.at(u[high]);
    const std::size_t larger = std::abs(last) > std::abs(first) ? high : low;
    const SimpleLaw product{quantity, 0.0, y[larger] / quantity.at(u[larger])};
    if (auto found = with_fewest_digits(product, u, y)) return found;
    const double factor = (y[high] - y[low]) / (last - first);
    const double constant = y[low] - factor * first;
    if (std::abs(constant) > most_cancelled * std::max(std::abs(y[low]), std::abs(y[high])))
        return {};
    return with_fewest_digits({quantity, constant, factor}, u, y);
}

/// The shift of a reciprocal that goes through three samples.
double shift_through(std::span<const double, 3> u, std::span<const double, 3> y) {
    const double q = (y[0] - y[1]) / (y[1] - y[2]) * (u[2] - u[1]) / (u[1] - u[0]);
    return (u[2] - q * u[0]) / (q - 1.0);
}

/// The law of a shifted reciprocal, A + B / (u + shift).
std::optional<SimpleLaw> reciprocal_law(std::span<const double> u, std::span<const double> y) {
    if (u.size() < 4) return {};
    std::vector<std::size_t> order(u.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return u[i]; });
    const std::array picked{order.front(), order[order.size() / 2], order.back()};
    std::array<double, 3> some_u{}, some_y{};
    for (std::size_t i = 0; i < 3; ++i) some_u[i] = u[picked[i]], some_y[i] = y[picked[i]];
    const double shift = shift_through(some_u, some_y);
    if (!std::isfinite(shift)) return {};
    for (int digits = 1; digits <= most_digits; ++digits) {
        const Quantity quantity{-1, with_digits(shift, digits)};
        const bool pole_between =
            (some_u.front() + quantity.shift < 0.0) != (some_u.back() + quantity.shift < 0.0);
        if (pole_between) continue;
        if (auto found = law_of(quantity, u, y)) return found;
    }
    return {};
}

/// The power that samples of a product B u^n have; 1 where they have none.
int power_of(std::span<const double> u, std::span<const double> y) {
    const auto [low, high] = quantity_ends({}, u);
    const double n = std::log(std::abs(y[high] / y[low])) / std::log(std::abs(u[high] / u[low]));
    return std::isfinite(n) && std::abs(n) < most_power + 0.5 ? int(std::lround(n)) : 1;
}

/// The product of the quantities of a set.
double product_of(std::span<const double> values, std::size_t set) {
    double product = 1.0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (set >> i & 1) product *= values[i];
    return product;
}

/// The text of u + shift.
std::string base_text(const NamedQuantity& one) {
    const double shift = one.quantity.shift;
    if (shift == 0.0) return one.name;
    return fmt::format("({} {} {})", one.name, shift < 0.0 ? '-' : '+',
                       shader_number(std::abs(shift)));
}

/// The text of a positive factor times a product; a division where that has fewer digits.
std::string term_text(double factor, const std::vector<NamedQuantity>& quantities,
                      std::size_t set) {
    std::vector<std::string> factors, divisors;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        if (!(set >> i & 1)) continue;
        const int power = quantities[i].quantity.power;
        for (int k = 0; k < std::abs(power); ++k)
            (power > 0 ? factors : divisors).push_back(base_text(quantities[i]));
    }
    const std::string number = shader_number(factor), divisor = shader_number(1.0 / factor);
    if (!factors.empty() && divisor.size() + most_divisor_digits <= number.size())
        divisors.push_back(divisor);
    else if (factors.empty() || number != "1.0")
        factors.insert(factors.begin(), number);
    std::string text = fmt::format("{}", fmt::join(factors, " * "));
    for (const std::string& one : divisors) text += " / " + one;
    return text;
}

}  // namespace

double Quantity::at(double u) const {
    double result = 1.0;
    for (int k = 0; k < std::abs(power); ++k) result *= u + shift;
    return power < 0 ? 1.0 / result : result;
}

std::optional<SimpleLaw> find_law(std::span<const double> u, std::span<const double> y) {
    const Quantity power{power_of(u, y), 0.0};
    for (const Quantity& quantity : {power, Quantity{1, 0.0}, Quantity{-1, 0.0}}) {
        const bool zero = std::ranges::find(u, 0.0) != u.end();
        if (quantity.power < 0 && zero) continue;
        if (quantity.power == 0) continue;
        if (auto found = law_of(quantity, u, y)) return found;
    }
    return reciprocal_law(u, y);
}

double ProductLaw::at(std::span<const double> values) const {
    double sum = 0.0;
    for (std::size_t set = 0; set < factors.size(); ++set)
        sum += factors[set] * product_of(values, set);
    return sum;
}

bool ProductLaw::agrees(std::span<const double> values, double y) const {
    double size = 0.0;
    for (std::size_t set = 0; set < factors.size(); ++set)
        size += std::abs(factors[set] * product_of(values, set));
    return std::abs(at(values) - y) <= several_roundings * size;
}

std::string ProductLaw::text() const {
    std::string text;
    for (std::size_t set = 0; set < factors.size(); ++set) {
        if (factors[set] == 0.0) continue;
        const bool negative = factors[set] < 0.0;
        const std::string term = term_text(std::abs(factors[set]), quantities, set);
        const char* sign = text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        text += sign + term;
    }
    return text.empty() ? shader_number(0.0) : text;
}

ProductLaw sum_law(std::vector<NamedQuantity> quantities, std::span<const double> factors,
                   std::span<const double> values, double number) {
    ProductLaw law{std::move(quantities), std::vector<double>(std::size_t(1) << factors.size())};
    double rest = number, size = std::abs(number);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        law.factors[std::size_t(1) << i] = factors[i];
        rest -= factors[i] * values[i];
        size += std::abs(factors[i] * values[i]);
    }
    if (std::abs(rest) > several_roundings * size) law.factors[0] = rest;
    return law;
}

ProductLaw law_between(std::vector<NamedQuantity> quantities, std::span<const double> low,
                       std::span<const double> high, std::span<const double> corners) {
    ProductLaw law{std::move(quantities), {corners.begin(), corners.end()}};
    const std::size_t sets = law.factors.size();
    double size = 0.0;
    for (const double corner : corners) size = std::max(size, std::abs(corner));
    // Along one quantity after the other: from the numbers at both ends to constant and factor.
    for (std::size_t i = 0; i < law.quantities.size(); ++i)
        for (std::size_t set = 0; set < sets; ++set) {
            if (set >> i & 1) continue;
            double &constant = law.factors[set], &factor = law.factors[set | std::size_t(1) << i];
            factor = (factor - constant) / (high[i] - low[i]);
            constant -= factor * low[i];
        }
    std::vector<double> largest;
    for (std::size_t i = 0; i < law.quantities.size(); ++i)
        largest.push_back(std::max(std::abs(low[i]), std::abs(high[i])));
    for (std::size_t set = 0; set < sets; ++set)
        if (std::abs(law.factors[set]) * product_of(largest, set) <= 2.0 * several_roundings * size)
            law.factors[set] = 0.0;
    return law;
}

}  // namespace burl
