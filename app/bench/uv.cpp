// `burl bench uv`: lookups of a uv atlas beside textures for the same coordinates that are filled
// by exhaustive search, which share no code with it.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/measure/metric_texture.h"
#include "atlas/base/each_index.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/read/read_mesh.h"

namespace burl {

namespace {

constexpr std::uint32_t last_uv_level = 3;
/// Samples of the surface per texel for the means of the texels that they fall into.
constexpr std::size_t samples_per_texel = 32;

/// The nearest triangle of a place in the texture, by its weights there and at the nearest place of
/// the triangle.
struct Nearest {
    std::size_t triangle = 0;
    Vec3d here{0.0}, there{0.0};
    double distance = INFINITY;  ///< in texels
};

/// Searches all triangles for the one nearest to a place in the texture.
class ExhaustiveSearch {
  public:
    ExhaustiveSearch(const Mesh& mesh, const Atlas& atlas) : mesh_(mesh), atlas_(atlas) {}

    Nearest operator()(const Vec2d& at) const {
        Nearest best;
        for (std::size_t t = 0; t < atlas_.corners.size(); ++t) {
            const auto& c = atlas_.corners[t];
            const Vec2d low = glm::min(glm::min(c[0], c[1]), c[2]) - at,
                        high = at - glm::max(glm::max(c[0], c[1]), c[2]);
            if (glm::length(glm::max(glm::max(low, high), Vec2d(0.0))) >= best.distance) continue;
            if (cross(c[1] - c[0], c[2] - c[0]) == 0.0) continue;
            const Vec3d here = weights(c, at), there = nearest(c, at, here);
            const double distance = here == there ? 0.0 : glm::length(place_in(t, there) - at);
            if (distance < best.distance) best = {t, here, there, distance};
        }
        return best;
    }

    /// The triangle's point at a place given by weights.
    Vec3d point(std::size_t t, const Vec3d& w) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return w.x * mesh_.positions[a] + w.y * mesh_.positions[b] + w.z * mesh_.positions[c];
    }
    /// The place in the texture given by weights.
    Vec2d place_in(std::size_t t, const Vec3d& w) const {
        const auto& c = atlas_.corners[t];
        return w.x * c[0] + w.y * c[1] + w.z * c[2];
    }

  private:
    static Vec3d weights(const std::array<Vec2d, 3>& c, const Vec2d& at) {
        const double all = cross(c[1] - c[0], c[2] - c[0]);
        const double b = cross(at - c[0], c[2] - c[0]) / all,
                     d = cross(c[1] - c[0], at - c[0]) / all;
        return {1.0 - b - d, b, d};
    }

    static Vec3d nearest(const std::array<Vec2d, 3>& c, const Vec2d& at, const Vec3d& here) {
        if (here.x >= 0.0 && here.y >= 0.0 && here.z >= 0.0) return here;
        double least = INFINITY;
        Vec3d best(0.0);
        for (int k = 0; k < 3; ++k) {
            const Vec2d from = c[std::size_t(k)], along = c[std::size_t((k + 1) % 3)] - from;
            const double s = std::clamp(
                glm::dot(at - from, along) / std::max(glm::dot(along, along), 1e-300), 0.0, 1.0);
            const double distance = glm::length(from + s * along - at);
            if (distance >= least) continue;
            least = distance;
            best = Vec3d(0.0);
            best[k] = 1.0 - s;
            best[(k + 1) % 3] = s;
        }
        return best;
    }

    const Mesh& mesh_;
    const Atlas& atlas_;
};

/// Ways to fill a texel whose centre lies in no triangle: the nearest triangle's map goes on for so
/// many texels from its border, or the surface is reflected there.
constexpr double reflected = -1.0;
constexpr std::array ways{0.0, 1.0, 1.5, 2.0, 4.0, 1e9, reflected};

/// The point that a texel shows, by one of `ways`.
Vec3d shown_point(const ExhaustiveSearch& search, const Nearest& found, const Vec2d& at,
                  double way) {
    const Vec3d border = search.point(found.triangle, found.there);
    if (found.distance == 0.0) return border;
    if (way == reflected) {
        const Vec2d there = search.place_in(found.triangle, found.there);
        const Nearest inner = search(2.0 * there - at);
        return 2.0 * border - search.point(inner.triangle, inner.there);
    }
    const double share = std::min(1.0, way / found.distance);
    return search.point(found.triangle, share * found.here + (1.0 - share) * found.there);
}

/// Textures for the same coordinates, filled by each of the ways.
using Fillings = std::vector<Image<Vec3f>>;

Fillings search_texels(const Mesh& mesh, const Atlas& atlas, const SolidColor& f) {
    const std::size_t size = atlas.options.size;
    Fillings all(ways.size(), Image<Vec3f>(size, size));
    const ExhaustiveSearch search(mesh, atlas);
    for_each_index(
        size,
        [&](std::size_t y) {
            for (std::size_t x = 0; x < size; ++x) {
                const Vec2d at(double(x) + 0.5, double(y) + 0.5);
                const Nearest found = search(at);
                for (std::size_t w = 0; w < ways.size(); ++w)
                    all[w](x, y) = found.distance == 0.0 && w > 0
                                       ? all[0](x, y)
                                       : Vec3f(f(shown_point(search, found, at, ways[w])));
            }
        },
        1);
    return all;
}

/// The level whose texels are means over the surface in them; those without any keep `otherwise`.
Image<Vec3f> surface_in_texels(const Mesh& mesh, const Atlas& atlas, const SolidColor& f,
                               const Image<Vec3f>& otherwise) {
    const std::size_t size = otherwise.width();
    const double scale = double(size) / atlas.options.size;
    Image<Vec4f> sums(size, size, Vec4f(0.0f));
    const std::size_t all = atlas.options.size * std::size_t(atlas.options.size);
    for (const SurfacePoint& p : area_uniform_points(mesh, samples_per_texel * all / 4, 7)) {
        const Vec2d at = place(atlas, p) * scale;
        const auto edge = double(size - 1);
        sums(std::size_t(std::clamp(at.x, 0.0, edge)), std::size_t(std::clamp(at.y, 0.0, edge))) +=
            Vec4f(Vec3f(f(position(mesh, p))), 1.0f);
    }
    Image<Vec3f> level = otherwise;
    for (std::size_t y = 0; y < size; ++y)
        for (std::size_t x = 0; x < size; ++x)
            if (const Vec4f& sum = sums(x, y); sum.w > 0.0f) level(x, y) = Vec3f(sum) / sum.w;
    return level;
}

/// Errors of lookups in one level of the textures for one mesh.
struct UvBench {
    std::uint32_t level = 0;
    double rmse = 0.0;             ///< of the uv atlas
    std::vector<double> searched;  ///< of the textures filled by search, by `ways`
    double surface = 0.0;          ///< of means of the surface in each texel
    double truth_noise = 0.0;

    double best() const { return std::min(surface, std::ranges::min(searched)); }
    double ratio() const { return rmse / best(); }
};

Json uv_json(const UvBench& row) {
    return {{"level", row.level},
            {"rmse", row.rmse},
            {"ways", ways},
            {"rmse_of_ways", row.searched},
            {"rmse_surface_mean", row.surface},
            {"of_best", row.ratio()},
            {"truth_noise", row.truth_noise}};
}

std::vector<UvBench> bench_uv(const Mesh& input, std::uint32_t size) {
    const Mesh mesh = normalised(input);
    AtlasOptions options;
    options.kind = AtlasKind::uv;
    options.size = size;
    options.overlap = UvOverlap::first;
    const MeshAtlas made = build_atlas(mesh, build_connectivity(mesh), options);
    const Atlas& atlas = made.atlas();
    const MetricTexture texture = metric_marble_texture();
    TruthOptions wanted;
    wanted.size = size;
    wanted.levels = last_uv_level;
    wanted.grazing_levels = 0;
    wanted.detail = texture.detail;
    const SurfaceTruth truth = surface_truth(mesh, texture.color, wanted);
    Image<Vec3f> ours =
        fill_texture(rasterize(mesh, made, mesh.positions), texture.color, GapFill::black).values;
    Fillings by_search = search_texels(mesh, atlas, texture.color);
    std::vector<UvBench> rows;
    for (std::uint32_t l = 0; l <= std::uint32_t(truth.levels.size()); ++l) {
        const std::vector<SurfacePoint>& points = l == 0 ? truth.points : truth.level_points;
        const std::vector<Vec3d>& values = l == 0 ? truth.values : truth.levels[l - 1].means;
        const auto error = [&](const Image<Vec3f>& level) {
            return lookup_rmse(atlas, level, points, values);
        };
        UvBench row{l, error(ours), {}, 0.0, l == 0 ? 0.0 : truth.levels[l - 1].noise};
        for (const Image<Vec3f>& level : by_search) row.searched.push_back(error(level));
        row.surface = error(surface_in_texels(mesh, atlas, texture.color, by_search[0]));
        rows.push_back(std::move(row));
        ours = halve(ours);
        for (Image<Vec3f>& level : by_search) level = halve(level);
    }
    return rows;
}

}  // namespace

void run_uv_bench(const BenchCommand& command) {
    if (command.file.empty())
        throw Error(ExitCode::usage, "bench uv: name a mesh with texture coordinates");
    const auto rows = bench_uv(read_mesh(command.file), std::uint32_t(command.size_or(512)));
    if (!report_rows(command, rows, uv_json)) return;
    fmt::print(
        "level      RMSE  of best    nearest        1      1.5        2        4      all  "
        "reflect  surface  truth +-\n");
    for (const UvBench& row : rows) {
        fmt::print("{:>5} {:>9.5f} {:>8.4f}  ", row.level, row.rmse, row.ratio());
        for (const double error : row.searched) fmt::print(" {:>8.5f}", error);
        fmt::print(" {:>8.5f}  {:>8.5f}\n", row.surface, row.truth_noise);
    }
}

}  // namespace burl
