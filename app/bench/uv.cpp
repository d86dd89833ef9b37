// `burl bench uv`: lookups of a uv atlas beside textures for the same coordinates that are filled
// by exhaustive search, which share no code with it.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/command.h"
#include "app/measure/metric_texture.h"
#include "atlas/base/each_index.h"
#include "atlas/base/error.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/read/read_mesh.h"

namespace burl {

namespace {

constexpr std::uint32_t last_uv_level = 3;
/// Samples of the surface per texel for the means of the texels that they fall into.
constexpr std::size_t samples_per_texel = 32;

/// What the search finds for one texel centre.
struct Found {
    Vec3d continued{0.0};  ///< the affine map of the nearest triangle at the centre
    Vec3d nearest{0.0};    ///< the point of that triangle that is nearest in the texture
};

/// Searches all triangles for the one nearest to a place in the texture.
class ExhaustiveSearch {
  public:
    ExhaustiveSearch(const Mesh& mesh, const Atlas& atlas) : mesh_(mesh), atlas_(atlas) {}

    Found operator()(const Vec2d& at) const {
        double least = INFINITY;
        Vec3d best_here(0.0), best_there(0.0);
        std::size_t found = 0;
        for (std::size_t t = 0; t < atlas_.corners.size(); ++t) {
            const auto& c = atlas_.corners[t];
            const Vec2d low = glm::min(glm::min(c[0], c[1]), c[2]) - at,
                        high = at - glm::max(glm::max(c[0], c[1]), c[2]);
            const Vec2d out = glm::max(glm::max(low, high), Vec2d(0.0));
            if (glm::dot(out, out) >= least || cross(c[1] - c[0], c[2] - c[0]) == 0.0) continue;
            const Vec3d here = weights(c, at), there = nearest(c, at, here);
            const Vec2d away = there.x * c[0] + there.y * c[1] + there.z * c[2] - at;
            if (glm::dot(away, away) >= least) continue;
            least = glm::dot(away, away);
            best_here = here, best_there = there, found = t;
        }
        return {point(found, best_here), point(found, best_there)};
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

    Vec3d point(std::size_t t, const Vec3d& w) const {
        const auto& [a, b, c] = mesh_.triangles[t];
        return w.x * mesh_.positions[a] + w.y * mesh_.positions[b] + w.z * mesh_.positions[c];
    }

    const Mesh& mesh_;
    const Atlas& atlas_;
};

/// Textures for the same coordinates that are filled by other means.
struct Fillings {
    Image<Vec3f> continued, nearest;
};

Fillings search_texels(const Mesh& mesh, const Atlas& atlas, const SolidColor& f) {
    const std::size_t size = atlas.options.size;
    Fillings all{Image<Vec3f>(size, size), Image<Vec3f>(size, size)};
    const ExhaustiveSearch search(mesh, atlas);
    for_each_index(
        size,
        [&](std::size_t y) {
            for (std::size_t x = 0; x < size; ++x) {
                const Found found = search({double(x) + 0.5, double(y) + 0.5});
                all.continued(x, y) = Vec3f(f(found.continued));
                all.nearest(x, y) = Vec3f(f(found.nearest));
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
    double rmse = 0.0;                                     ///< of the uv atlas
    double continued = 0.0, nearest = 0.0, surface = 0.0;  ///< of the textures filled by search
    double truth_noise = 0.0;

    double best() const { return std::min({continued, nearest, surface}); }
    double ratio() const { return rmse / best(); }
};

Json uv_json(const UvBench& row) {
    return {{"level", row.level},
            {"rmse", row.rmse},
            {"rmse_continued", row.continued},
            {"rmse_nearest", row.nearest},
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
        rows.push_back({l, error(ours), error(by_search.continued), error(by_search.nearest),
                        error(surface_in_texels(mesh, atlas, texture.color, by_search.nearest)),
                        l == 0 ? 0.0 : truth.levels[l - 1].noise});
        ours = halve(ours);
        by_search = {halve(by_search.continued), halve(by_search.nearest)};
    }
    return rows;
}

}  // namespace

void run_uv_bench(const BenchCommand& command) {
    if (command.file.empty())
        throw Error(ExitCode::usage, "bench uv: name a mesh with texture coordinates");
    const auto rows = bench_uv(read_mesh(command.file), std::uint32_t(command.size_or(512)));
    if (!report_rows(command, rows, uv_json)) return;
    fmt::print("{:>5} {:>9} {:>10} {:>9} {:>9} {:>8} {:>9}\n", "level", "RMSE", "continued",
               "nearest", "surface", "of best", "truth +-");
    for (const UvBench& row : rows)
        fmt::print("{:>5} {:>9.5f} {:>10.5f} {:>9.5f} {:>9.5f} {:>8.4f} {:>9.5f}\n", row.level,
                   row.rmse, row.continued, row.nearest, row.surface, row.ratio(), row.truth_noise);
}

}  // namespace burl
