// The steps of checkerboards and colours with gradients, as graph/dual_colors.cpp evaluates them.
#include <fmt/format.h>

#include "procedural/color/marble_spline.h"
#include "procedural/glsl/duals.h"

namespace burl {

namespace {

std::string real3(const Vec3d& v, GlslReal real) {
    return fmt::format("real3({}, {}, {})", glsl_number(v.x, real), glsl_number(v.y, real),
                       glsl_number(v.z, real));
}

/// The text "const TYPE NAME[n] = TYPE[n](...);" with number(item) for each item.
template <class Item, class Number>
std::string array(const char* type, const char* name, const std::vector<Item>& items,
                  const Number& number) {
    std::vector<std::string> texts;
    for (const Item& item : items) texts.push_back(number(item));
    if (texts.empty()) texts.push_back(fmt::format("{}(0.0)", type));
    return fmt::format("const {0} {1}[{2}] = {0}[{2}](\n    {3});\n", type, name, texts.size(),
                       fmt::join(texts, ",\n    "));
}

}  // namespace

std::string GlslMapTables::add(const ColorMap& colors) {
    const MapPieces map(colors);
    const std::string text = fmt::format("PieceMap({}, {}, {}, {}, {}, {})", pieces_.size(),
                                         map.pieces().size(), breaks_.size(), map.breaks().size(),
                                         map.wrap() == Wrap::repeat, real3(map.mean(), real_));
    pieces_.insert(pieces_.end(), map.pieces().begin(), map.pieces().end());
    breaks_.insert(breaks_.end(), map.breaks().begin(), map.breaks().end());
    return text;
}

std::string GlslMapTables::text() const {
    using MapPiece = MapPieces::Piece;
    const auto colors = [&](const char* name, Vec3d MapPiece::*member) {
        return array("real3", name, pieces_,
                     [&](const MapPiece& piece) { return real3(piece.*member, real_); });
    };
    const auto changes = [&](const char* name, Vec3d MapBreak::*member) {
        return array("real3", name, breaks_,
                     [&](const MapBreak& at) { return real3(at.*member, real_); });
    };
    return array("real", "piece_starts", pieces_,
                 [&](const MapPiece& piece) { return glsl_number(piece.start, real_); }) +
           colors("piece_colors", &MapPiece::color) + colors("piece_slopes", &MapPiece::slope) +
           colors("piece_firsts", &MapPiece::first) + colors("piece_seconds", &MapPiece::second) +
           array("real", "break_places", breaks_,
                 [&](const MapBreak& at) { return glsl_number(at.position, real_); }) +
           changes("break_jumps", &MapBreak::jump) + changes("break_kinks", &MapBreak::kink);
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
    Names points;
    for (const auto& c : marble_colors)
        points.push_back(real3(marble_brightness * Vec3d(c[0], c[1], c[2])));
    return color(fmt::format("dual_spline({}, real3[{}]({}), {})", in(0), points.size(),
                             fmt::join(points, ", "), colors.smooth));
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
