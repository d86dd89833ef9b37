#pragma once
// The pipeline of the editor, on a thread of its own: takes meshes and recipes, and holds ready
// what the windows show - the newest surface and the newest picture, rough ones first.
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/editor/work/errands.h"
#include "app/editor/work/levels.h"
#include "app/editor/work/worker.h"
#include "app/measure/atlas_sheet.h"
#include "app/pipeline/level_choice.h"
#include "app/pipeline/pipeline.h"
#include "app/scene/surface_pick.h"
#include "atlas/read/pose.h"

namespace burl {

/// The mesh under one layout of its atlas.
struct EditSurface {
    std::uint64_t number = 0;     ///< another one for every layout
    Scene scene{};                ///< without textures of its own (app/gl/draw/view_scene.h)
    std::vector<Mat4d> frames{};  ///< of the scene's surfaces (app/scene/unit_frame.h)
    Sphere sphere{};
    Affine3 unit_from_mesh{};  ///< solid_from_mesh of SolidSpace::unit
    std::uint32_t size = 0;    ///< of the texture at level 0
    std::size_t triangles = 0;
    std::string atlas{};  ///< its kind
    bool posed = false;   ///< its scene has targets
};

/// A level of the texture of the surface `surface`.
struct EditPicture {
    std::uint64_t number = 0, surface = 0, request = 0;
    std::uint32_t level = 0;
    Image<Rgb8> texels{};
    std::vector<Image<Rgba8>> levels{};            ///< the same for OpenGL, with its own levels
    double seconds = 0.0;                          ///< that making it took
    std::shared_ptr<const Image<Rgb8>> normals{};  ///< of the bumps; null: none, or not yet
};

class EditBaker {
    /// What a sheet depends on.
    struct SheetKey {
        std::uint64_t surface = 0;
        SolidSpace space = SolidSpace::unit;
        bool operator==(const SheetKey&) const = default;
    };

  public:
    /// `wake` is called by another thread whenever there is something new. `budget`: seconds that a
    /// picture may take while a slider moves.
    explicit EditBaker(std::function<void()> wake, double budget = 0.03);
    /// Stops what is under way.
    ~EditBaker();

    /// From now on this mesh, which has no pose; pictures come after the next request.
    void set_mesh(Mesh mesh);
    /// From now on the mesh has this pose (null: none), which changes no picture: a new surface
    /// comes after the next request. One of another mesh is a problem.
    void set_pose(std::shared_ptr<const MeshPose> pose);
    /// Its number, from 1 on, which the pictures made for it have.
    std::uint64_t request(const Recipe& recipe, bool moving) {
        worker_.request({recipe, moving, ++requests_});
        return requests_;
    }

    /// The newest; null: none yet.
    std::shared_ptr<const EditSurface> surface() const;
    std::shared_ptr<const EditPicture> picture() const;
    /// The surface that will be shown with its first picture, so that it can be uploaded meanwhile;
    /// null: none.
    std::shared_ptr<const EditSurface> coming() const;
    /// The last mesh has no picture at level 0 yet, and that is being worked at.
    bool opening() const;
    /// While held, nothing is begun that can wait until the pictures are seen: what finds places
    /// on a surface, and the recipe's own atlas.
    void hold_errands(bool held) { errands_.hold(held); }
    /// What finds places on the newest surface; null, or that of an older surface (its scene() is
    /// another), until the newest surface's first picture is done.
    std::shared_ptr<const SurfacePick> pick() const;
    /// Whether somebody looks at sheets. True: there is none of the newest surface; the next
    /// request makes it.
    bool want_sheet(bool wanted);
    /// Of the newest surface, or null.
    std::shared_ptr<const AtlasSheet> sheet() const;
    /// The stages of the pipeline, as of the newest picture.
    StageRecords records() const;

    /// Patches are laid out, and pairs shown until then (app/editor/work/atlas.h).
    bool laying_out() const;

    bool idle() const { return worker_.idle() && errands_.idle(); }
    void wait() const;
    std::optional<std::string> take_problem();

  private:
    /// The atlas that the recipe asks for, where pairs are shown until it is there.
    struct OwnAtlas {
        std::uint64_t mesh = 0;
        std::unique_ptr<Pipeline> pipeline{};
        std::shared_ptr<const MeshPose> pose{};
        std::shared_ptr<EditSurface> surface{};
        std::shared_ptr<const SurfacePick> pick{};
    };

    void work(const WorkerRequest& request, const std::stop_token& stop);
    bool take_mesh();
    void announce(std::shared_ptr<EditSurface> surface);
    void take_pose(std::shared_ptr<const MeshPose> pose);
    AtlasOptions take_atlas(const AtlasOptions& wanted);
    void give_errands(const Recipe& recipe, bool moving);
    void begin_atlas(const Recipe& recipe);
    void lay_out(std::uint64_t mesh, const std::shared_ptr<const MeshPose>& pose,
                 std::unique_ptr<Pipeline> pipeline, const std::stop_token& stop);
    void publish_normals();
    void publish_pick(const std::shared_ptr<const EditSurface>& surface);
    void publish_sheet();
    void publish_picture(const WorkerRequest& request, std::uint32_t level,
                         const Image<Rgb8>& texels, double seconds);

    std::function<void()> wake_;
    double budget_;
    std::uint64_t requests_ = 0;

    mutable std::mutex mutex_;  ///< of the next twelve
    std::optional<Mesh> next_mesh_;
    std::optional<std::shared_ptr<const MeshPose>> next_pose_;
    std::optional<OwnAtlas> own_;         ///< laid out, and not shown yet
    std::optional<AtlasOptions> begun_;   ///< what is being laid out
    std::optional<std::string> problem_;  ///< of that
    std::shared_ptr<const EditSurface> surface_, coming_;
    std::shared_ptr<const EditPicture> picture_;
    std::shared_ptr<const SurfacePick> pick_;
    bool unseen_ = false;  ///< the last mesh has no picture at level 0 yet
    bool wants_sheet_ = false;
    std::shared_ptr<const AtlasSheet> sheet_;
    SheetKey sheet_key_;
    StageRecords records_;
    std::uint64_t numbers_ = 0;

    std::unique_ptr<Pipeline> pipeline_;  ///< the worker's alone, as the rest
    std::uint64_t mesh_ = 0;              ///< its number
    std::shared_ptr<const MeshPose> pose_;
    EditLevels make_levels_;
    std::optional<LevelChoice> choice_;
    AtlasOptions shown_atlas_;
    bool shown_bumps_ = false;
    bool fresh_ = true;                     ///< no surface of this mesh was made
    std::shared_ptr<EditSurface> pending_;  ///< to be shown with its first picture
    std::shared_ptr<const SurfacePick> pending_pick_;
    std::uint64_t errands_of_ = 0;                ///< the surface whose errands were given
    std::optional<AtlasOptions> laid_out_;        ///< what the pipeline has instead of pairs
    std::shared_ptr<const Image<Rgb8>> normals_;  ///< of the surface
    std::optional<Recipe> finest_;                ///< of the last picture of this mesh at level 0

    EditErrands errands_;
    EditWorker worker_;  ///< last: it sees all the others
};

}  // namespace burl
