// Faces are grouped by the edges around each point: two faces there that share a second point meet
// at that edge. Linear in the number of corners except for the sort of each point's edges.
#include "app/surface/normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "atlas/base/each_index.h"

namespace burl {

// A counting sort: filling a row moves its entry of `begin` on to the row's end.
CornersByPoint::CornersByPoint(const Mesh& mesh)
    : begin_(mesh.positions.size() + 2), corners_(3 * mesh.triangles.size()) {
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) ++begin_[p + 2];
    for (std::size_t p = 2; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
    std::uint32_t corner = 0;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) corners_[begin_[p + 1]++] = corner++;
    begin_.pop_back();
}

Vec3d unit_or_zero(const Vec3d& v) {
    const double longest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(longest > 0.0) || !std::isfinite(longest)) return Vec3d(0.0);
    return glm::normalize(v / longest);
}

double angle_between(const Vec3d& u, const Vec3d& v) {
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

double corner_angle(std::span<const Vec3d> p, const Triangle& t, std::size_t k) {
    return angle_between(unit_or_zero(p[t[(k + 1) % 3]] - p[t[k]]),
                         unit_or_zero(p[t[(k + 2) % 3]] - p[t[k]]));
}

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t grain = 4096;
constexpr Vec3f fallback_normal{0.0f, 0.0f, 1.0f};
constexpr std::size_t fan_window = 16;  // faces compared along one non-manifold edge
// The least height of a triangle, relative to its longest coordinate difference, that has a
// reliable normal: about float32's resolution.
constexpr double flat_height = 1e-7;

bool is_zero(const Vec3d& v) {
    return v == Vec3d(0.0);
}

/// The face's unit normal, or zero where the face is degenerate.
Vec3d face_normal(const Mesh& mesh, const Triangle& t) {
    const auto& p = mesh.positions;
    const Vec3d u = p[t[1]] - p[t[0]], v = p[t[2]] - p[t[0]], w = p[t[2]] - p[t[1]];
    double longest = 0.0;
    for (const Vec3d& e : {u, v, w}) {
        longest = std::max({longest, std::abs(e.x), std::abs(e.y), std::abs(e.z)});
    }
    if (!(longest > 0.0) || !std::isfinite(longest)) return Vec3d(0.0);
    const Vec3d cross = glm::cross(u / longest, v / longest);
    return glm::length(cross) > flat_height ? glm::normalize(cross) : Vec3d(0.0);
}

/// The faces around one point, grouped into smooth fans by union-find. The buffers are reused from
/// point to point.
class Fans {
  public:
    Fans(const Mesh& mesh, const std::vector<Vec3d>& face_normals, double crease_degrees)
        : mesh_(mesh),
          face_normals_(face_normals),
          smooth_cosine_(std::cos(glm::radians(std::clamp(crease_degrees, 0.0, 180.0)))) {}

    /// Writes the normals of all corners of one point; corners without any usable face stay zero.
    void compute(std::span<const std::uint32_t> corners, std::vector<Vec3f>& normals) {
        corners_ = corners;
        parent_.resize(corners.size());
        std::iota(parent_.begin(), parent_.end(), std::size_t(0));
        neighbour_.assign(corners.size(), none);
        collect_edges();
        join_along_edges();
        write(normals);
    }

  private:
    static constexpr std::size_t none = std::size_t(-1);
    struct Edge {
        std::uint32_t other;  // the edge's other point
        std::size_t local;    // an index into corners_
    };

    const Vec3d& normal(std::size_t local) const { return face_normals_[corners_[local] / 3]; }

    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void collect_edges() {
        edges_.clear();
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Triangle& t = mesh_.triangles[corners_[i] / 3];
            const std::size_t k = corners_[i] % 3;
            for (const std::uint32_t other : {t[(k + 1) % 3], t[(k + 2) % 3]}) {
                if (other != t[k]) edges_.push_back({other, i});
            }
        }
        std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
            return a.other != b.other ? a.other < b.other : a.local < b.local;
        });
    }

    void join_along_edges() {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const std::size_t end = std::min(edges_.size(), i + fan_window);
            for (std::size_t j = i + 1; j < end && edges_[j].other == edges_[i].other; ++j) {
                meet(edges_[i].local, edges_[j].local);
            }
        }
    }

    /// Joins two faces that share an edge where the edge is smooth. A degenerate face is skipped:
    /// its two neighbours count as neighbours of each other.
    void meet(std::size_t a, std::size_t b) {
        const bool flat_a = is_zero(normal(a)), flat_b = is_zero(normal(b));
        if (!flat_a && !flat_b) return join_if_smooth(a, b);
        if (flat_a && flat_b) return;
        const std::size_t flat = flat_a ? a : b, whole = flat_a ? b : a;
        if (neighbour_[flat] == none) {
            neighbour_[flat] = whole;
        } else {
            join_if_smooth(neighbour_[flat], whole);
        }
    }

    void join_if_smooth(std::size_t a, std::size_t b) {
        if (glm::dot(normal(a), normal(b)) > smooth_cosine_) parent_[root(a)] = root(b);
    }

    void write(std::vector<Vec3f>& normals) {
        sums_.assign(corners_.size(), Vec3d(0.0));
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const std::size_t c = corners_[i];
            sums_[root(i)] +=
                corner_angle(mesh_.positions, mesh_.triangles[c / 3], c % 3) * normal(i);
        }
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const std::size_t source = is_zero(normal(i)) ? neighbour_[i] : i;
            if (source == none) continue;
            const Vec3d mean = unit_or_zero(sums_[root(source)]);
            normals[corners_[i]] = Vec3f(is_zero(mean) ? normal(source) : mean);
        }
    }

    const Mesh& mesh_;
    const std::vector<Vec3d>& face_normals_;
    double smooth_cosine_;
    std::span<const std::uint32_t> corners_;
    std::vector<std::size_t> parent_, neighbour_;
    std::vector<Edge> edges_;
    std::vector<Vec3d> sums_;
};

/// Gives corners without a normal one of their face's, else one of their point's, else +Z.
void fill_gaps(const CornersByPoint& around, std::vector<Vec3f>& normals) {
    const Vec3f zero(0.0f);
    if (std::find(normals.begin(), normals.end(), zero) == normals.end()) return;
    for (std::size_t t = 0; 3 * t < normals.size(); ++t) {
        Vec3f* of_face = &normals[3 * t];
        for (std::size_t k = 0; k < 6; ++k) {
            if (of_face[k % 3] == zero) of_face[k % 3] = of_face[(k + 1) % 3];
        }
    }
    for (std::size_t p = 0; p < around.points(); ++p) {
        const std::span<const std::uint32_t> corners = around[p];
        Vec3f known = fallback_normal;
        for (const std::uint32_t c : corners) {
            if (normals[c] != zero) known = normals[c];
        }
        for (const std::uint32_t c : corners) {
            if (normals[c] == zero) normals[c] = known;
        }
    }
}

std::vector<Vec3d> all_face_normals(const Mesh& mesh) {
    std::vector<Vec3d> normals(mesh.triangles.size());
    for_each_index(normals.size(),
                   [&](std::size_t t) { normals[t] = face_normal(mesh, mesh.triangles[t]); });
    return normals;
}

std::vector<Vec3f> computed_normals(const Mesh& mesh, double crease_degrees) {
    const std::vector<Vec3d> face_normals = all_face_normals(mesh);
    const CornersByPoint around(mesh);
    std::vector<Vec3f> normals(3 * mesh.triangles.size(), Vec3f(0.0f));
    tbb::parallel_for(Range(0, around.points(), grain), [&](const Range& range) {
        Fans fans(mesh, face_normals, crease_degrees);
        for (std::size_t p = range.begin(); p < range.end(); ++p) fans.compute(around[p], normals);
    });
    fill_gaps(around, normals);
    return normals;
}

}  // namespace

std::vector<Vec3f> corner_normals(const Mesh& mesh, double crease_degrees) {
    if (mesh.corners.normals.empty()) return computed_normals(mesh, crease_degrees);
    std::vector<Vec3f> normals = mesh.corners.normals;
    std::vector<Vec3f> replacements;
    for (std::size_t c = 0; c < normals.size(); ++c) {
        const Vec3d unit = unit_or_zero(Vec3d(normals[c]));
        // A NaN component fails this comparison; an infinite one makes the unit zero.
        const bool usable = glm::dot(unit, unit) > 0.5;
        if (!usable && replacements.empty()) replacements = computed_normals(mesh, crease_degrees);
        normals[c] = usable ? Vec3f(unit) : replacements[c];
    }
    return normals;
}

}  // namespace burl
