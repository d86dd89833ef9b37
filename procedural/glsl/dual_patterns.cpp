// The nodes of regular patterns with their gradients and, over a footprint, their means, as
// graph/patterns.cpp defines them.
#include <numbers>

#include <fmt/format.h>

#include "procedural/glsl/duals.h"

namespace burl {

namespace {

/// The text "FUNCTION(x, width)" of a new variable x.
std::string over_box(const GlslNodeCall& call, const char* function, const std::string& x) {
    const std::string at = call.text->dual(x);
    return fmt::format("{}({}, {})", function, at, call.text->box_width(at));
}

/// The coordinate along `direction`, in periods.
std::string periods(const GlslNodeCall& call) {
    return call.along(call.vector("direction") / call.parameter("period"));
}

GlslNode stripes(const GlslNodeCall& call) {
    return call.blend(over_box(call, "box_odd", periods(call)));
}

GlslNode ramp(const GlslNodeCall& call) {
    return call.blend(over_box(call, "box_fract", periods(call)));
}

GlslNode sine(const GlslNodeCall& call) {
    const std::string turns = call.text->dual(periods(call));
    const std::string angle =
        fmt::format("{} * {}", call.text->number(2.0 * std::numbers::pi), turns);
    return call.blend(fmt::format("{} + {} * {}", call.text->constant(0.5), call.text->number(0.5),
                                  over_box(call, "box_sin", angle)));
}

GlslNode rings(const GlslNodeCall& call) {
    return call.blend(over_box(
        call, "box_odd",
        fmt::format("{} * dual_length({}, {})", call.text->number(1.0 / call.parameter("spacing")),
                    call.axis(0), call.axis(1))));
}

GlslNode wood_grain(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const std::string angle = text.dual(fmt::format(
        "{} * dual_angle({}, {}) + {} * {}", text.number(call.parameter("wobbles")), call.axis(1),
        call.axis(0), glsl_operand(text.number(call.parameter("twist"))), call.axis(2)));
    const std::string x =
        fmt::format("{} * dual_length({}, {}) + {} * dual_sin({})",
                    text.number(1.0 / call.parameter("spacing")), call.axis(0), call.axis(1),
                    glsl_operand(text.number(call.parameter("wobble"))), angle);
    const bool ramped = call.parameter("profile") == 1.0;
    return call.blend(over_box(call, ramped ? "box_fract" : "box_odd", x));
}

enum class Antialiasing { none, closed_form, supersample, trapezoid };

/// The mean of black minus white stripes along axis i.
std::string board_stripes(const GlslNodeCall& call, Antialiasing antialiasing, std::size_t i) {
    GlslDuals& text = *call.text;
    const std::string x = call.axis(i);
    const std::string steps = fmt::format("{}, {}, {}", x, text.along(x, 'u'), text.along(x, 'v'));
    if (!text.filtering() || antialiasing == Antialiasing::none)
        return fmt::format("stripes_over_box({}, {}, {})", x, text.number(0.0), text.number(0.0));
    if (antialiasing == Antialiasing::closed_form)
        return fmt::format("stripes_over_box({})", steps);
    const Rgb8 black{0, 0, 0}, white{255, 255, 255};
    const ColorMap stripes{Wrap::repeat, {{0.0, black}, {0.5, black}, {0.5, white}, {1.0, white}}};
    return fmt::format("stripes_over_both({}, {})", text.filtering()->maps.add(stripes), steps);
}

/// A checkerboard in the first `axes` coordinates of the point. Without a footprint all kinds of
/// `aa` are the board itself.
GlslNode checkers(const GlslNodeCall& call, std::size_t axes) {
    GlslDuals& text = *call.text;
    const auto antialiasing = Antialiasing(int(call.parameter("aa")));
    if (text.filtering() && antialiasing == Antialiasing::supersample) {
        const auto moved = [&](char step) {
            return fmt::format("real3({}, {}, {})", text.along(call.axis(0), step),
                               text.along(call.axis(1), step), text.along(call.axis(2), step));
        };
        return call.blend(
            fmt::format("dual(supersampled_board(real3({}.x, {}.x, {}.x), {}, {}, {}))",
                        call.axis(0), call.axis(1), call.axis(2), moved('u'), moved('v'), axes));
    }
    std::string sign;
    for (std::size_t i = 0; i < axes; ++i) {
        const std::string stripes = text.dual(board_stripes(call, antialiasing, i));
        sign = i == 0 ? stripes : text.dual(fmt::format("dual_product({}, {})", sign, stripes));
    }
    return call.blend(fmt::format("{} - {} * {}", text.constant(0.5), text.number(0.5), sign));
}

GlslNode checkerboard(const GlslNodeCall& call) {
    return checkers(call, 2);
}

GlslNode checkerboard_3d(const GlslNodeCall& call) {
    return checkers(call, 3);
}

constexpr std::array patterns_table{NamedGlslNode{"stripes", stripes},
                                    NamedGlslNode{"ramp", ramp},
                                    NamedGlslNode{"sine", sine},
                                    NamedGlslNode{"rings", rings},
                                    NamedGlslNode{"wood_grain", wood_grain},
                                    NamedGlslNode{"checkerboard", checkerboard},
                                    NamedGlslNode{"checkerboard_3d", checkerboard_3d}};

}  // namespace

std::span<const NamedGlslNode> glsl_pattern_nodes() {
    return patterns_table;
}

}  // namespace burl
