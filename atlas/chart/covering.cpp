// A line sweeps the plane from one height of the borders' vertices to the next. Between two heights
// lies a strip that the same edges cross; their order along its lower end, its middle and its upper
// end tells how often the borders wind round the places between them.
#include "atlas/chart/covering.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burl {
namespace {

/// An edge of the border that is not level.
struct BorderEdge {
    Vec2d low{0.0}, high{0.0};  ///< the lower and the upper end
    int winding = 0;            ///< what crossing it from left to right adds
    double steepness = 0.0;     ///< sine of its angle with the line
    double x = 0.0;             ///< where the line meets it

    double at(double y) const {
        const double t = (y - low.y) / (high.y - low.y);
        return (1.0 - t) * low.x + t * high.x;
    }
};

/// The patch's border in the plane.
struct Border {
    std::vector<BorderEdge> edges;  ///< those that are not level, by their lower ends
    std::vector<double> heights;    ///< of the ends, ascending
    double length = 0.0;

    Border(const Patch& patch, std::span<const Vec2d> places) {
        for (const auto& loop : patch.loops)
            for (const HalfEdge h : loop) add(places[patch.start(h)], places[patch.end(h)]);
        std::ranges::sort(edges, {}, [](const BorderEdge& e) { return e.low.y; });
        std::ranges::sort(heights);
        const auto [first, last] = std::ranges::unique(heights);
        heights.erase(first, last);
    }

  private:
    void add(const Vec2d& from, const Vec2d& to) {
        const double own = glm::distance(from, to);
        length += own;
        heights.push_back(from.y);
        if (from.y == to.y) return;
        const bool down = to.y < from.y;  // the patch lies to the right of such an edge
        edges.push_back(
            {down ? to : from, down ? from : to, down ? 1 : -1, std::abs(to.y - from.y) / own});
    }
};

/// Sweeps a border, and finds what is covered twice.
class Sweep {
  public:
    Sweep(Border border, double depth) : border_(std::move(border)), depth_(depth) {}

    bool finds() {
        for (std::size_t i = 0; i + 1 < border_.heights.size(); ++i) {
            const double low = border_.heights[i], high = border_.heights[i + 1];
            change_edges(low);
            for (const double y : {low, 0.5 * (low + high), high}) {
                order(y);
                if (thickest(high - low) > depth_) return true;
                if (y != low && y != high) area_ += (high - low) * width();
            }
        }
        return area_ > depth_ * border_.length;
    }

  private:
    /// Makes the edges that lie above this height those on the line.
    void change_edges(double height) {
        std::erase_if(line_, [&](const BorderEdge& e) { return !(e.high.y > height); });
        for (; next_ < border_.edges.size() && border_.edges[next_].low.y <= height; ++next_)
            line_.push_back(border_.edges[next_]);
    }

    /// Orders the edges on the line; they nearly are in order, so that they are moved one by one.
    void order(double y) {
        for (BorderEdge& edge : line_) edge.x = edge.at(y);
        for (std::size_t i = 1; i < line_.size(); ++i)
            for (std::size_t k = i; k > 0 && line_[k].x < line_[k - 1].x; --k)
                std::swap(line_[k], line_[k - 1]);
    }

    /// Calls visit(left edge, right edge) for every piece of the line that is covered twice.
    template <class Visit>
    void visit_doubled(const Visit& visit) const {
        int winding = 0;
        const BorderEdge* left = nullptr;
        for (const BorderEdge& edge : line_) {
            winding += edge.winding;
            if (winding >= 2 && !left) left = &edge;
            if (winding >= 2 || !left) continue;
            visit(*left, edge);
            left = nullptr;
        }
    }

    /// Thickness of the thickest such piece, in a strip of this height.
    double thickest(double height) const {
        double most = 0.0;
        visit_doubled([&](const BorderEdge& a, const BorderEdge& b) {
            const double across = (b.x - a.x) * std::min(a.steepness, b.steepness);
            most = std::max(most, std::min(across, height));
        });
        return most;
    }

    /// Length of all such pieces.
    double width() const {
        double sum = 0.0;
        visit_doubled([&](const BorderEdge& a, const BorderEdge& b) { sum += b.x - a.x; });
        return sum;
    }

    Border border_;
    double depth_;
    std::vector<BorderEdge> line_;
    std::size_t next_ = 0;
    double area_ = 0.0;
};

}  // namespace

bool covers_twice(const Patch& patch, std::span<const Vec2d> places, double depth) {
    return Sweep(Border(patch, places), depth).finds();
}

}  // namespace burl
