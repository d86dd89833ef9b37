// The steps of checkerboards and colours with gradients, as graph/dual_colors.cpp evaluates them.
#include <type_traits>

#include <fmt/format.h>

#include "procedural/color/marble_spline.h"
#include "procedural/glsl/duals.h"

namespace burl {

namespace {

std::string real3(const Vec3d& v, GlslReal real) {
    return fmt::format("real3({}, {}, {})", glsl_number(v.x, real), glsl_number(v.y, real),
                       glsl_number(v.z, real));
}

/// The array of a number, or of the components of a vector, of each item.
template <class Item, class Number>
std::string array(const char* name, const std::vector<Item>& items, Number Item::*member,
                  GlslReal real) {
    constexpr std::size_t width = std::is_same_v<Number, Vec3d> ? 3 : 1;
    std::vector<double> numbers;
    for (const Item& item : items) {
        if constexpr (width == 3)
            for (int c = 0; c < 3; ++c) numbers.push_back((item.*member)[c]);
        else
            numbers.push_back(item.*member);
    }
    if (numbers.empty()) numbers.resize(width, 0.0);
    return glsl_array(name, numbers, width, real);
}

/// The points of marble's spline as an array.
std::string marble_points(GlslReal real) {
    std::vector<double> numbers;
    for (const auto& color : marble_colors)
        for (const double c : color) numbers.push_back(marble_brightness * c);
    return glsl_array("marble_points", numbers, 3, real);
}

}  // namespace

std::string GlslMapTables::add(const ColorMap& colors) {
    const MapPieces map(colors);
    std::string text = fmt::format("PieceMap({}, {}, {}, {}, {}, {})", pieces_.size(),
                                   map.pieces().size(), breaks_.size(), map.breaks().size(),
                                   map.wrap() == Wrap::repeat, real3(map.mean(), real_));
    pieces_.insert(pieces_.end(), map.pieces().begin(), map.pieces().end());
    breaks_.insert(breaks_.end(), map.breaks().begin(), map.breaks().end());
    return text;
}

std::string GlslMapTables::text() const {
    using MapPiece = MapPieces::Piece;
    return array("piece_starts", pieces_, &MapPiece::start, real_) +
           array("piece_colors", pieces_, &MapPiece::color, real_) +
           array("piece_slopes", pieces_, &MapPiece::slope, real_) +
           array("piece_firsts", pieces_, &MapPiece::first, real_) +
           array("piece_seconds", pieces_, &MapPiece::second, real_) +
           array("break_places", breaks_, &MapBreak::position, real_) +
           array("break_jumps", breaks_, &MapBreak::jump, real_) +
           array("break_kinks", breaks_, &MapBreak::kink, real_) + marble_points(real_);
}

/// The expression of black minus white along one axis of a checkerboard. Without a footprint all
/// methods of antialiasing give the board itself.
std::string GlslDuals::stripes_of(Antialiasing antialiasing, const std::string& x) {
    const std::string steps = fmt::format("{}, {}, {}", x, along(x, 'u'), along(x, 'v'));
    if (!filter_ || antialiasing == Antialiasing::none)
        return fmt::format("stripes_over_box({}, {}, {})", x, number(0.0), number(0.0));
    if (antialiasing == Antialiasing::closed_form)
        return fmt::format("stripes_over_box({})", steps);
    const Rgb8 black{0, 0, 0}, white{255, 255, 255};
    const ColorMap stripes{Wrap::repeat, {{0.0, black}, {0.5, black}, {0.5, white}, {1.0, white}}};
    return fmt::format("stripes_over_both({}, {})", maps_.add(stripes), steps);
}

std::string GlslDuals::supersampled(std::size_t axes) const {
    const auto moved = [&](char step) {
        return fmt::format("real3({}, {}, {})", along(in(0), step), along(in(1), step),
                           along(in(2), step));
    };
    return fmt::format("dual(supersampled_board(real3({}.x, {}.x, {}.x), {}, {}, {}))", in(0),
                       in(1), in(2), moved('u'), moved('v'), axes);
}

GlslDuals::Names GlslDuals::step(const Checkerboard& board) {
    if (filter_ && board.antialiasing == Antialiasing::supersample)
        return {dual(supersampled(board.axes))};
    std::string sign;
    for (std::size_t i = 0; i < board.axes; ++i) {
        const std::string stripes = dual(stripes_of(board.antialiasing, in(i)));
        sign = i == 0 ? stripes : dual(fmt::format("dual_product({}, {})", sign, stripes));
    }
    return {dual(fmt::format("{} - {} * {}", constant(0.5), number(0.5), sign))};
}

GlslDuals::Names GlslDuals::color(const std::string& expression) {
    const std::string name = variable("DualColor", expression);
    return {name + ".r", name + ".g", name + ".b"};
}

GlslDuals::Names GlslDuals::step(const MapColors& colors) {
    const bool both = filter_ && (filter_->kind == FilterKind::trapezoid ||
                                  filter_->kind == FilterKind::trapezoid2);
    return color(fmt::format("dual_color({}, {}, {}, {}, {})", maps_.add(colors.map()), in(0),
                             along(in(0), 'u'), along(in(0), 'v'), both));
}

GlslDuals::Names GlslDuals::step(const MarbleColors& colors) {
    return color(fmt::format("dual_spline({}, {})", in(0), colors.smooth));
}

GlslDuals::Names GlslDuals::step(const ImageColors& image) {
    const std::string at = fmt::format("{}, {}, {}.x, {}.x", functions_.image(image.pixels),
                                       image.pixels->level_count(), in(0), in(1));
    const auto moved = [&](char step) {
        return fmt::format("real2({}, {})", along(in(0), step), along(in(1), step));
    };
    const std::string u = moved('u'), v = moved('v');
    const int wrap = int(image.pixels->wrap());
    const std::string sample =
        image.ewa
            ? fmt::format("ewa_sample({}, {}, {}, {}, {})", at, u, v, number(image.anisotropy),
                          wrap)
            : fmt::format("trilinear_sample({}, trilinear_width({}, {}), {})", at, u, v, wrap);
    return color(fmt::format("dual_image({}, {}, {})", sample, in(0), in(1)));
}

}  // namespace burl
