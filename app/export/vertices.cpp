// Vertices are numbered by first use, so the arrays follow the triangles and are deterministic.
// Corners can agree only where they meet at a point of the mesh, so points are handled
// independently.
#include "app/export/vertices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "app/surface/normals.h"
#include "app/surface/tangents.h"
#include "atlas/base/each_index.h"

namespace burl {
namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t grain = 4096;
// Up to this number all corners of a point are compared pairwise.
constexpr std::size_t few_corners = 24;

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value + 0.0f);
}  // -0 becomes 0

/// The frames of all triangle corners; tangents may be empty, the pose null.
struct CornerFrames {
    std::span<const Vec3f> normals;
    std::span<const Vec4f> tangents;
    const PosedCorners* posed;

    /// The corner's point in the pose; 0 without a pose.
    std::uint32_t point(std::size_t corner) const {
        return posed ? posed->points.triangles[corner / 3][corner % 3] : 0;
    }
};

/// The values in which corners at one point must agree: part, point of the pose, u, v, normal, the
/// tangent's w.
using Row = std::array<std::uint32_t, 8>;

std::array<float, 2> uv_of(const Atlas& atlas, std::size_t corner) {
    if (atlas.corners.empty()) return {};
    const Vec2d uv = atlas.corners[corner / 3][corner % 3] / atlas.extent();
    return {float(uv.x), float(uv.y)};
}

Row row_of(const Atlas& atlas, const CornerFrames& frames, std::span<const std::uint32_t> parts,
           std::size_t corner) {
    const Vec3f& n = frames.normals[corner];
    const float w = frames.tangents.empty() ? 1.0f : frames.tangents[corner].w;
    const auto [u, v] = uv_of(atlas, corner);
    return {parts[corner / 3], frames.point(corner),
            bits(u),           bits(v),
            bits(n.x),         bits(n.y),
            bits(n.z),         bits(w)};
}

/// Finds, for each corner at a point, the first that agrees with it.
class Agreement {
  public:
    template <class RowOf>
    void find(std::span<const std::uint32_t> corners, const RowOf& row_of,
              std::vector<std::uint32_t>& first) {
        if (corners.size() > few_corners) return find_many(corners, row_of, first);
        rows_.clear();
        for (const std::uint32_t corner : corners) {
            rows_.push_back(row_of(corner));
            const auto same = std::find(rows_.begin(), rows_.end(), rows_.back());
            first[corner] = corners[std::size_t(same - rows_.begin())];
        }
    }

  private:
    template <class RowOf>
    static void find_many(std::span<const std::uint32_t> corners, const RowOf& row_of,
                          std::vector<std::uint32_t>& first) {
        std::map<Row, std::uint32_t> known;
        for (const std::uint32_t corner : corners)
            first[corner] = known.try_emplace(row_of(corner), corner).first->second;
    }

    std::vector<Row> rows_;
};

std::vector<std::uint32_t> parts_of_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> parts(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        std::fill_n(parts.begin() + std::ptrdiff_t(mesh.parts[i].first_triangle),
                    mesh.parts[i].triangle_count, static_cast<std::uint32_t>(i));
    return parts;
}

/// Whether corners can agree only within a block: its corners are at least half a texel inside, so
/// that other blocks' corners have other texture coordinates.
bool parts_blocks(const Atlas& atlas) {
    return atlas.options.kind == AtlasKind::quad && atlas.options.overscan == Overscan::bilinear &&
           std::ranges::none_of(atlas.blocks, &Block::shares_texel);
}

/// Per corner the first of its block that is the same vertex.
std::vector<std::uint32_t> first_corners_of_blocks(const Mesh& mesh, const Atlas& atlas,
                                                   const CornerFrames& frames) {
    const std::vector<std::uint32_t> parts = parts_of_triangles(mesh);
    std::vector<std::uint32_t> first(3 * mesh.triangles.size());
    const auto point = [&](std::uint32_t corner) { return mesh.triangles[corner / 3][corner % 3]; };
    for_each_index(atlas.blocks.size(), [&](std::size_t i) {
        const Block& block = atlas.blocks[i];
        const auto lower = 3 * std::uint32_t(block.lower),
                   upper = block.upper < 0 ? lower : 3 * std::uint32_t(block.upper);
        std::array<std::uint32_t, 6> corners{};
        std::iota(corners.begin(), corners.begin() + 3, std::min(lower, upper));
        std::iota(corners.begin() + 3, corners.end(), std::max(lower, upper));
        std::array<Row, 6> rows;
        const std::size_t count = block.upper < 0 ? 3 : 6;
        for (std::size_t k = 0; k < count; ++k) {
            rows[k] = row_of(atlas, frames, parts, corners[k]);
            std::size_t same = 0;
            while (point(corners[same]) != point(corners[k]) || rows[same] != rows[k]) ++same;
            first[corners[k]] = corners[same];
        }
    });
    return first;
}

/// Per corner the first that is the same vertex.
std::vector<std::uint32_t> first_corners(const Mesh& mesh, const Atlas& atlas,
                                         const CornerFrames& frames) {
    if (parts_blocks(atlas)) return first_corners_of_blocks(mesh, atlas, frames);
    const CornersByPoint around(mesh);
    const std::vector<std::uint32_t> parts = parts_of_triangles(mesh);
    std::vector<std::uint32_t> first(3 * mesh.triangles.size());
    const auto row = [&](std::size_t corner) { return row_of(atlas, frames, parts, corner); };
    tbb::parallel_for(Range(0, around.points(), grain), [&](const Range& range) {
        Agreement agreement;
        for (std::size_t p = range.begin(); p < range.end(); ++p)
            agreement.find(around[p], row, first);
    });
    return first;
}

Box3 box_of(const Mesh& mesh, const Part& part) {
    const Vec3d& first = mesh.positions[mesh.triangles[part.first_triangle][0]];
    Box3 box{first, first};
    for (std::size_t t = 0; t < part.triangle_count; ++t) {
        for (const std::uint32_t p : mesh.triangles[part.first_triangle + t]) {
            box.low = glm::min(box.low, mesh.positions[p]);
            box.high = glm::max(box.high, mesh.positions[p]);
        }
    }
    return box;
}

/// A power of two that scales sizes outside float32's range to about one; 1 for all others.
double safe_scale(const Box3& box) {
    const Vec3d half = 0.5 * box.high - 0.5 * box.low;  // halved first, since sizes may overflow
    const double half_size = std::max({half.x, half.y, half.z});
    if (!(half_size > 0.0)) return 1.0;
    const int exponent = std::ilogb(half_size);
    return std::abs(exponent) <= 60 ? 1.0 : std::ldexp(1.0, exponent);
}

/// Numbers a part's vertices and replaces each corner's entry of `first` by its vertex number.
/// Returns the first corner of each vertex.
std::vector<std::uint32_t> number_vertices(const Part& part, std::vector<std::uint32_t>& first) {
    std::vector<std::uint32_t> corners;
    corners.reserve(part.triangle_count + part.triangle_count / 2);
    const std::size_t begin = 3 * std::size_t(part.first_triangle),
                      end = begin + 3 * std::size_t(part.triangle_count);
    for (std::size_t corner = begin; corner < end; ++corner) {
        if (first[corner] != corner) {
            first[corner] = first[first[corner]];
            continue;
        }
        first[corner] = static_cast<std::uint32_t>(corners.size());
        corners.push_back(static_cast<std::uint32_t>(corner));
    }
    return corners;
}

/// The inputs of export_vertices.
struct ExportCorners {
    const Mesh& mesh;
    const Atlas& atlas;
    CornerFrames frames;
    std::span<const std::uint32_t> blocks;  ///< per triangle the index of its block, or empty
};

void resize(PartVertices& out, std::size_t count, const ExportCorners& of) {
    out.positions.resize(count);
    out.normals.resize(count);
    if (!of.atlas.corners.empty()) out.uvs.resize(count);
    out.points.resize(count);
    if (!of.frames.tangents.empty()) out.tangents.resize(count);
    if (!of.blocks.empty()) out.blocks.resize(count);
    if (!of.frames.posed) return;
    out.target.positions.resize(count);
    out.target.normals.resize(count);
    out.target.tangents.resize(out.tangents.size());
}

/// Stores the change from vertex i, as rounded to float32, to its pose.
void fill_target(PartVertices& out, std::size_t i, std::size_t corner, const PosedCorners& posed) {
    const Vec3d& place = posed.points.positions[posed.points.triangles[corner / 3][corner % 3]];
    const Vec3d p = (place - out.centre) / out.scale;
    out.target.positions[i] = Vec3f(p - Vec3d(out.positions[i])) + 0.0f;
    out.target.normals[i] = posed.normals[corner] - out.normals[i] + 0.0f;
    if (!out.tangents.empty())
        out.target.tangents[i] = Vec3f(posed.tangents[corner]) - Vec3f(out.tangents[i]) + 0.0f;
}

/// Stores the attributes of vertex i, taken from its first corner.
void fill_vertex(PartVertices& out, std::size_t i, std::size_t corner, const ExportCorners& of) {
    const std::size_t t = corner / 3;
    const Vec3d& point = of.mesh.positions[of.mesh.triangles[t][corner % 3]];
    const auto [u, v] = uv_of(of.atlas, corner);
    out.positions[i] = Vec3f((point - out.centre) / out.scale) + 0.0f;
    out.normals[i] = of.frames.normals[corner] + 0.0f;
    if (!out.uvs.empty()) out.uvs[i] = {u + 0.0f, v + 0.0f};
    out.points[i] = of.mesh.triangles[t][corner % 3];
    // Corners that share a vertex share their tangent.
    if (!out.tangents.empty()) out.tangents[i] = of.frames.tangents[corner];
    // Blocks do not touch at corners, so a vertex has one.
    if (!out.blocks.empty()) out.blocks[i] = rectangle_of(of.atlas, of.atlas.blocks[of.blocks[t]]);
    if (of.frames.posed) fill_target(out, i, corner, *of.frames.posed);
}

/// The arrays of one part. `first` is that of first_corners(); the part's entries are overwritten.
PartVertices part_vertices(const ExportCorners& of, std::size_t index,
                           std::vector<std::uint32_t>& first) {
    const Part& part = of.mesh.parts[index];
    const Box3 box = box_of(of.mesh, part);
    PartVertices out;
    out.part = index;
    out.centre = box.centre();
    out.scale = safe_scale(box);
    const std::vector<std::uint32_t> corners = number_vertices(part, first);
    const auto begin = first.begin() + 3 * std::ptrdiff_t(part.first_triangle);
    out.indices.assign(begin, begin + 3 * std::ptrdiff_t(part.triangle_count));
    resize(out, corners.size(), of);
    for_each_index(corners.size(), [&](std::size_t i) { fill_vertex(out, i, corners[i], of); });
    return out;
}

/// Transforms the morph target: its changes are the differences of both ends as placed.
void place_target(const PartVertices& vertices, const Mat3d& linear,
                  const NormalTransform& normal_transform, PartVertices& out) {
    VertexTarget& target = out.target;
    for (std::size_t i = 0; i < target.positions.size(); ++i) {
        target.positions[i] = Vec3f(linear * Vec3d(target.positions[i])) + 0.0f;
        const Vec3f normal = normal_transform(vertices.normals[i] + target.normals[i]);
        target.normals[i] = normal - out.normals[i] + 0.0f;
        if (target.tangents.empty()) continue;
        const Vec3f tangent = Vec3f(vertices.tangents[i]) + target.tangents[i];
        const Vec4f moved = placed_tangent(Vec4f(tangent, 1.0f), normal, linear);
        target.tangents[i] = Vec3f(moved) - Vec3f(out.tangents[i]) + 0.0f;
    }
}

}  // namespace

std::vector<std::uint32_t> blocks_of_triangles(const Atlas& atlas) {
    std::vector<std::uint32_t> result;
    if (atlas.options.kind != AtlasKind::quad) return result;
    result.resize(atlas.corners.size());
    for (std::uint32_t b = 0; b < atlas.blocks.size(); ++b) {
        const Block& block = atlas.blocks[b];
        result[std::size_t(block.lower)] = b;
        if (block.upper >= 0) result[std::size_t(block.upper)] = b;
    }
    return result;
}

std::array<float, 4> rectangle_of(const Atlas& atlas, const Block& block) {
    const Vec2d size = atlas.extent(), low = Vec2d(block.x, block.y) / size,
                high = Vec2d(block.x + block.width, block.y + block.height) / size;
    return {float(low.x), float(low.y), float(high.x), float(high.y)};
}

std::vector<PartVertices> export_vertices(const Mesh& mesh, const Atlas& atlas,
                                          std::span<const Vec3f> normals,
                                          std::span<const Vec4f> tangents,
                                          const PosedCorners* posed) {
    std::vector<PartVertices> parts;
    const std::vector<std::uint32_t> blocks = blocks_of_triangles(atlas);
    const ExportCorners corners{mesh, atlas, {normals, tangents, posed}, blocks};
    std::vector<std::uint32_t> first = first_corners(mesh, atlas, corners.frames);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        if (mesh.parts[i].triangle_count > 0) parts.push_back(part_vertices(corners, i, first));
    }
    return parts;
}

Mat4d centred(const Mat4d& placement, const PartVertices& vertices) {
    Mat4d result = placement;
    result[3] = placement * Vec4d(vertices.centre, 1.0);
    for (int c = 0; c < 3; ++c) result[c] *= vertices.scale;
    return result;
}

PartVertices placed(const PartVertices& vertices, const Mat4d& placement) {
    PartVertices out = vertices;
    const Mat3d linear(placement);
    const NormalTransform normal_transform(placement);
    out.centre = Vec3d(placement * Vec4d(vertices.centre, 1.0));
    for (Vec3f& p : out.positions) p = Vec3f(linear * Vec3d(p)) + 0.0f;
    for (Vec3f& n : out.normals) n = normal_transform(n);
    for (std::size_t i = 0; i < out.tangents.size(); ++i)
        out.tangents[i] = placed_tangent(out.tangents[i], out.normals[i], linear);
    place_target(vertices, linear, normal_transform, out);
    for (std::size_t i = 0; normal_transform.mirrors() && i + 2 < out.indices.size(); i += 3) {
        std::swap(out.indices[i + 1], out.indices[i + 2]);
    }
    return out;
}

NodeTransform node_of_placed(const PartVertices& vertices) {
    NodeTransform place;
    place.translation = vertices.centre;
    place.scale = Vec3d(vertices.scale);
    return place;
}

}  // namespace burl
