#include "procedural/glsl/map_tables.h"

#include <fmt/format.h>

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

}  // namespace burl
