// Regions by labels: each triangle gets a label; labels are tidied, split into connected regions
// and merged. Everything goes by triangle number, so ties fall the same way every time.
#include "atlas/patch/partition.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "atlas/base/elementary.h"
#include "atlas/mesh/dual_graph.h"

namespace burl {
namespace {

constexpr int tidy_passes = 6;
constexpr std::size_t few_faces = 60;  ///< number of faces below which regions are cut by extent

using Labels = std::vector<std::uint32_t>;

/// Gives each triangle that reaches into another region with two of its sides (an ear) to that
/// region.
void flip_ears(const Connectivity& connectivity, Labels& labels) {
    for (int pass = 0; pass < tidy_passes; ++pass) {
        bool changed = false;
        for (std::size_t t = 0; t < labels.size(); ++t) {
            std::array<std::int64_t, 3> side{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t n = connectivity.neighbours[t][k];
                side[k] = n < 0 ? -1 : std::int64_t(labels[static_cast<std::size_t>(n)]);
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t other = side[k];
                if (other < 0 || other == labels[t] || other != side[(k + 1) % 3]) continue;
                labels[t] = static_cast<std::uint32_t>(other);
                changed = true;
                break;
            }
        }
        if (!changed) return;
    }
}

/// Numbers of the connected components of equal label, ordered by their first triangle.
Labels connected_components(const Connectivity& connectivity, const Labels& labels) {
    constexpr std::uint32_t none = 0xffffffffu;
    Labels component(labels.size(), none);
    std::uint32_t count = 0;
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < labels.size(); ++start) {
        if (component[start] != none) continue;
        component[start] = count;
        open.push_back(start);
        while (!open.empty()) {
            const std::uint32_t t = open.back();
            open.pop_back();
            for (const std::int32_t side : connectivity.neighbours[t]) {
                const auto n = static_cast<std::uint32_t>(side);
                if (side < 0 || component[n] != none || labels[n] != labels[t]) continue;
                component[n] = count;
                open.push_back(n);
            }
        }
        ++count;
    }
    return component;
}

Regions regions_of(const Labels& labels) {
    Regions regions;
    for (std::uint32_t t = 0; t < labels.size(); ++t) {
        if (labels[t] >= regions.size()) regions.resize(labels[t] + 1);
        regions[labels[t]].push_back(t);
    }
    std::erase_if(regions, [](const auto& faces) { return faces.empty(); });
    return regions;
}

/// Merges components that are too small into the neighbour with most common border, smallest first,
/// until no such component with a neighbour is left.
class Merger {
  public:
    Merger(const Mesh& mesh, const Connectivity& connectivity, Labels& components)
        : components_(components) {
        const std::uint32_t count =
            components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
        area_.assign(count, 0.0);
        border_.resize(count);
        into_.resize(count);
        std::iota(into_.begin(), into_.end(), 0u);
        for (std::uint32_t t = 0; t < components.size(); ++t) {
            area_[components[t]] += triangle_area(mesh, t);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t n = connectivity.neighbours[t][k];
                if (n < 0 || components[static_cast<std::size_t>(n)] == components[t]) continue;
                border_[components[t]][components[static_cast<std::size_t>(n)]] +=
                    edge_length(mesh, t, k);
            }
        }
    }

    double area(std::uint32_t component) const { return area_[component]; }

    template <class TooSmall>
    void run(const TooSmall& too_small) {
        std::set<std::pair<double, std::uint32_t>> small;
        for (std::uint32_t p = 0; p < area_.size(); ++p)
            if (too_small(p) && !border_[p].empty()) small.emplace(area_[p], p);
        while (!small.empty()) {
            const std::uint32_t p = small.begin()->second;
            small.erase(small.begin());
            const std::uint32_t to = neighbour_with_most_border(p);
            small.erase({area_[to], to});
            merge(p, to);
            if (too_small(to) && !border_[to].empty()) small.emplace(area_[to], to);
        }
        for (std::uint32_t& component : components_) {
            while (into_[component] != component) component = into_[component];
        }
    }

  private:
    std::uint32_t neighbour_with_most_border(std::uint32_t p) const {
        auto best = border_[p].begin();
        for (auto other = best; other != border_[p].end(); ++other)
            if (other->second > best->second) best = other;
        return best->first;
    }

    void merge(std::uint32_t p, std::uint32_t to) {
        into_[p] = to;
        area_[to] += area_[p];
        for (const auto& [other, length] : border_[p]) {
            border_[other].erase(p);
            if (other == to) continue;
            border_[to][other] += length;
            border_[other][to] += length;
        }
        border_[p].clear();
    }

    Labels& components_;
    std::vector<double> area_;
    std::vector<std::map<std::uint32_t, double>> border_;
    std::vector<std::uint32_t> into_;
};

/// The regions of these components, those merged that are smaller than options.least_share says.
Regions merge_small(const Mesh& mesh, const Connectivity& connectivity, Labels components,
                    const PartitionOptions& options) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_area(mesh, t);
    const double least = options.least_share * area / options.patches;
    Merger merger(mesh, connectivity, components);
    merger.run([&](std::uint32_t p) { return merger.area(p) < least; });
    return regions_of(components);
}

Regions tidy_regions(const Mesh& mesh, const Connectivity& connectivity, Labels labels,
                     const PartitionOptions& options) {
    flip_ears(connectivity, labels);
    return merge_small(mesh, connectivity, connected_components(connectivity, labels), options);
}

/// Labels of two halves with as many triangles each, separated along the axis of largest extent.
Labels halves_by_extent(const Mesh& mesh, std::span<const std::uint32_t> faces) {
    std::vector<Vec3d> centre;
    Vec3d low(std::numeric_limits<double>::max()), high = -low;
    for (const std::uint32_t face : faces) {
        const Triangle& v = mesh.triangles[face];
        centre.push_back((mesh.positions[v[0]] + mesh.positions[v[1]] + mesh.positions[v[2]]) /
                         3.0);
        low = glm::min(low, centre.back());
        high = glm::max(high, centre.back());
    }
    const Vec3d size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<std::size_t> order(faces.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return centre[a][axis] < centre[b][axis];
    });
    Labels labels(faces.size(), 0);
    for (std::size_t i = order.size() / 2; i < order.size(); ++i) labels[order[i]] = 1;
    return labels;
}

}  // namespace

Regions partition_mesh(const Mesh& mesh, const Connectivity& connectivity,
                       const PartitionOptions& options) {
    std::vector<std::uint32_t> faces(mesh.triangles.size());
    std::iota(faces.begin(), faces.end(), 0u);
    std::vector<std::int32_t> local(faces.size(), -1);
    const DualGraph graph = dual_graph(mesh, connectivity, faces, local);
    return tidy_regions(mesh, connectivity, partition_graph(graph, options.patches, options.seed),
                        options);
}

Regions crease_regions(const Mesh& mesh, const Connectivity& connectivity, double degrees,
                       const PartitionOptions& options) {
    const double half = sine(degrees * std::numbers::pi / 360.0);
    const double least_cosine = 1.0 - 2.0 * half * half;
    // Flooding is finding the connected components of a mesh whose creases are no connections.
    Connectivity smooth = connectivity;
    for (std::uint32_t t = 0; t < smooth.neighbours.size(); ++t)
        for (std::int32_t& n : smooth.neighbours[t])
            if (n >= 0 && dihedral_cosine(mesh, t, static_cast<std::uint32_t>(n)) <= least_cosine)
                n = -1;
    return merge_small(mesh, connectivity,
                       connected_components(smooth, Labels(mesh.triangles.size(), 0)), options);
}

Regions regions_of_labels(const Mesh& mesh, const Connectivity& connectivity,
                          std::vector<std::uint32_t> labels) {
    flip_ears(connectivity, labels);
    Labels components = connected_components(connectivity, labels);
    Merger merger(mesh, connectivity, components);
    std::map<std::uint32_t, std::uint32_t> largest;  // largest component of each label
    for (std::uint32_t t = 0; t < components.size(); ++t) {
        const auto [place, fresh] = largest.emplace(labels[t], components[t]);
        if (merger.area(components[t]) > merger.area(place->second)) place->second = components[t];
    }
    std::vector<bool> fragment(components.size(), true);
    for (const auto& [label, component] : largest) fragment[component] = false;
    merger.run([&](std::uint32_t p) { return fragment[p]; });
    return regions_of(components);
}

Regions bisect_region(const Mesh& mesh, const Connectivity& connectivity,
                      std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local) {
    Labels half(faces.size(), 0);
    if (faces.size() >= few_faces)
        half = partition_graph(dual_graph(mesh, connectivity, faces, local), 2, 1);
    if (std::adjacent_find(half.begin(), half.end(), std::not_equal_to<>()) == half.end())
        half = halves_by_extent(mesh, faces);
    // The connectivity of the region's own triangles, with numbers within the region.
    Connectivity own;
    for (std::size_t i = 0; i < faces.size(); ++i) local[faces[i]] = static_cast<std::int32_t>(i);
    for (const std::uint32_t face : faces) {
        auto& sides = own.neighbours.emplace_back(connectivity.neighbours[face]);
        for (std::int32_t& side : sides)
            if (side >= 0) side = local[static_cast<std::size_t>(side)];
    }
    for (const std::uint32_t face : faces) local[face] = -1;
    if (faces.size() >= few_faces) flip_ears(own, half);
    Regions regions = regions_of(connected_components(own, half));
    if (regions.size() == 1 && faces.size() > 1)
        regions = regions_of(connected_components(own, halves_by_extent(mesh, faces)));
    for (auto& region : regions)
        for (std::uint32_t& face : region) face = faces[face];
    return regions;
}

}  // namespace burl
