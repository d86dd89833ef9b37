#pragma once
// One bake from a mesh to its files: mesh -> connectivity -> atlas -> solid points -> field and
// colour -> levels -> files. `burl bake`, `burl batch` and the editor's export are this function.
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/bake/material.h"
#include "app/bake/texture.h"
#include "app/base/course.h"
#include "app/export/export.h"
#include "app/kept/scene.h"
#include "app/pipeline/pipeline.h"
#include "atlas/measure/atlas_measures.h"

namespace burl {

/// The files that a bake writes, and the recipes that they show.
struct BakePlan {
    std::vector<std::string> paths{};  ///< outputs, one per frame; a bake without frames has one
    /// The recipe of the path of that number; all have one atlas and one solid space. It is asked
    /// for when its frame is due, so that a long animation need not be in memory at once.
    std::function<Recipe(std::size_t)> recipe{};
    /// The recipes of the pipeline's labels, where several share the atlas of a document that is
    /// kept; the first is that of `recipe`. Empty: there is one.
    std::vector<Recipe> sharing{};
    /// Is told, before the work, of an atlas that is too small or not of the kind asked for; empty:
    /// nobody is.
    std::function<void(const std::string&)> tell{};
    ImageKind kind = ImageKind::rgb8;  ///< kind of image of the textures (wanted_kind)
    int depth = 8;                     ///< bits of textures in sRGB and of normal maps, 8 or 16
    PictureCoding coding{};            ///< of pictures (coding_asked)
    ExrDepth exr_depth = ExrDepth::half;
    double crease_degrees = 40.0;  ///< crease angle of computed normals (app/surface/normals.h)
    LevelsAsked levels{};
    NormalSpace normals = NormalSpace::none;
    bool normals_down = false;            ///< whether a normal map's green points down
    Packing packing = Packing::gltf;      ///< which of a material's channels share a picture
    bool displaces = false;               ///< whether the exported mesh is moved by the height
    std::optional<double> compress{};     ///< the largest error of --compress (app/bake/texture.h)
    std::string solid_map{};              ///< path of the solid map; empty: none
    std::string shader{};                 ///< path of the texture as GLSL; empty: none
    std::vector<std::string> channels{};  ///< masks written beside (app/pipeline/mask_picture.h)
    /// The document that gets the mesh back with its texture; null: the output is a scene of its
    /// own.
    std::shared_ptr<KeptScene> kept{};
    KeyTrack pose_keys{};  ///< the pose's weight over time, for a scene that holds it
    bool measures = true;  ///< whether the atlas is measured for a report
    int threads = 0;       ///< number of threads for the files; 0: all
    std::shared_ptr<const KeptObj> obj{};  ///< the mesh's own OBJ, of which an .obj keeps the rest
    bool vertex_colors = false;            ///< whether colours per point replace the texture
    bool strips = false;                   ///< whether the scene has triangle strips
    /// Notes of the layouts of all UDIM tiles; none: the atlas has its own.
    std::optional<LayoutNotes> tile_notes{};
    Course* told = nullptr;  ///< is told what is done, and how much of it; null: nobody is
    /// A request by another thread to stop: bake() then throws Error(runtime) soon. Files of frames
    /// that are done stay; of the frame under way none is written.
    std::stop_token stop{};

    TaskMeter* meter() const { return told ? &told->meter() : nullptr; }
    /// The options that the material depends on; strip atlases may have fewer levels.
    MaterialAsked material() const {
        return {packing,        depth,
                levels.count,   normals == NormalSpace::tangent,
                crease_degrees, levels.rule.sharp};
    }
};

/// Results that a later bake with the same pipeline reuses: none, the mesh, or the mesh and the
/// atlas.
enum class LaterBake { none, mesh, atlas };

/// Results of a bake, for its report; texture and normals are those of the last frame.
struct BakeResult {
    std::optional<AtlasMetrics> metrics{};   ///< measures of the atlas, if the plan asks for them
    std::vector<std::string> paths{};        ///< outputs, as in the plan
    std::vector<CommittedFile> committed{};  ///< the files of every frame, solid map and shader
    LevelsAsked levels{};  ///< MIP levels that were written; strip atlases have few
    std::optional<NormalMap> normals{};
    BakedAtlas texture{};  ///< texture; empty if it was written in bands (comes_in_bands)
    std::optional<Vec3d> solid_base;          ///< solid map's base (app/export/emit.h)
    std::optional<LayoutNotes> tile_notes{};  ///< as in the plan
    StripCounts strips{};                     ///< of scenes with triangle strips
    std::vector<std::string> lost{};  ///< what of the mesh's document the output does not hold
    double writing = 0.0;             ///< seconds spent on files rather than on stages
};

/// The words on how viewers show a glTF's pictures of 16 bits.
inline constexpr const char* deep_gltf_loss =
    "viewers cut 16 bits to 8, and those that do not, such as VTK's, show them too light, since "
    "OpenGL has no 16-bit sRGB";

/// Sentences on what texture coordinates cannot show.
std::vector<std::string> uv_losses(const Mesh& mesh, const LayoutNotes& notes);

/// The plan's shader of the recipe on the mesh; empty where the plan has none. What it leaves out
/// is told.
std::string shader_text(const BakePlan& plan, const Mesh& mesh, const Recipe& recipe);

/// Bakes the pipeline's mesh and writes the plan's files; if `pose` is not null, the mesh is
/// exported in that pose. All files of a frame are committed together or not at all. Memory that a
/// `later` bake does not reuse is freed early. Throws Error, also where a frame's lattice is too
/// fine for the mesh (check_lattice); frames before it have been written.
BakeResult bake(Pipeline& pipeline, const BakePlan& plan, const MeshPose* pose = nullptr,
                LaterBake later = LaterBake::none);

}  // namespace burl
