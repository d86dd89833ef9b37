// The pieces, breaks and antiderivatives are computed once per map, in double.
#include "procedural/color/map_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "procedural/color/srgb.h"
#include "procedural/color/table.h"

namespace burl {

namespace {

/// The distance below which two stops make a jump: float32 values of f cannot tell them apart, and
/// the slope between them would be lost in the sum, or infinite.
constexpr double closest_stops = 0x1p-20;

/// The map's stops plus one at either side, so that [0, 1] is covered: the next period's stop with
/// `repeat`, the end colour again with `clamp`.
std::vector<ColorStop> covering_stops(const ColorMap& map) {
    std::vector<ColorStop> stops = map.stops;
    if (stops.empty()) stops.push_back({});
    ColorStop low = stops.front(), high = stops.back();
    if (map.wrap == Wrap::repeat) std::swap(low, high);
    low.position = map.wrap == Wrap::repeat ? low.position - 1.0 : 0.0;
    high.position = high.position + (map.wrap == Wrap::repeat ? 1.0 : 0.0);
    stops.insert(stops.begin(), low);
    stops.push_back(high);
    for (std::size_t i = 1; i < stops.size(); ++i)
        if (stops[i].position - stops[i - 1].position < closest_stops)
            stops[i].position = stops[i - 1].position;
    return stops;
}

}  // namespace

MapPieces::MapPieces(const ColorMap& map) : wrap_(map.wrap) {
    fill_pieces(map);
    if (wrap_ == Wrap::repeat) take_mean_out();
    integrate();
    fill_breaks();
}

void MapPieces::fill_pieces(const ColorMap& map) {
    const std::vector<ColorStop> stops = covering_stops(map);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const double width = stops[i + 1].position - stops[i].position;
        const Vec3d from = light_of(stops[i]), to = light_of(stops[i + 1]);
        Piece piece{
            stops[i].position, from, width > 0.0 ? (to - from) / width : Vec3d(0.0), {}, {}};
        if (wrap_ == Wrap::repeat && stops[i + 1].position <= 0.0) continue;
        if (wrap_ == Wrap::repeat && piece.start >= 1.0) continue;
        if (piece.start < 0.0) {
            piece.color -= piece.start * piece.slope;
            piece.start = 0.0;
        }
        if (width > 0.0) pieces_.push_back(piece);
    }
    if (wrap_ == Wrap::clamp)
        pieces_.push_back({stops.back().position, light_of(stops.back()), {}, {}, {}});
    if (wrap_ == Wrap::clamp)
        pieces_.insert(pieces_.begin(), {pieces_.front().start, light_of(stops[0]), {}, {}, {}});
}

void MapPieces::take_mean_out() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double width =
            (i + 1 < pieces_.size() ? pieces_[i + 1].start : 1.0) - pieces_[i].start;
        mean_ += width * (pieces_[i].color + 0.5 * width * pieces_[i].slope);
    }
    for (Piece& piece : pieces_) piece.color -= mean_;
}

void MapPieces::integrate() {
    // The mean of the first antiderivative.
    Vec3d drift(0.0);
    for (const int pass : {0, 1}) {
        Vec3d first = -drift, second(0.0);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            Piece& piece = pieces_[i];
            piece.first = first;
            piece.second = second;
            const double end = i + 1 < pieces_.size() ? pieces_[i + 1].start : 1.0;
            const double x = std::max(end - piece.start, 0.0);
            second += x * (first + x * (piece.color / 2.0 + x / 6.0 * piece.slope));
            first += x * (piece.color + x / 2.0 * piece.slope);
        }
        if (wrap_ == Wrap::clamp || pass == 1) return;
        drift = second;
    }
}

void MapPieces::fill_breaks() {
    const bool repeat = wrap_ == Wrap::repeat;
    for (std::size_t i = repeat ? 0 : 1; i < pieces_.size(); ++i) {
        const Piece& before = pieces_[i > 0 ? i - 1 : pieces_.size() - 1];
        const double end = i > 0 ? pieces_[i].start : 1.0;
        const Vec3d reached = before.color + (end - before.start) * before.slope;
        const MapBreak found{pieces_[i].start, pieces_[i].color - reached,
                             pieces_[i].slope - before.slope};
        if (found.jump != Vec3d(0.0) || found.kink != Vec3d(0.0)) breaks_.push_back(found);
    }
}

const MapPieces::Piece& MapPieces::piece(double t) const {
    std::size_t i = 0;
    while (i + 1 < pieces_.size() && t >= pieces_[i + 1].start) ++i;
    return pieces_[i];
}

double MapPieces::index(double f) const {
    return wrap_ == Wrap::repeat ? map_index(wrap_, f) : f;
}

Vec3d MapPieces::extended(double f, double g) const {
    const double t = index(f);
    const Piece& p = piece(t);
    return mean_ + p.color + (t - p.start + (g - f)) * p.slope;
}

Vec3d MapPieces::first(double f) const {
    const double t = index(f);
    const Piece& p = piece(t);
    const double x = t - p.start;
    return p.first + x * (p.color + x / 2.0 * p.slope);
}

Vec3d MapPieces::second(double f) const {
    const double t = index(f);
    const Piece& p = piece(t);
    const double x = t - p.start;
    return p.second + x * (p.first + x * (p.color / 2.0 + x / 6.0 * p.slope));
}

BreakDistance::BreakDistance(const MapPieces& map) {
    const double most = map.breaks().empty() ? std::numeric_limits<float>::max() : 1.0;
    for (std::uint32_t i = 0; i <= entry_count; ++i) {
        const double low = double(i) / entry_count, high = double(i + 1) / entry_count;
        double nearest = most;
        for (const MapBreak& b : map.breaks())
            for (const double period : {-1.0, 0.0, 1.0}) {
                if (map.wrap() == Wrap::clamp && period != 0.0) continue;
                const double p = b.position + period;
                nearest = std::min(nearest, std::max({low - p, p - high, 0.0}));
            }
        // Rounded down, so that rounding never hides a break.
        distances_.push_back(float(nearest * (1.0 - 1e-6)));
    }
}

}  // namespace burl
