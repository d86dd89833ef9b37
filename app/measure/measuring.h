#pragma once
// The measurement of one atlas after another on a mesh: `burl metrics`, and the library's.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/measure/metric_texture.h"
#include "app/measure/metrics_pictures.h"
#include "app/measure/metrics_report.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/task_meter.h"
#include "atlas/measure/surface_points.h"

namespace burl {

/// The subject of a measurement.
struct MeasuringPlan {
    Recipe recipe{};               ///< with the atlas's size
    bool looks_up_recipe = false;  ///< whether lookups are of its texture, else of metric-marble
    bool lookups = false;          ///< whether lookups are measured, which takes seconds
    bool sharp = false;            ///< whether they are of sharp levels (atlas/base/sharp_level.h)
    GapFill fill = GapFill::extrapolate;
    std::string image{};         ///< prefix of pictures that are written; empty: none
    View view{};                 ///< where pictures look from
    std::stop_token stop{};      ///< a request that the measuring ends, by Error(runtime)
    TaskMeter* meter = nullptr;  ///< is told what is done; null: nobody is
};

/// The kinds of atlas that are compared, all but uv; quad where it can have the size.
std::vector<AtlasKind> all_atlas_kinds(std::uint32_t size);

/// Throws Error(unsupported) for a texture that is not square, which is not measured.
void check_square(const AtlasOptions& atlas);

/// The name of our atlas of a kind; "uv" names the file's own coordinates as the file has them.
std::string measured_name(AtlasKind kind);

/// The pictures that are drawn of each atlas, and the path of one.
inline constexpr std::array picture_topics{"charts", "scale", "levels"};
std::string measured_picture(const std::string& prefix, std::string_view atlas, const char* topic);

/// About the noises (app/recipe/recipe_cost.h) that measuring the file's own texture coordinates,
/// if asked for, and so many of our atlases takes; 0 where no texture of the recipe is looked up.
double noises_of_measuring(const MeasuringPlan& plan, const Mesh& mesh, bool own_uvs,
                           std::size_t kinds);

/// Measures atlases of a mesh by a plan.
class Measuring {
  public:
    Measuring(MeasuringPlan plan, Mesh measured_mesh);

    const Mesh& mesh() const { return pipeline_.mesh(); }
    /// The figures of the mesh's own texture coordinates, if asked for, and of our atlases of these
    /// kinds, each a round of the meter. Throws Error as uv_atlas() and our_atlas() do.
    std::vector<MeasuredAtlas> all(bool own_uvs, std::span<const AtlasKind> kinds);
    /// The figures of our atlas of that kind. Throws Error as layouts do.
    MeasuredAtlas our_atlas(AtlasKind kind);
    /// The figures of the mesh's own texture coordinates, of which it must have some.
    MeasuredAtlas uv_atlas();
    /// The document of `burl metrics --json`.
    Json json(const std::vector<MeasuredAtlas>& atlases);

  private:
    void go_on(const char* task) const;
    MeasuredAtlas with_direct(MeasuredAtlas result, const std::optional<SurfaceTruth>& truth);
    std::optional<SurfaceTruth> refined_truth(const MeshAtlas& atlas) const;
    template <class Rasterize>
    MeasuredAtlas measured(std::string name, const Mesh& surface,
                           const std::vector<MeshEdge>& edges, const Atlas& atlas,
                           const std::optional<SurfaceTruth>& truth, Rasterize&& points_of) const;
    void draw(const PicturedAtlas& what, const ChartMetrics& charts, const TextureValues& values,
              MeasuredAtlas& measured) const;

    MeasuringPlan plan_;
    Pipeline pipeline_;
    std::vector<MeshEdge> edges_;
    MetricTexture texture_;
    std::optional<SurfaceTruth> truth_;
};

}  // namespace burl
