#pragma once
// Vertices of a carved primitive: the file's own, in their order, and behind them those that a
// chart border, a normal or a cut edge needs besides.
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace burl {

/// A vertex of the file, or the middle between two of them (a < b), and the values by which corners
/// differ there that share it.
struct KeptVertex {
    std::uint32_t a = 0, b = 0;
    std::size_t corner = 0;  ///< a corner of the carved mesh that has the vertex
};

/// Bits of the values in which corners must agree to share a vertex: u, v, normal, tangent's w.
using CornerBits = std::array<std::uint32_t, 6>;

/// Gives each corner its vertex. Vertex i below the file's number of vertices is the file's vertex
/// i, with the values of the first corner that asks for it, so that what the file says of vertices
/// stays true.
class KeptVertices {
  public:
    /// `count` is the number of the file's vertices.
    explicit KeptVertices(std::size_t count);

    /// The vertex of a corner at the file's vertices a and b (equal: at that vertex).
    std::uint32_t of(std::uint32_t a, std::uint32_t b, const CornerBits& bits, std::size_t corner);

    /// All vertices, the file's first; those that no corner has asked for have corner no_corner.
    const std::vector<KeptVertex>& all() const { return vertices_; }
    bool adds_any() const { return vertices_.size() > file_count_; }

    static constexpr std::size_t no_corner = ~std::size_t{0};

  private:
    std::size_t file_count_;
    std::vector<KeptVertex> vertices_;
    std::vector<CornerBits> bits_;
    std::vector<std::uint32_t> next_;  ///< the next vertex at the same place, or no_vertex
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;  ///< first vertex of (a, b)
};

}  // namespace burl
