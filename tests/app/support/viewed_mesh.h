#pragma once
// A mesh's sampled views as lookups of its atlas's texture, for other programs to make.
#include <string>
#include <vector>

#include "app/measure/metric_texture.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/read/read_mesh.h"
#include "tests/paths.h"

namespace burl {

/// A lookup as a pixel makes it, in texels of level 0.
struct Lookup {
    Vec2d at{0.0};
    TexelSteps steps;
};

/// The views of a sample mesh and metric-marble in its atlas.
struct ViewedMesh {
    SampledViews views;
    std::vector<std::vector<Lookup>> rows;  ///< lookups of each of the views' rows
    MipChain<Vec3f> chain;

    ViewedMesh(const std::string& name, AtlasKind kind, std::size_t points) {
        const Mesh input = read_mesh(test::mesh_folder() + "/" + name);
        AtlasOptions options;
        options.kind = kind;
        options.size = 256;
        const MeshAtlas made = build_atlas(input, build_connectivity(input), options);
        const Mesh mesh = normalised(made.mesh(input));
        const MetricTexture texture = metric_marble_texture();
        TruthOptions wanted;
        wanted.size = options.size;
        wanted.points = wanted.level_points = wanted.grazing_points = 0;
        wanted.levels = 0;
        wanted.view_points = points;
        views = surface_truth(mesh, texture.color, wanted).views;
        const SolidAtlas solid = rasterize(input, made, mesh.positions);
        chain = build_mip_chain(fill_texture(solid, texture.color).values);
        for (const ViewRow& row : views.rows) {
            std::vector<Lookup>& lookups = rows.emplace_back();
            for (std::size_t i = 0; i < views.points.size(); ++i) {
                const PixelSteps steps = views.steps(i, row);
                const std::uint32_t t = views.points[i].triangle;
                lookups.push_back({place(made.atlas(), views.points[i]),
                                   {mapped(mesh, made.atlas(), t, steps.x),
                                    mapped(mesh, made.atlas(), t, steps.y)}});
            }
        }
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
};

}  // namespace burl
