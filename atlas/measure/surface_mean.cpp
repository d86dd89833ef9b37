// Means by a uniform grid: samples lie in cells as large as the kernel's radius, sorted by cell; a
// query reads nine runs of three neighbouring cells each. Cells without a query point nearby get no
// samples.
#include "atlas/measure/surface_mean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "atlas/base/random_unit.h"

namespace burl {

namespace {

constexpr double sliver = 0.05;  // area relative to edge^2 up to which parts stay whole
constexpr double most_samples = 0x1p24;

double area_of(const std::array<Vec3d, 3>& p) {
    return 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
}

double length_of(const std::array<Vec3d, 3>& p, std::size_t k) {
    return glm::length(p[(k + 1) % 3] - p[k]);
}

std::array<Vec3d, 3> points_of(const Mesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

/// Cuts triangles into parts, one triangle after the other.
class Cutter {
  public:
    Cutter(double edge, std::uint64_t seed, const std::function<bool(const Vec3d&)>& wanted,
           std::vector<SurfaceSample>& samples)
        : edge_(edge), seed_(seed), wanted_(wanted), samples_(samples) {}

    void cut(std::uint32_t triangle, const std::array<Vec3d, 3>& points) {
        triangle_ = triangle;
        counter_ = std::uint64_t{triangle} << 32;
        cut(points, area_of(points), 0.5 * edge_);
    }

  private:
    void cut(const std::array<Vec3d, 3>& p, double area, double enough) {
        std::size_t longest = 0;
        for (std::size_t k : {1u, 2u})
            if (length_of(p, k) > length_of(p, longest)) longest = k;
        const bool small = length_of(p, longest) <= enough;
        if (small || area <= sliver * edge_ * edge_) return keep(p, area, small);
        const Vec3d &a = p[longest], &b = p[(longest + 1) % 3], &c = p[(longest + 2) % 3];
        const double share = 0.4 + 0.2 * random();
        const Vec3d middle = a + share * (b - a);
        cut({a, middle, c}, share * area, edge_);
        cut({middle, b, c}, (1.0 - share) * area, edge_);
    }

    void keep(const std::array<Vec3d, 3>& p, double area, bool small) {
        if (!(area > 0.0)) return;
        const double root = std::sqrt(random()), v = random();
        const Vec3d w = small ? Vec3d(1.0 / 3.0) : Vec3d(1.0 - root, root * (1.0 - v), root * v);
        const Vec3d point = w.x * p[0] + w.y * p[1] + w.z * p[2];
        if (wanted_(point)) samples_.push_back({point, area, triangle_});
    }

    double random() { return random_unit(seed_, counter_++); }

    double edge_;
    std::uint64_t seed_;
    const std::function<bool(const Vec3d&)>& wanted_;
    std::vector<SurfaceSample>& samples_;
    std::uint32_t triangle_ = 0;
    std::uint64_t counter_ = 0;
};

double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += area_of(points_of(mesh, t));
    return area;
}

/// The edge, lengthened where a surface of that area would take more than most_samples parts.
double affordable(double area, double edge) {
    return std::max(edge, std::sqrt(area / (most_samples * sliver)));
}

constexpr double most_cells = 0x1p27;
constexpr double longest_part = 1.5;  // of a sample's part of a triangle, in sigmas
constexpr double part_area = 0.15;    // mean area of parts, in squares of the longest edge

/// The longest edge of parts. A long footprint gets as many samples as a round one.
double longest_edge(double sigma, double detail, double stretch) {
    return std::min(longest_part * sigma, std::max(detail, std::sqrt(stretch) * sigma / 4.0));
}

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

std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double edge, std::uint64_t seed,
                                          const std::function<bool(const Vec3d&)>& wanted) {
    const double longest = affordable(area_of(mesh), edge);
    constexpr std::size_t run = 64;  // triangles
    const std::size_t runs = (mesh.triangles.size() + run - 1) / run;
    std::vector<std::vector<SurfaceSample>> parts(runs);
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t i) {
        Cutter cutter(longest, seed, wanted, parts[i]);
        const std::size_t end = std::min(mesh.triangles.size(), (i + 1) * run);
        for (std::size_t t = i * run; t < end; ++t)
            cutter.cut(std::uint32_t(t), points_of(mesh, t));
    });
    std::vector<SurfaceSample> samples;
    for (const auto& part : parts) samples.insert(samples.end(), part.begin(), part.end());
    return samples;
}

std::vector<Vec3d> surface_means(const Mesh& mesh, const SolidColor& f,
                                 std::span<const SurfacePoint> points, double sigma, double detail,
                                 std::uint64_t seed, const Elongation& elongation) {
    const double stretch = elongation.stretch;
    const CellGrid grid(bounding_box(mesh), gaussian_cut * stretch * sigma);
    const std::vector<char> near = cells_near(grid, mesh, points);
    const auto wanted = [&](const Vec3d& p) { return near[grid.cell_of(p)] != 0; };
    const double edge = longest_edge(sigma, detail, stretch);
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

double surface_mean_calls(const Mesh& mesh, std::size_t points, double sigma, double detail,
                          double stretch) {
    const double area = area_of(mesh);
    const double edge = affordable(area, longest_edge(sigma, detail, stretch));
    return double(points) + double(mesh.triangles.size()) + area / (part_area * edge * edge);
}

}  // namespace burl
