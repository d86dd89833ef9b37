// Corners of pieces: a piece's corner is a corner of the mesh triangle or the middle of two of its
// corners, as the vertex's origin says.
#include "atlas/patch/refine.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace burl {
namespace {

/// Two corners i and j (0..2) of a triangle, half-way between which a vertex lies; i == j at a
/// corner.
struct CornerPair {
    std::size_t i = 0, j = 0;
};

CornerPair corners_of(const Triangle& triangle, const VertexOrigin& origin) {
    CornerPair pair;
    for (std::size_t k = 0; k < 3; ++k) {
        if (triangle[k] == origin.a) pair.i = k;
        if (triangle[k] == origin.b) pair.j = k;
    }
    return pair;
}

/// Appends one corner's attributes, the mean of two corners of `from`.
void append_corner(const CornerAttributes& from, std::size_t i, std::size_t j,
                   CornerAttributes& to) {
    if (!from.normals.empty()) {
        const Vec3f sum = from.normals[i] + from.normals[j];
        const float length = glm::length(sum);
        to.normals.push_back(i != j && length > 0.0f ? sum / length : from.normals[i]);
    }
    if (!from.colors.empty()) to.colors.push_back(0.5f * (from.colors[i] + from.colors[j]));
    if (!from.uvs.empty()) to.uvs.push_back(0.5 * from.uvs[i] + 0.5 * from.uvs[j]);
}

/// Appends one corner's joints and weights: of the up to eight joints of two corners the four with
/// most weight, their sum made 1 again.
void append_bones(const CornerAttributes& from, std::size_t i, std::size_t j,
                  CornerAttributes& to) {
    if (from.joints.empty() || from.weights.empty()) return;
    if (i == j) {
        to.joints.push_back(from.joints[i]);
        to.weights.push_back(from.weights[i]);
        return;
    }
    std::map<std::uint16_t, float> sum;
    for (const std::size_t c : {i, j})
        for (int k = 0; k < 4; ++k)
            sum[from.joints[c][std::size_t(k)]] += 0.5f * from.weights[c][k];
    std::vector<std::pair<float, std::uint16_t>> order;
    for (const auto& [joint, weight] : sum) order.emplace_back(-weight, joint);
    std::sort(order.begin(), order.end());
    order.resize(4, {0.0f, std::uint16_t(0)});
    std::array<std::uint16_t, 4> joints{};
    Vec4f weights(0.0f);
    for (int k = 0; k < 4; ++k) {
        joints[std::size_t(k)] = order[std::size_t(k)].second;
        weights[k] = -order[std::size_t(k)].first;
    }
    const float total = weights.x + weights.y + weights.z + weights.w;
    to.joints.push_back(joints);
    to.weights.push_back(total > 0.0f ? weights / total : weights);
}

/// Number of a patch and of a triangle in it.
struct PatchPiece {
    std::uint32_t patch = 0, triangle = 0;
};

/// The pieces of every triangle of the mesh, ordered by patch and number.
class PiecesOfFaces {
  public:
    PiecesOfFaces(std::size_t faces, const PatchMaps& maps) : begin_(faces + 1, 0) {
        for_each(maps, [&](std::uint32_t face, const PatchPiece&) { ++begin_[face]; });
        std::uint32_t sum = 0;
        for (std::uint32_t& count : begin_) sum += std::exchange(count, sum);
        pieces_.resize(sum);
        for_each(maps, [&](std::uint32_t face, const PatchPiece& piece) {
            pieces_[begin_[face]++] = piece;
        });
    }

    /// The pieces of a face. The constructor's filling moved begin_[face] on to the face's end.
    std::span<const PatchPiece> of(std::uint32_t face) const {
        const std::uint32_t begin = face == 0 ? 0 : begin_[face - 1];
        return {pieces_.data() + begin, begin_[face] - begin};
    }

  private:
    template <class Visit>
    static void for_each(const PatchMaps& maps, const Visit& visit) {
        for (std::uint32_t p = 0; p < maps.patches.size(); ++p) {
            const std::vector<std::uint32_t>& faces = maps.patches[p].patch.faces;
            for (std::uint32_t t = 0; t < faces.size(); ++t)
                if (faces[t] != not_in_mesh) visit(faces[t], PatchPiece{p, t});
        }
    }

    std::vector<std::uint32_t> begin_;
    std::vector<PatchPiece> pieces_;
};

/// Appends the pieces of all triangles to a new mesh.
class Refiner {
  public:
    Refiner(const Mesh& mesh, const PatchMaps& maps)
        : mesh_(mesh), maps_(maps), pieces_of_(mesh.triangles.size(), maps) {
        Mesh& refined = result_.refined.mesh;
        refined.name = mesh.name;
        refined.positions = mesh.positions;
        refined.parts = mesh.parts;
        refined.notes = mesh.notes;
        std::size_t count = 0;
        for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face)
            count += std::max<std::size_t>(pieces_of_.of(face).size(), 1);
        refined.triangles.reserve(count);
        if (!mesh.source_faces.empty()) refined.source_faces.reserve(count);
        result_.patch.reserve(count);
        result_.in_patch.reserve(count);
    }

    Refinement run() {
        Mesh& refined = result_.refined.mesh;
        std::vector<std::uint32_t> first(mesh_.triangles.size() + 1, 0);
        for (std::uint32_t face = 0; face < mesh_.triangles.size(); ++face) {
            first[face] = static_cast<std::uint32_t>(refined.triangles.size());
            const std::span<const PatchPiece> pieces = pieces_of_.of(face);
            if (pieces.empty())
                append(face, mesh_.triangles[face], {{{0, 0}, {1, 1}, {2, 2}}}, {not_in_mesh, 0});
            for (const PatchPiece& piece : pieces) append_piece(face, piece);
            if (pieces.size() > 1)
                result_.refined.cut_faces.push_back({face, std::uint32_t(pieces.size())});
        }
        first.back() = static_cast<std::uint32_t>(refined.triangles.size());
        refined.positions.shrink_to_fit();  // a few more points may have doubled the capacity
        for (Part& part : refined.parts) {
            const std::uint32_t end = part.first_triangle + part.triangle_count;
            part.first_triangle = first[part.first_triangle];
            part.triangle_count = first[end] - part.first_triangle;
        }
        return std::move(result_);
    }

  private:
    void append_piece(std::uint32_t face, const PatchPiece& piece) {
        const Patch& patch = maps_.patches[piece.patch].patch;
        Triangle triangle{};
        std::array<CornerPair, 3> pairs;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = patch.triangles[piece.triangle][k];
            triangle[k] = point(piece.patch, vertex, patch);
            pairs[k] = corners_of(mesh_.triangles[face], patch.origins[vertex]);
        }
        append(face, triangle, pairs, piece);
    }

    std::uint32_t point(std::uint32_t p, std::uint32_t vertex, const Patch& patch) {
        const VertexOrigin& origin = patch.origins[vertex];
        if (origin.a == origin.b) return origin.a;
        std::vector<Vec3d>& positions = result_.refined.mesh.positions;
        const auto next = static_cast<std::uint32_t>(positions.size());
        const auto [place, fresh] = extra_.emplace(std::pair(p, vertex), next);
        if (fresh) {
            positions.push_back(patch.points[vertex]);
            result_.refined.extra_points.push_back(origin);
        }
        return place->second;
    }

    void append(std::uint32_t face, const Triangle& triangle,
                const std::array<CornerPair, 3>& pairs, const PatchPiece& piece) {
        Mesh& mesh = result_.refined.mesh;
        mesh.triangles.push_back(triangle);
        if (!mesh_.source_faces.empty()) mesh.source_faces.push_back(mesh_.source_faces[face]);
        const std::size_t base = 3 * std::size_t{face};
        for (const CornerPair& pair : pairs) {
            append_corner(mesh_.corners, base + pair.i, base + pair.j, mesh.corners);
            append_bones(mesh_.corners, base + pair.i, base + pair.j, mesh.corners);
        }
        result_.patch.push_back(piece.patch);
        result_.in_patch.push_back(piece.triangle);
    }

    const Mesh& mesh_;
    const PatchMaps& maps_;
    PiecesOfFaces pieces_of_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> extra_;
    Refinement result_;
};

}  // namespace

Refinement refine_mesh(const Mesh& mesh, const PatchMaps& maps) {
    return Refiner(mesh, maps).run();
}

}  // namespace burl
