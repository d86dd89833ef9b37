// The only source that includes Eigen, which compiles slowly. Elimination order and factor depend
// on the numbering alone, so the same patch gives the same bits.
#include "atlas/chart/laplacian.h"

#include <algorithm>
#include <numeric>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace burl {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Fields that are solved for together.
constexpr std::size_t fields_at_once = 4;

/// Cotangent of the angle opposite half-edge h, clamped against triangles without area.
double opposite_cotangent(const Patch& patch, HalfEdge h) {
    const Vec3d& apex = patch.points[patch.triangles[h / 3][(h % 3 + 2) % 3]];
    const Vec3d a = patch.points[patch.start(h)] - apex, b = patch.points[patch.end(h)] - apex;
    const double sine = glm::length(glm::cross(a, b)), cosine = glm::dot(a, b);
    if (std::abs(cosine) >= most_edge_weight * sine)
        return cosine > 0.0 ? most_edge_weight : cosine < 0.0 ? -most_edge_weight : 0.0;
    return cosine / sine;
}

double edge_weight(const Patch& patch, HalfEdge h, HalfEdge other, EdgeWeights weights) {
    if (weights == EdgeWeights::uniform) return 1.0;
    double sum = opposite_cotangent(patch, h);
    if (other != h) sum += opposite_cotangent(patch, other);
    return std::clamp(0.5 * sum, least_edge_weight, most_edge_weight);
}

/// The upper half of a symmetric matrix in compressed columns (CSC), diagonal included, with the
/// rows of a column in arbitrary order: -weight for each edge between two rows, and `diagonal`.
/// row[v] is the row of vertex v, -1 without one.
Matrix upper_half(const std::vector<WeightedEdges::Edge>& edges, const std::vector<int>& row,
                  const std::vector<double>& diagonal) {
    const auto count = static_cast<int>(diagonal.size());
    std::vector<int> in_column(diagonal.size(), 1);
    const auto column_of = [&](const WeightedEdges::Edge& e) {
        const int a = row[e.a], b = row[e.b];
        return a < 0 || b < 0 ? -1 : std::max(a, b);
    };
    for (const auto& e : edges)
        if (const int c = column_of(e); c >= 0) ++in_column[std::size_t(c)];
    Matrix matrix(count, count);
    int* begin = matrix.outerIndexPtr();
    begin[0] = 0;
    for (int c = 0; c < count; ++c) begin[c + 1] = begin[c] + in_column[std::size_t(c)];
    matrix.resizeNonZeros(begin[count]);
    std::vector<int> place(begin, begin + count);
    const auto put = [&](int r, int c, double value) {
        const int at = place[std::size_t(c)]++;
        matrix.innerIndexPtr()[at] = r;
        matrix.valuePtr()[at] = value;
    };
    for (const auto& e : edges)
        if (const int c = column_of(e); c >= 0) put(std::min(row[e.a], row[e.b]), c, -e.weight);
    for (int c = 0; c < count; ++c) put(c, c, diagonal[std::size_t(c)]);
    return matrix;
}

std::vector<std::uint32_t> elimination_order(const std::vector<WeightedEdges::Edge>& edges,
                                             std::size_t vertices) {
    std::vector<int> row(vertices);
    std::iota(row.begin(), row.end(), 0);
    const Matrix matrix = upper_half(edges, row, std::vector<double>(vertices, 1.0));
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Upper>(), order);
    return {order.indices().data(), order.indices().data() + order.indices().size()};
}

/// Solves L x = x and then L^T x = x in place; x has `width` values per row.
template <std::size_t width>
void solve_in_place(const Matrix& lower, double* x) {
    const int* begin = lower.outerIndexPtr();
    const int* index = lower.innerIndexPtr();
    const double* value = lower.valuePtr();
    const auto rows = static_cast<int>(lower.cols());
    std::array<double, width> here;
    for (int j = 0; j < rows; ++j) {
        double* at = x + std::size_t(j) * width;
        const double diagonal = value[begin[j]];
        for (std::size_t w = 0; w < width; ++w) here[w] = at[w] /= diagonal;
        for (int p = begin[j] + 1; p < begin[j + 1]; ++p) {
            double* to = x + std::size_t(index[p]) * width;
            for (std::size_t w = 0; w < width; ++w) to[w] -= value[p] * here[w];
        }
    }
    for (int j = rows; j-- > 0;) {
        double* at = x + std::size_t(j) * width;
        for (std::size_t w = 0; w < width; ++w) here[w] = at[w];
        for (int p = begin[j] + 1; p < begin[j + 1]; ++p) {
            const double* from = x + std::size_t(index[p]) * width;
            for (std::size_t w = 0; w < width; ++w) here[w] -= value[p] * from[w];
        }
        const double diagonal = value[begin[j]];
        for (std::size_t w = 0; w < width; ++w) at[w] = here[w] / diagonal;
    }
}

}  // namespace

std::vector<WeightedEdges::Edge> edges_with_weights(const Patch& patch, EdgeWeights weights) {
    std::vector<WeightedEdges::Edge> edges;
    for (HalfEdge h = 0; h < 3 * patch.triangles.size(); ++h) {
        const HalfEdge other = patch.on_border(h) ? h : patch.across(h);
        if (other < h) continue;
        edges.push_back({patch.start(h),
                         patch.end(h),
                         edge_weight(patch, h, other, weights),
                         {h / 3, other / 3}});
    }
    return edges;
}

WeightedEdges weighted_edges(const Patch& patch, EdgeWeights weights,
                             std::vector<std::uint32_t> order) {
    WeightedEdges result{edges_with_weights(patch, weights), {}};
    result.order =
        order.empty() ? elimination_order(result.edges, patch.points.size()) : std::move(order);
    return result;
}

struct PatchLaplacian::Factor {
    std::vector<int> row;                              ///< row of each vertex, -1: not free
    std::vector<std::uint32_t> vertex;                 ///< free vertices in order of elimination
    std::vector<std::pair<int, std::uint32_t>> fixed;  ///< row of a free vertex, fixed vertex
    std::vector<double> fixed_weight;                  ///< weights of the edges in `fixed`
    Eigen::SimplicialLLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> solver;
    bool ok = true;

    /// Sets `fixed` and `fixed_weight` and returns the matrix of the free vertices.
    Matrix assemble(const std::vector<WeightedEdges::Edge>& edges) {
        fixed.clear();
        fixed_weight.clear();
        std::vector<double> diagonal(vertex.size(), 0.0);
        for (const auto& e : edges)
            for (const auto& [from, to] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
                if (row[from] < 0) continue;
                diagonal[static_cast<std::size_t>(row[from])] += e.weight;
                if (row[to] >= 0) continue;
                fixed.emplace_back(row[from], to);
                fixed_weight.push_back(e.weight);
            }
        return upper_half(edges, row, diagonal);
    }

    const Matrix& lower() const { return solver.matrixL().nestedExpression(); }

    template <std::size_t count>
    void solve_harmonic(std::span<std::vector<Vec2d>> fields) const {
        std::vector<double> x(2 * count * vertex.size(), 0.0);
        for (std::size_t i = 0; i < fixed.size(); ++i)
            for (std::size_t c = 0; c < count; ++c) {
                double* at = x.data() + 2 * (count * std::size_t(fixed[i].first) + c);
                at[0] += fixed_weight[i] * fields[c][fixed[i].second].x;
                at[1] += fixed_weight[i] * fields[c][fixed[i].second].y;
            }
        solve_in_place<2 * count>(lower(), x.data());
        for (std::size_t i = 0; i < vertex.size(); ++i)
            for (std::size_t c = 0; c < count; ++c)
                fields[c][vertex[i]] = {x[2 * (count * i + c)], x[2 * (count * i + c) + 1]};
    }
};

PatchLaplacian::PatchLaplacian(const WeightedEdges& edges, const std::vector<bool>& is_free)
    : factor_(std::make_unique<Factor>()) {
    Factor& f = *factor_;
    f.row.assign(is_free.size(), -1);
    for (const std::uint32_t v : edges.order)
        if (is_free[v]) {
            f.row[v] = static_cast<int>(f.vertex.size());
            f.vertex.push_back(v);
        }
    if (f.vertex.empty()) return;
    f.solver.compute(f.assemble(edges.edges));
    f.ok = f.solver.info() == Eigen::Success;
}

void PatchLaplacian::refactor(const WeightedEdges& edges) {
    Factor& f = *factor_;
    if (f.vertex.empty()) return;
    f.solver.factorize(f.assemble(edges.edges));
    f.ok = f.solver.info() == Eigen::Success;
}

PatchLaplacian::~PatchLaplacian() = default;
PatchLaplacian::PatchLaplacian(PatchLaplacian&&) noexcept = default;
PatchLaplacian& PatchLaplacian::operator=(PatchLaplacian&&) noexcept = default;

bool PatchLaplacian::factored() const {
    return factor_->ok;
}

void PatchLaplacian::solve_harmonic(std::span<std::vector<Vec2d>> fields) const {
    if (factor_->vertex.empty()) return;
    while (fields.size() >= fields_at_once) {
        factor_->solve_harmonic<fields_at_once>(fields.first(fields_at_once));
        fields = fields.subspan(fields_at_once);
    }
    for (; !fields.empty(); fields = fields.subspan(1)) factor_->solve_harmonic<1>(fields.first(1));
}

void PatchLaplacian::apply_inverse(std::span<const double> values, std::span<double> result) const {
    const Factor& f = *factor_;
    std::vector<double> x(f.vertex.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = values[f.vertex[i]];
    std::fill(result.begin(), result.end(), 0.0);
    if (x.empty()) return;
    solve_in_place<1>(f.lower(), x.data());
    for (std::size_t i = 0; i < x.size(); ++i) result[f.vertex[i]] = x[i];
}

void PatchLaplacian::apply_inverse(std::span<Vec2d> values) const {
    const Factor& f = *factor_;
    std::vector<Vec2d> x(f.vertex.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = values[f.vertex[i]];
    std::fill(values.begin(), values.end(), Vec2d(0.0));
    if (x.empty()) return;
    solve_in_place<2>(f.lower(), &x[0].x);
    for (std::size_t i = 0; i < x.size(); ++i) values[f.vertex[i]] = x[i];
}

}  // namespace burl
