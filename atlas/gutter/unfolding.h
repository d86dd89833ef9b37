#pragma once
// Straight walks over a mesh (Polthier & Schmies, "Straightest geodesics on polyhedral surfaces",
// 1998): inside triangles a line, across an edge straight on in the plane into which the triangles
// on the way are unfolded. That plane carries the coordinates of a chart: a walk begins at the
// border of a chart's triangle, and leads to the triangle that the chart's map would show there if
// it went on across the border. A walk's point and its derivatives are those of the affine map that
// takes the unfolded triangle's places to its points, so frames need no turning of their own.
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "atlas/mesh/edge_neighbours.h"

namespace burl {

/// The ways on for a walk that meets an edge without a triangle beyond (open, or of more than two
/// triangles): it ends, or is mirrored there, as if a copy of the surface lay on its back.
enum class AtOpenEdge { end, mirror };

/// Triangles of one walk, where nothing else is said.
inline constexpr int longest_walk = 1 << 10;

/// A triangle that was walked into, and where its corners lie in the plane.
struct UnfoldedTriangle {
    std::uint32_t triangle = 0;
    std::array<Vec2d, 3> places{};  ///< in the order of the triangle's own corners
};

/// The end of a walk.
struct Walk {
    std::uint32_t tile = 0;  ///< the unfolded triangle in which it ended
    double share = 1.0;      ///< the part of the way that was walked, 0..1
    bool arrived = true;     ///< whether it was all of the way; else an edge ended it
};

/// The triangles that walks met, unfolded; each is unfolded once. Once there are `most`, walks end
/// where they would need another. The triangles, points and neighbours must outlive it.
class Unfolding {
  public:
    Unfolding(std::span<const Triangle> triangles, std::span<const Vec3d> positions,
              const EdgeNeighbours& neighbours, AtOpenEdge at_open_edge = AtOpenEdge::end,
              int longest = longest_walk,
              std::size_t most = std::numeric_limits<std::size_t>::max())
        : triangles_(triangles),
          positions_(positions),
          neighbours_(neighbours),
          at_open_edge_(at_open_edge),
          longest_(longest),
          most_(most) {}

    /// Makes a triangle walkable from: `places` are its corners in the plane, either way round;
    /// walks will leave it by its edge 3t+k. Returns its tile. If the triangle has no area here or
    /// there, walks end at the edge.
    std::uint32_t begin(std::uint32_t edge, const std::array<Vec2d, 3>& places);

    /// The straight walk from a place on the edge that `first`, a tile of begin(), was made for to
    /// another place in the plane, on the edge's outer side. A walk from the edge's end may also
    /// lead back at its side. Walks of more than `longest` triangles end there.
    Walk walk(std::uint32_t first, const Vec2d& from, const Vec2d& to);

    UnfoldedTriangle unfolded(std::uint32_t tile) const;
    /// The edge that a tile's walks left their first triangle by.
    std::uint32_t origin(std::uint32_t tile) const { return starts_[tiles_[tile].start].edge; }
    std::size_t size() const { return tiles_.size(); }

  private:
    static constexpr std::uint32_t unknown = 0xffffffffu, closed = 0xfffffffeu;

    /// An unfolded triangle as a walk sees it: it came in across the edge from corner `left` to
    /// corner `right`, and goes out to the right or to the left of the corner `apex`.
    struct Tile {
        std::uint32_t triangle = 0, start = 0;
        std::uint8_t left = 0, right = 0, apex = 0;  ///< numbers of corners
        Vec2d at_left{0.0}, at_right{0.0}, at_apex{0.0};
        std::array<std::uint32_t, 2> next{unknown, unknown};  ///< tiles on the right and the left
    };
    /// The metric of a first triangle: `turn` takes a vector of the plane to the vector that is as
    /// long on the surface, a quarter turn to the left.
    struct Start {
        std::uint32_t edge = 0;
        glm::dmat2 turn{0.0};
    };

    std::uint32_t beyond(std::uint32_t tile, bool left);
    std::uint32_t unfold(const Tile& from, bool left);

    std::span<const Triangle> triangles_;
    std::span<const Vec3d> positions_;
    const EdgeNeighbours& neighbours_;
    AtOpenEdge at_open_edge_;
    int longest_;
    std::size_t most_;
    std::vector<Tile> tiles_;
    std::vector<Start> starts_;
};

}  // namespace burl
