#pragma once
// One bake from a mesh to its files: mesh -> connectivity -> atlas -> solid points -> field and
// colour -> levels -> files. `burl bake`, `burl batch` and the editor's export are this function.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bake/compress.h"
#include "app/bake/levels.h"
#include "app/bake/normals.h"
#include "app/export/export.h"
#include "app/pipeline/pipeline.h"
#include "atlas/measure/metrics.h"

namespace burl {

/// The files that a bake writes, and the recipes that they show.
struct BakePlan {
    std::vector<std::string> paths{};  ///< one per frame; a bake without frames has one
    std::vector<Recipe> recipes{};     ///< one per path, with one atlas and one solid space
    ImageKind kind = ImageKind::rgb8;  ///< of the textures (wanted_kind)
    int depth = 8;                     ///< bits of textures in sRGB and of normal maps, 8 or 16
    double crease_degrees = 40.0;      ///< for computed normals (app/surface/normals.h)
    LevelsAsked levels{};
    NormalSpace normals = NormalSpace::none;
    std::optional<double> compress{};  ///< the largest error of --compress (app/bake/compress.h)
    std::string solid_map{};           ///< path of the solid map; empty: none
    std::string shader{};              ///< path of the texture as GLSL; empty: none
    bool measures = true;              ///< the atlas is measured for a report
    int threads = 0;                   ///< of the solid map; 0: as many as the machine has
};

/// What another bake with the same pipeline will want of it.
enum class LaterBake { none, mesh, atlas };

/// What a bake made, for its report; textures and normals are those of the last frame.
struct BakeResult {
    std::optional<AtlasMetrics> metrics{};   ///< where the plan measures
    std::vector<CommittedFile> committed{};  ///< the files of every frame, solid map and shader
    LevelsAsked levels{};                    ///< those that there are: strip atlases have few
    std::optional<NormalMap> normals{};
    BakedAtlas texture{};             ///< empty where it came in bands (comes_in_bands)
    std::optional<Vec3d> solid_base;  ///< of the solid map (app/export/solid_map_file.h)
    double writing = 0.0;             ///< seconds spent on files rather than on stages
};

/// Throws Error where a recipe's lattice is too fine for the mesh (check_lattice), before any work.
void check_mesh(const BakePlan& plan, const Mesh& mesh);

/// Bakes the pipeline's mesh, in `pose` where it is not null. The files of a frame get their names
/// together or not at all. What a `later` bake does not want is given back early. Throws Error.
BakeResult bake(Pipeline& pipeline, const BakePlan& plan, const MeshPose* pose = nullptr,
                LaterBake later = LaterBake::none);

}  // namespace burl
