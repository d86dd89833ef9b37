// Means by a uniform grid: samples lie in cells as large as the kernel's radius, sorted by cell; a
// query reads nine runs of three neighbouring cells each. Cells without a query point nearby get no
// samples.
#include "atlas/measure/surface_mean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "atlas/measure/surface_samples.h"

namespace burl {

namespace {

constexpr double most_cells = 0x1p27;
constexpr double piece = 1.5;  // longest edge of a piece in sigmas

/// A grid of cells over a box with one layer of empty cells around it, numbered x first; cells are
/// enlarged until there are at most most_cells.
class CellGrid {
  public:
    CellGrid(const Box3& box, double cell) : low_(box.low) {
        const Vec3d size = box.size();
        for (cell_ = cell;; cell_ *= 1.25) {
            double total = 1.0;
            for (int axis = 0; axis < 3; ++axis) {
                counts_[std::size_t(axis)] = std::floor(size[axis] / cell_) + 3.0;
                total *= counts_[std::size_t(axis)];
            }
            if (total <= most_cells) break;
        }
    }
    std::size_t cells() const { return std::size_t(counts_[0] * counts_[1] * counts_[2]); }
    std::uint32_t cell_of(const Vec3d& p) const {
        std::array<double, 3> i{};
        for (int axis = 0; axis < 3; ++axis)
            i[std::size_t(axis)] = std::clamp(std::floor((p[axis] - low_[axis]) / cell_) + 1.0, 1.0,
                                              counts_[std::size_t(axis)] - 2.0);
        return std::uint32_t((i[2] * counts_[1] + i[1]) * counts_[0] + i[0]);
    }
    /// Calls visit(cell) for the middle cell of each of the nine runs of three around a cell.
    template <class Visit>
    void visit_runs(std::uint32_t cell, Visit&& visit) const {
        const auto row = std::int64_t(counts_[0]), layer = std::int64_t(counts_[0] * counts_[1]);
        for (std::int64_t z = -1; z <= 1; ++z)
            for (std::int64_t y = -1; y <= 1; ++y) visit(std::uint32_t(cell + z * layer + y * row));
    }

  private:
    Vec3d low_;
    double cell_ = 1.0;
    std::array<double, 3> counts_{};
};

std::vector<char> cells_near(const CellGrid& grid, const Mesh& mesh,
                             std::span<const SurfacePoint> points) {
    std::vector<char> near(grid.cells(), 0);
    for (const SurfacePoint& point : points)
        grid.visit_runs(grid.cell_of(position(mesh, point)), [&](std::uint32_t middle) {
            for (std::uint32_t cell = middle - 1; cell <= middle + 1; ++cell) near[cell] = 1;
        });
    return near;
}

/// Samples sorted by cell, with the function's values there.
struct IndexedSamples {
    std::vector<std::uint32_t> cells;  ///< cell of each sample, ascending
    std::vector<SurfaceSample> samples;
    std::vector<Vec3d> values;
};

IndexedSamples index_samples(const CellGrid& grid, std::vector<SurfaceSample> samples,
                             const SolidColor& f) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order(samples.size());
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
        order[i] = {grid.cell_of(samples[i].point), std::uint32_t(i)};
    });
    tbb::parallel_sort(order.begin(), order.end());
    IndexedSamples index;
    index.cells.resize(order.size());
    index.samples.resize(order.size());
    index.values.resize(order.size());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) {
        index.cells[i] = order[i].first;
        index.samples[i] = samples[order[i].second];
        index.values[i] = f(index.samples[i].point);
    });
    return index;
}

/// The Gaussian kernel over the samples.
struct Kernel {
    const CellGrid& grid;
    const IndexedSamples& index;
    const std::vector<Vec3d>& normals;
    double sigma = 1.0;
    double shorten = 0.0;  ///< 1 - 1 / stretch^2: share that squares lose along the footprint

    /// The weighted mean at a point, or `otherwise` where no sample is near.
    Vec3d mean(const Vec3d& at, std::uint32_t triangle, const Vec3d& across,
               const Vec3d& otherwise) const {
        Vec3d sum(0.0);
        double total = 0.0;
        const double falloff = -0.5 / (sigma * sigma);
        const double reach = gaussian_cut * gaussian_cut * sigma * sigma;
        grid.visit_runs(grid.cell_of(at), [&](std::uint32_t middle) {
            const auto first = std::lower_bound(index.cells.begin(), index.cells.end(), middle - 1);
            for (auto i = std::size_t(first - index.cells.begin());
                 i < index.cells.size() && index.cells[i] <= middle + 1; ++i) {
                const SurfaceSample& sample = index.samples[i];
                const Vec3d d = sample.point - at;
                const double v = glm::dot(d, across), straight = glm::dot(d, d);
                const double squared = straight - shorten * (straight - v * v);
                if (squared > reach || !(glm::dot(normals[sample.triangle], normals[triangle]) > 0))
                    continue;
                const double weight = sample.area * std::exp(falloff * squared);
                sum += weight * index.values[i];
                total += weight;
            }
        });
        return total > 0.0 ? sum / total : otherwise;
    }
};

}  // namespace

std::vector<Vec3d> surface_means(const Mesh& mesh, const SolidColor& f,
                                 std::span<const SurfacePoint> points, double sigma, double detail,
                                 std::uint64_t seed, const Elongation& elongation) {
    const double stretch = elongation.stretch;
    const CellGrid grid(bounding_box(mesh), gaussian_cut * stretch * sigma);
    const std::vector<char> near = cells_near(grid, mesh, points);
    const auto wanted = [&](const Vec3d& p) { return near[grid.cell_of(p)] != 0; };
    // A long footprint gets as many pieces as a round one.
    const double edge = std::min(piece * sigma, std::max(detail, std::sqrt(stretch) * sigma / 4.0));
    const IndexedSamples index = index_samples(grid, sample_surface(mesh, edge, seed, wanted), f);
    std::vector<Vec3d> normals(mesh.triangles.size());
    for (std::uint32_t t = 0; t < normals.size(); ++t) normals[t] = face_normal(mesh, t);
    const Kernel kernel{grid, index, normals, sigma, 1.0 - 1.0 / (stretch * stretch)};
    std::vector<Vec3d> means(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const Vec3d at = position(mesh, points[i]);
        const Vec3d across = elongation.across.empty() ? Vec3d(0.0) : elongation.across[i];
        means[i] = kernel.mean(at, points[i].triangle, across, f(at));
    });
    return means;
}

}  // namespace burl
