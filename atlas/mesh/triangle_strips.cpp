// Half-edge 3t+k is the edge of triangle t from its corner k to the next.
#include "atlas/mesh/triangle_strips.h"

#include <algorithm>
#include <array>

namespace burl {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

std::uint32_t next_of(std::uint32_t half) {
    return half % 3 == 2 ? half - 2 : half + 1;
}

bool is_degenerate(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Half-edges by the lower of their two vertices.
class HalfEdges {
  public:
    explicit HalfEdges(std::span<const Triangle> triangles)
        : triangles_(triangles), opposites_(3 * triangles.size(), none) {}

    /// Per half-edge one that runs back between the same vertices, or none. Where more than two
    /// triangles meet, each has at most one such partner.
    std::vector<std::uint32_t> opposites() {
        sort_by_lower_vertex();
        for (std::size_t v = 0; v + 1 < begins_.size(); ++v)
            pair_up({halves_.data() + begins_[v], halves_.data() + begins_[v + 1]});
        return std::move(opposites_);
    }

  private:
    std::uint32_t from(std::uint32_t half) const { return triangles_[half / 3][half % 3]; }
    std::uint32_t to(std::uint32_t half) const { return from(next_of(half)); }
    bool runs_up(std::uint32_t half) const { return from(half) < to(half); }

    template <class Use>
    void for_each_half(const Use& use) const {
        for (std::uint32_t half = 0; half < opposites_.size(); ++half)
            if (!is_degenerate(triangles_[half / 3])) use(half, std::min(from(half), to(half)));
    }

    void sort_by_lower_vertex() {
        std::uint32_t highest = 0;
        for (const Triangle& t : triangles_) highest = std::max(highest, std::ranges::max(t));
        begins_.assign(std::size_t(highest) + 2, 0);
        for_each_half([&](std::uint32_t, std::uint32_t low) { ++begins_[low + 1]; });
        for (std::size_t v = 1; v < begins_.size(); ++v) begins_[v] += begins_[v - 1];
        halves_.resize(begins_.back());
        std::vector<std::size_t> place(begins_.begin(), begins_.end() - 1);
        for_each_half([&](std::uint32_t half, std::uint32_t low) { halves_[place[low]++] = half; });
    }

    /// Pairs half-edges that have their lower vertex in common.
    void pair_up(std::span<std::uint32_t> halves) {
        const auto high = [&](std::uint32_t half) { return std::max(from(half), to(half)); };
        std::ranges::sort(halves, [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(high(a), a) < std::pair(high(b), b);
        });
        for (std::size_t begin = 0, end = 0; begin < halves.size(); begin = end) {
            while (end < halves.size() && high(halves[end]) == high(halves[begin])) ++end;
            std::size_t up = begin, down = begin;
            for (;; ++up, ++down) {
                while (up < end && !runs_up(halves[up])) ++up;
                while (down < end && runs_up(halves[down])) ++down;
                if (up == end || down == end) break;
                opposites_[halves[up]] = halves[down];
                opposites_[halves[down]] = halves[up];
            }
        }
    }

    std::span<const Triangle> triangles_;
    std::vector<std::uint32_t> opposites_, halves_;
    std::vector<std::size_t> begins_;  ///< per vertex the first of its half-edges in halves_
};

class Stripper {
  public:
    explicit Stripper(std::span<const Triangle> triangles)
        : triangles_(triangles),
          opposites_(HalfEdges(triangles).opposites()),
          marks_(triangles.size(), 0),
          free_neighbours_(triangles.size(), 0) {}

    TriangleStrips run() {
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (is_degenerate(triangles_[t])) {
                marks_[t] = in_strip;
                ++strips_.left_out;
                continue;
            }
            for (const std::uint32_t k : {0u, 1u, 2u})
                free_neighbours_[t] += opposites_[3 * t + k] != none;
            waiting_[free_neighbours_[t]].triangles.push_back(t);
        }
        for (std::uint32_t t = next_start(); t != none; t = next_start()) add_strip(t);
        count_border_loops();
        return std::move(strips_);
    }

  private:
    /// A strip that may come to be.
    struct Walk {
        std::vector<std::uint32_t> vertices{}, triangles{};
    };
    /// Triangles that had so many free neighbours when they were put here.
    struct Queue {
        std::vector<std::uint32_t> triangles{};
        std::size_t next = 0;
    };
    static constexpr std::uint32_t in_strip = 0xffffffffu;

    /// A free triangle with the fewest free neighbours, or none.
    std::uint32_t next_start() {
        for (std::uint32_t count = 0; count < waiting_.size(); ++count)
            for (Queue& queue = waiting_[count]; queue.next < queue.triangles.size();) {
                const std::uint32_t t = queue.triangles[queue.next++];
                if (marks_[t] != in_strip && free_neighbours_[t] == count) return t;
            }
        return none;
    }

    /// The half-edge across `half`, if its triangle is in neither a strip nor the walk.
    std::uint32_t free_across(std::uint32_t half) const {
        const std::uint32_t other = opposites_[half];
        if (other == none || marks_[other / 3] == in_strip || marks_[other / 3] == walk_number_)
            return none;
        return other;
    }

    /// Walks from a triangle whose half-edge `entered` comes first.
    void walk_from(std::uint32_t entered, Walk& walk) {
        ++walk_number_;
        const Triangle& first = triangles_[entered / 3];
        walk.vertices = {first[entered % 3], first[next_of(entered) % 3]};
        walk.triangles.clear();
        for (bool odd = false; entered != none;) {
            marks_[entered / 3] = walk_number_;
            walk.triangles.push_back(entered / 3);
            const std::uint32_t second = next_of(entered), third = next_of(second);
            const std::uint32_t straight = free_across(odd ? third : second);
            const std::uint32_t turned = free_across(odd ? second : third);
            const bool turns = straight == none && turned != none;
            if (turns) walk.vertices.push_back(walk.vertices[walk.vertices.size() - 2]);
            walk.vertices.push_back(triangles_[entered / 3][third % 3]);
            if (!turns) odd = !odd;
            entered = turns ? turned : straight;
        }
    }

    void add_strip(std::uint32_t start) {
        walk_from(3 * start, best_);
        for (const std::uint32_t k : {1u, 2u}) {
            walk_from(3 * start + k, other_);
            const auto gain = [](const Walk& walk) {
                return 3 * std::ptrdiff_t(walk.triangles.size()) -
                       std::ptrdiff_t(walk.vertices.size());
            };
            if (gain(other_) > gain(best_)) std::swap(best_, other_);
        }
        for (const std::uint32_t t : best_.triangles) marks_[t] = in_strip;
        for (const std::uint32_t t : best_.triangles)
            for (const std::uint32_t k : {0u, 1u, 2u}) leave_neighbour(opposites_[3 * t + k]);
        strips_.vertices.insert(strips_.vertices.end(), best_.vertices.begin(),
                                best_.vertices.end());
        strips_.ends.push_back(strips_.vertices.size());
    }

    void leave_neighbour(std::uint32_t half) {
        if (half == none || marks_[half / 3] == in_strip) return;
        waiting_[--free_neighbours_[half / 3]].triangles.push_back(half / 3);
    }

    /// Follows each border: after a border's edge comes the one that the triangles around its end
    /// vertex lead to.
    void count_border_loops() {
        std::vector<bool> seen(opposites_.size(), false);
        for (std::uint32_t begin = 0; begin < opposites_.size(); ++begin) {
            if (opposites_[begin] != none || seen[begin] || is_degenerate(triangles_[begin / 3]))
                continue;
            ++strips_.border_loops;
            for (std::uint32_t half = begin; !seen[half];) {
                seen[half] = true;
                half = next_of(half);
                while (opposites_[half] != none) half = next_of(opposites_[half]);
            }
        }
    }

    std::span<const Triangle> triangles_;
    std::vector<std::uint32_t> opposites_;
    std::vector<std::uint32_t> marks_;  ///< per triangle the last walk through it, or in_strip
    std::vector<std::uint32_t> free_neighbours_;
    std::array<Queue, 4> waiting_{};
    std::uint32_t walk_number_ = 0;
    Walk best_{}, other_{};
    TriangleStrips strips_{};
};

}  // namespace

TriangleStrips triangle_strips(std::span<const Triangle> triangles) {
    return Stripper(triangles).run();
}

std::vector<std::uint32_t> joined(const TriangleStrips& strips) {
    std::vector<std::uint32_t> all;
    std::size_t begin = 0;
    for (const std::size_t end : strips.ends) {
        if (begin > 0) {
            all.insert(all.end(), {all.back(), strips.vertices[begin]});
            if (all.size() % 2 == 1) all.push_back(strips.vertices[begin]);
        }
        all.insert(all.end(), strips.vertices.begin() + std::ptrdiff_t(begin),
                   strips.vertices.begin() + std::ptrdiff_t(end));
        begin = end;
    }
    return all;
}

void StripCounts::add(const TriangleStrips& added, std::size_t of_triangles, std::size_t written) {
    triangles += of_triangles - added.left_out;
    strips += added.ends.size();
    indices += written;
    border_loops += added.border_loops;
    left_out += added.left_out;
}

}  // namespace burl
