#include "app/materialx/values/fold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burl::materialx {

namespace {

using Arguments = std::vector<double>;

struct Fold {
    std::string_view operation;
    double (*compute)(const Arguments& x);
};

double mixed(const Arguments& x) {
    return x[0] + (x[1] - x[0]) * x[2];
}

double smooth(const Arguments& x) {
    if (x[1] >= x[2]) return x[0] >= x[1] ? 1.0 : 0.0;
    const double t = std::clamp((x[0] - x[1]) / (x[2] - x[1]), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double quotient(const Arguments& x) {
    return x[1] == 0.0 ? 0.0 : x[0] / x[1];
}

double power(const Arguments& x) {
    const double result = std::pow(x[0], x[1]);
    return std::isfinite(result) ? result : 0.0;
}

constexpr std::array folds{
    Fold{"add", [](const Arguments& x) { return x[0] + x[1]; }},
    Fold{"subtract", [](const Arguments& x) { return x[0] - x[1]; }},
    Fold{"multiply", [](const Arguments& x) { return x[0] * x[1]; }},
    Fold{"divide", quotient},
    Fold{"min", [](const Arguments& x) { return std::min(x[0], x[1]); }},
    Fold{"max", [](const Arguments& x) { return std::max(x[0], x[1]); }},
    Fold{"clamp", [](const Arguments& x) { return std::min(std::max(x[0], x[1]), x[2]); }},
    Fold{"mix", mixed},
    Fold{"smoothstep", smooth},
    Fold{"power", power},
    Fold{"absval", [](const Arguments& x) { return std::abs(x[0]); }},
    Fold{"floor", [](const Arguments& x) { return std::floor(x[0]); }},
    Fold{"ceil", [](const Arguments& x) { return std::ceil(x[0]); }},
    Fold{"sign", [](const Arguments& x) { return double(x[0] > 0.0) - double(x[0] < 0.0); }},
    Fold{"sin", [](const Arguments& x) { return std::sin(x[0]); }},
    Fold{"cos", [](const Arguments& x) { return std::cos(x[0]); }},
    Fold{"ifgreater", [](const Arguments& x) { return double(x[0] > x[1]); }},
    Fold{"ifgreatereq", [](const Arguments& x) { return double(x[0] >= x[1]); }},
    Fold{"ifequal", [](const Arguments& x) { return double(x[0] == x[1]); }},
};

}  // namespace

std::optional<double> folded_constant(std::string_view operation, const Arguments& inputs) {
    const auto fold = std::ranges::find(folds, operation, &Fold::operation);
    if (fold == folds.end()) return {};
    const double result = fold->compute(inputs);
    if (!(std::abs(result) <= 1e9)) return {};
    return result;
}

}  // namespace burl::materialx
