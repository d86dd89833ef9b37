// The only source that includes Eigen, which compiles slowly. The ordering (approximate minimum
// degree) and the factor depend on the numbering alone, so the same patch gives the same bits.
#include "atlas/laplacian.h"

#include <algorithm>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace burl {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Cotangent of the angle opposite half-edge h, clamped against triangles without area.
double opposite_cotangent(const Patch& patch, HalfEdge h) {
    const Vec3d& apex = patch.points[patch.triangles[h / 3][(h % 3 + 2) % 3]];
    const Vec3d a = patch.points[patch.start(h)] - apex, b = patch.points[patch.end(h)] - apex;
    const double sine = glm::length(glm::cross(a, b)), cosine = glm::dot(a, b);
    if (std::abs(cosine) >= most_edge_weight * sine)
        return cosine > 0.0 ? most_edge_weight : cosine < 0.0 ? -most_edge_weight : 0.0;
    return cosine / sine;
}

double edge_weight(const Patch& patch, HalfEdge h, EdgeWeights weights) {
    if (weights == EdgeWeights::uniform) return 1.0;
    double sum = opposite_cotangent(patch, h);
    if (!patch.on_border(h)) sum += opposite_cotangent(patch, patch.across(h));
    return std::clamp(0.5 * sum, least_edge_weight, most_edge_weight);
}

}  // namespace

struct PatchLaplacian::Factor {
    std::vector<int> row;               ///< per vertex: its number among the free ones, or -1
    std::vector<std::uint32_t> vertex;  ///< per free vertex
    Matrix to_fixed;                    ///< weights from free vertices (rows) to all vertices
    Eigen::SimplicialLLT<Matrix> solver;
    bool ok = true;
};

PatchLaplacian::PatchLaplacian(const Patch& patch, const std::vector<bool>& is_free,
                               EdgeWeights weights)
    : factor_(std::make_unique<Factor>()) {
    Factor& f = *factor_;
    f.row.assign(patch.points.size(), -1);
    for (std::uint32_t v = 0; v < f.row.size(); ++v)
        if (is_free[v]) {
            f.row[v] = static_cast<int>(f.vertex.size());
            f.vertex.push_back(v);
        }
    if (f.vertex.empty()) return;
    std::vector<Eigen::Triplet<double, int>> entries, border;
    std::vector<double> diagonal(f.vertex.size(), 0.0);
    const auto add = [&](std::uint32_t from, std::uint32_t to, double weight) {
        const int i = f.row[from], j = f.row[to];
        if (i < 0) return;
        diagonal[static_cast<std::size_t>(i)] += weight;
        if (j < 0)
            border.emplace_back(i, static_cast<int>(to), weight);
        else if (i > j)
            entries.emplace_back(i, j, -weight);
    };
    for (HalfEdge h = 0; h < 3 * patch.triangles.size(); ++h) {
        if (!patch.on_border(h) && patch.across(h) < h) continue;
        const double weight = edge_weight(patch, h, weights);
        add(patch.start(h), patch.end(h), weight);
        add(patch.end(h), patch.start(h), weight);
    }
    for (std::size_t i = 0; i < diagonal.size(); ++i)
        entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[i]);
    const auto free_count = static_cast<int>(f.vertex.size());
    Matrix matrix(free_count, free_count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    f.to_fixed.resize(free_count, static_cast<int>(patch.points.size()));
    f.to_fixed.setFromTriplets(border.begin(), border.end());
    f.solver.compute(matrix);
    f.ok = f.solver.info() == Eigen::Success;
}

PatchLaplacian::~PatchLaplacian() = default;
PatchLaplacian::PatchLaplacian(PatchLaplacian&&) noexcept = default;
PatchLaplacian& PatchLaplacian::operator=(PatchLaplacian&&) noexcept = default;

bool PatchLaplacian::factored() const {
    return factor_->ok;
}

void PatchLaplacian::solve_harmonic(std::span<Vec2d> values) const {
    const Factor& f = *factor_;
    if (f.vertex.empty()) return;
    Eigen::MatrixX2d all(static_cast<Eigen::Index>(values.size()), 2);
    for (std::size_t v = 0; v < values.size(); ++v) {
        all(static_cast<Eigen::Index>(v), 0) = values[v].x;
        all(static_cast<Eigen::Index>(v), 1) = values[v].y;
    }
    const Eigen::MatrixX2d right = f.to_fixed * all;
    const Eigen::MatrixX2d solution = f.solver.solve(right);
    for (std::size_t i = 0; i < f.vertex.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        values[f.vertex[i]] = {solution(row, 0), solution(row, 1)};
    }
}

void PatchLaplacian::apply_inverse(std::span<const double> values, std::span<double> result) const {
    const Factor& f = *factor_;
    Eigen::VectorXd right(static_cast<Eigen::Index>(f.vertex.size()));
    for (std::size_t i = 0; i < f.vertex.size(); ++i)
        right[static_cast<Eigen::Index>(i)] = values[f.vertex[i]];
    std::fill(result.begin(), result.end(), 0.0);
    if (f.vertex.empty()) return;
    const Eigen::VectorXd solution = f.solver.solve(right);
    for (std::size_t i = 0; i < f.vertex.size(); ++i)
        result[f.vertex[i]] = solution[static_cast<Eigen::Index>(i)];
}

}  // namespace burl
