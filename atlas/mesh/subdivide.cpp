#include "atlas/mesh/subdivide.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "atlas/base/error.h"

namespace burl {

namespace {

/// The corners 0 to 2 of a triangle whose mean a corner of a child is; equal for the triangle's
/// own.
using Mean = std::array<std::size_t, 2>;

constexpr std::array<std::array<Mean, 3>, 4> children{{{{{0, 0}, {0, 1}, {2, 0}}},
                                                       {{{0, 1}, {1, 1}, {1, 2}}},
                                                       {{{2, 0}, {1, 2}, {2, 2}}},
                                                       {{{0, 1}, {1, 2}, {2, 0}}}}};

/// Numbers the points of the finer mesh by their first use.
class FinerPoints {
  public:
    explicit FinerPoints(const std::vector<Vec3d>& coarse) : coarse_(coarse) {}

    std::uint32_t between(std::uint32_t a, std::uint32_t b) {
        const std::uint64_t key = std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
        const auto [found, is_new] = numbers_.try_emplace(key, std::uint32_t(positions.size()));
        if (is_new) positions.push_back(a == b ? coarse_[a] : 0.5 * coarse_[a] + 0.5 * coarse_[b]);
        return found->second;
    }

    std::vector<Vec3d> positions;

  private:
    const std::vector<Vec3d>& coarse_;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

/// The attribute of all corners of the finer mesh, by `mean` of two corners.
template <class T, class Function>
void refine(std::vector<T>& values, const Function& mean) {
    std::vector<T> finer;
    finer.reserve(4 * values.size());
    for (std::size_t t = 0; 3 * t < values.size(); ++t)
        for (const auto& child : children)
            for (const auto& [a, b] : child)
                finer.push_back(a == b ? values[3 * t + a] : mean(3 * t + a, 3 * t + b));
    values = std::move(finer);
}

/// A skin's joints and their weights at a corner.
struct Binding {
    std::array<std::uint16_t, 4> joints{};
    Vec4f weights{0.0f};
};

Binding mean_binding(const CornerAttributes& corners, std::size_t a, std::size_t b) {
    std::vector<std::pair<float, std::uint16_t>> shares;
    for (const std::size_t corner : {a, b})
        for (int i = 0; i < 4; ++i) {
            const std::uint16_t joint = corners.joints[corner][std::size_t(i)];
            const auto same = std::ranges::find(shares, joint, [](auto& s) { return s.second; });
            if (same == shares.end())
                shares.emplace_back(corners.weights[corner][i], joint);
            else
                same->first += corners.weights[corner][i];
        }
    std::ranges::stable_sort(shares, std::greater(), [](auto& share) { return share.first; });
    Binding binding;
    float sum = 0.0f;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, shares.size()); ++i)
        sum += shares[i].first;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, shares.size()) && sum > 0.0f; ++i) {
        binding.joints[i] = shares[i].second;
        binding.weights[int(i)] = shares[i].first / sum;
    }
    return binding;
}

void refine_skin(CornerAttributes& corners) {
    if (corners.joints.empty()) return;
    std::vector<std::array<std::uint16_t, 4>> joints = corners.joints;
    std::vector<Vec4f> weights = corners.weights;
    refine(joints,
           [&](std::size_t a, std::size_t b) { return mean_binding(corners, a, b).joints; });
    refine(weights,
           [&](std::size_t a, std::size_t b) { return mean_binding(corners, a, b).weights; });
    corners.joints = std::move(joints);
    corners.weights = std::move(weights);
}

void refine_attributes(CornerAttributes& corners) {
    refine_skin(corners);
    const auto half = [](const auto& values) {
        return [&values](std::size_t a, std::size_t b) {
            return (values[a] + values[b]) *
                   typename std::decay_t<decltype(values[a])>::value_type(0.5);
        };
    };
    const auto& normals = corners.normals;
    refine(corners.normals, [&](std::size_t a, std::size_t b) {
        const Vec3f sum = normals[a] + normals[b];
        const float length = glm::length(sum);
        return length > 0.0f ? sum / length : normals[a];
    });
    refine(corners.colors, half(corners.colors));
    refine(corners.uvs, half(corners.uvs));
}

void split(Mesh& mesh) {
    FinerPoints points(mesh.positions);
    std::vector<Triangle> triangles;
    triangles.reserve(4 * mesh.triangles.size());
    std::vector<std::uint32_t> faces;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const auto& child : children) {
            Triangle& finer = triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k)
                finer[k] =
                    points.between(mesh.triangles[t][child[k][0]], mesh.triangles[t][child[k][1]]);
            if (!mesh.source_faces.empty()) faces.push_back(mesh.source_faces[t]);
        }
    refine_attributes(mesh.corners);
    mesh.positions = std::move(points.positions);
    mesh.triangles = std::move(triangles);
    mesh.source_faces = std::move(faces);
    for (Part& part : mesh.parts) part.first_triangle *= 4, part.triangle_count *= 4;
}

}  // namespace

Mesh subdivided(Mesh mesh, int times, std::uint64_t most) {
    if (times > 0 && (mesh.triangles.size() << (2 * times)) > most)
        throw Error(
            ExitCode::unsupported,
            fmt::format("{} triangles split in four {} times are more than {} (--max-triangles); "
                        "split them less often",
                        mesh.triangles.size(), times, most));
    for (int i = 0; i < times; ++i) split(mesh);
    return mesh;
}

}  // namespace burl
