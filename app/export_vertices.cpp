// Vertices are numbered by first use, so the arrays follow the triangles and are deterministic.
#include "app/export_vertices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "app/unique_rows.h"

namespace burl {
namespace {

using Vertices = UniqueRows<7>;  // point, u, v, normal, w of the tangent

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value + 0.0f);
}  // -0 -> 0

/// Per triangle corner; the tangents may be empty.
struct CornerFrames {
    std::span<const Vec3f> normals;
    std::span<const Vec4f> tangents;
};

Vertices::Row vertex_row(const Mesh& mesh, const Atlas& atlas, const CornerFrames& frames,
                         std::size_t t, std::size_t k) {
    const Vec3f& n = frames.normals[3 * t + k];
    const float w = frames.tangents.empty() ? 1.0f : frames.tangents[3 * t + k].w;
    const Vec2d uv = atlas.corners[t][k] / atlas.extent();
    return {mesh.triangles[t][k],
            bits(float(uv.x)),
            bits(float(uv.y)),
            bits(n.x),
            bits(n.y),
            bits(n.z),
            bits(w)};
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

/// Power of two that brings sizes float32 cannot work with to about one.
double safe_scale(const Box3& box) {
    const Vec3d half = 0.5 * box.high - 0.5 * box.low;  // halved first: sizes may overflow
    const double half_size = std::max({half.x, half.y, half.z});
    if (!(half_size > 0.0)) return 1.0;
    const int exponent = std::ilogb(half_size);
    return std::abs(exponent) <= 60 ? 1.0 : std::ldexp(1.0, exponent);
}

/// Per triangle the number of its block; only of quad atlases.
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

void unpack(const Mesh& mesh, const std::vector<Vertices::Row>& rows, PartVertices& out) {
    out.positions.reserve(rows.size());
    out.uvs.reserve(rows.size());
    out.normals.reserve(rows.size());
    for (const Vertices::Row& row : rows) {
        const Vec3d p = (mesh.positions[row[0]] - out.centre) / out.scale;
        out.positions.push_back(Vec3f(p) + 0.0f);
        out.uvs.push_back({std::bit_cast<float>(row[1]), std::bit_cast<float>(row[2])});
        out.normals.push_back({std::bit_cast<float>(row[3]), std::bit_cast<float>(row[4]),
                               std::bit_cast<float>(row[5])});
    }
}

PartVertices part_vertices(const Mesh& mesh, const Atlas& atlas, const CornerFrames& frames,
                           std::span<const std::uint32_t> blocks, std::size_t index) {
    const Part& part = mesh.parts[index];
    const Box3 box = box_of(mesh, part);
    PartVertices out;
    out.part = index;
    out.centre = box.centre();
    out.scale = safe_scale(box);
    Vertices vertices(part.triangle_count);
    std::vector<std::uint32_t> block_of_vertex;
    out.indices.reserve(3 * std::size_t(part.triangle_count));
    for (std::size_t i = 0; i < part.triangle_count; ++i) {
        const std::size_t t = part.first_triangle + i;
        for (std::size_t k = 0; k < 3; ++k) {
            out.indices.push_back(vertices.insert(vertex_row(mesh, atlas, frames, t, k)));
            // Corners that share a vertex share their tangent.
            if (!frames.tangents.empty() && out.tangents.size() < vertices.rows().size())
                out.tangents.push_back(frames.tangents[3 * t + k]);
            // Blocks do not touch at corners, so a vertex has one.
            if (!blocks.empty() && block_of_vertex.size() < vertices.rows().size())
                block_of_vertex.push_back(blocks[t]);
        }
    }
    unpack(mesh, std::move(vertices).take_rows(), out);
    out.blocks.reserve(block_of_vertex.size());
    for (const std::uint32_t block : block_of_vertex)
        out.blocks.push_back(rectangle_of(atlas, atlas.blocks[block]));
    return out;
}

}  // namespace

std::vector<PartVertices> export_vertices(const Mesh& mesh, const Atlas& atlas,
                                          std::span<const Vec3f> normals,
                                          std::span<const Vec4f> tangents) {
    std::vector<PartVertices> parts;
    const std::vector<std::uint32_t> blocks = blocks_of_triangles(atlas);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        if (mesh.parts[i].triangle_count > 0) {
            parts.push_back(part_vertices(mesh, atlas, {normals, tangents}, blocks, i));
        }
    }
    return parts;
}

}  // namespace burl
