#pragma once
// A mesh's sampled views as lookups of its atlas's texture, for other programs to make.
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/measure/metric_texture.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/measure/uv_atlas.h"
#include "atlas/read/read_mesh.h"
#include "tests/paths.h"

namespace burl {

/// A lookup as a pixel makes it, in texels of level 0.
struct Lookup {
    Vec2d at{0.0};
    TexelSteps steps;
};

/// The views of a mesh, and metric-marble in an atlas of it.
struct ViewedMesh {
    SampledViews views;
    std::vector<std::vector<Lookup>> rows;  ///< lookups of each of the views' rows
    MipChain<Vec3f> chain;

    /// Views of a mesh's file in our atlas of a kind; of its own coordinates where there is none.
    ViewedMesh(const std::string& file, std::optional<AtlasKind> kind, std::uint32_t size,
               std::size_t points) {
        const Mesh input = read_mesh(file);
        const Connectivity joined = build_connectivity(input);
        if (!kind) {
            const Mesh mesh = normalised(input);
            const Atlas atlas = atlas_from_uvs(input, joined, size);
            look(mesh, atlas, rasterize_uvs(mesh, atlas, mesh.positions), points);
            return;
        }
        AtlasOptions options;
        options.kind = *kind;
        options.size = size;
        const MeshAtlas made = build_atlas(input, joined, options);
        const Mesh mesh = normalised(made.mesh(input));
        look(mesh, made.atlas(), rasterize(input, made, mesh.positions), points);
    }

    /// The RMS error of a row's values.
    double error(std::size_t row, const std::vector<Vec3d>& values) const {
        double squares = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i)
            squares += mean_square(values[i] - views.rows[row].means[i]);
        return std::sqrt(squares / double(values.size()));
    }

    /// A row's values by our sampler.
    std::vector<Vec3d> values(std::size_t row, int most) const {
        std::vector<Vec3d> result;
        for (const Lookup& one : rows[row])
            result.push_back(sampler_lookup(chain, one.at, one.steps, most));
        return result;
    }

  private:
    void look(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid, std::size_t points) {
        const MetricTexture texture = metric_marble_texture();
        TruthOptions wanted;
        wanted.size = atlas.options.size;
        wanted.points = wanted.level_points = wanted.grazing_points = 0;
        wanted.levels = 0;
        wanted.view_points = points;
        views = surface_truth(mesh, texture.color, wanted).views;
        chain = build_mip_chain(fill_texture(solid, texture.color).values);
        for (const ViewRow& row : views.rows) {
            std::vector<Lookup>& lookups = rows.emplace_back();
            for (std::size_t i = 0; i < views.points.size(); ++i) {
                const PixelSteps steps = views.steps(i, row);
                const std::uint32_t t = views.points[i].triangle;
                lookups.push_back(
                    {place(atlas, views.points[i]),
                     {mapped(mesh, atlas, t, steps.x), mapped(mesh, atlas, t, steps.y)}});
            }
        }
    }
};

/// The views of a sample mesh in an atlas of 256 x 256 texels.
inline ViewedMesh viewed_sample(const std::string& name, AtlasKind kind, std::size_t points) {
    return ViewedMesh(test::mesh_folder() + "/" + name, kind, 256, points);
}

}  // namespace burl
