#pragma once
// The baking thread of the editor: it owns the pipeline, takes meshes and recipes, and publishes
// what the windows show - the newest surface and the newest texture, coarse MIP levels first.
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/editor/jobs/levels.h"
#include "app/editor/jobs/worker.h"
#include "app/measure/atlas_sheet.h"
#include "app/pipeline/level_choice.h"
#include "app/pipeline/pipeline.h"
#include "app/scene/surface_pick.h"
#include "atlas/read/pose.h"

namespace burl {

/// The mesh under one layout of its atlas, ready to be drawn.
struct EditSurface {
    std::uint64_t number = 0;     ///< unique for every layout, from the counter that pictures share
    Scene scene{};                ///< the geometry, without textures (app/gl/draw/view_scene.h)
    std::vector<Mat4d> frames{};  ///< one per surface of the scene (app/scene/unit_frame.h)
    Sphere sphere{};
    Affine3 unit_from_mesh{};  ///< solid_from_mesh of SolidSpace::unit
    std::uint32_t size = 0;    ///< side of the texture at level 0, in texels
    std::size_t triangles = 0;
    std::string atlas{};  ///< name of the atlas kind
    bool posed = false;   ///< whether the scene has morph targets
};

/// A texture baked for the surface whose number is `surface`, at one MIP level.
struct EditPicture {
    std::uint64_t number = 0, surface = 0, request = 0;
    std::uint32_t level = 0;  ///< MIP level; 0 is the finest
    Image<Rgb8> texels{};
    /// `texels` in OpenGL's format, with the coarser MIP levels.
    std::vector<Image<Rgba8>> levels{};
    double seconds = 0.0;  ///< time it took to bake, in seconds
    /// Normal map of the bumps; null: no bumps, or not baked yet.
    std::shared_ptr<const Image<Rgb8>> normals{};
};

/// Bakes on a worker thread and runs a background job queue on another. All public functions are
/// called by one thread, the user interface's.
class EditBaker {
    /// The inputs that decide the content of a sheet.
    struct SheetKey {
        std::uint64_t surface = 0;
        SolidSpace space = SolidSpace::unit;
        bool operator==(const SheetKey&) const = default;
    };

  public:
    /// `wake` is called by the worker threads whenever something new was published. `budget`:
    /// seconds that baking may take while a slider moves.
    explicit EditBaker(std::function<void()> wake, double budget = 0.03);
    /// Stops the jobs under way and waits for both threads.
    ~EditBaker();

    /// Replaces the mesh and drops its pose; the next request() bakes textures for it.
    void set_mesh(Mesh mesh);
    /// Replaces the mesh's pose (null: no pose). Poses leave the texture unchanged: the next
    /// request() publishes a new surface. A pose of a mesh with another number of triangles is
    /// reported by take_problem().
    void set_pose(std::shared_ptr<const MeshPose> pose);
    /// Requests textures of `recipe`; a `moving` slider gets one quick coarse level. Returns the
    /// request's number, from 1 on, which its pictures carry in EditPicture::request.
    std::uint64_t request(const Recipe& recipe, bool moving) {
        worker_.request({recipe, moving, ++requests_});
        return requests_;
    }

    /// The newest surface; null: none yet.
    std::shared_ptr<const EditSurface> surface() const;
    /// The newest texture; null: none yet.
    std::shared_ptr<const EditPicture> picture() const;
    /// The surface that replaces surface() with its first picture, so that it can be uploaded
    /// meanwhile; null: none.
    std::shared_ptr<const EditSurface> coming() const;
    /// Whether the last mesh has no picture at level 0 yet and the worker is busy with it.
    bool opening() const;
    /// While held, the job queue starts no job: picking structures and the recipe's own atlas wait
    /// until pictures are on screen.
    void hold_errands(bool held) { errands_.hold(held); }
    /// The picking structure (BVH) of the newest surface; null, or an older surface's (scene() then
    /// belongs to that one), until the newest surface's first picture is published and its BVH
    /// built.
    std::shared_ptr<const SurfacePick> pick() const;
    /// Sets whether a window shows the atlas's sheet. Returns true where that begins now: the sheet
    /// is missing then, and the next request() makes it.
    bool want_sheet(bool wanted);
    /// The atlas sheet of the newest surface; null: none, or none wanted.
    std::shared_ptr<const AtlasSheet> sheet() const;
    /// Records of the pipeline's stages, taken when the newest picture was published.
    StageRecords records() const;

    /// Whether the recipe's own atlas is being laid out in the background while a quad atlas is
    /// shown (app/editor/jobs/atlas.h).
    bool laying_out() const;

    /// Whether neither the worker nor the job queue has anything to do.
    bool idle() const { return worker_.idle() && errands_.idle(); }
    /// Blocks until idle().
    void wait() const;
    /// Returns and clears the message of the last failure, of a request or of a background job.
    std::optional<std::string> take_problem();

  private:
    /// The atlas that the recipe asks for, laid out in the background while a quad atlas is shown.
    struct OwnAtlas {
        /// Number (`mesh_`) of the mesh that was laid out: the atlas of an older mesh is dropped.
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

    // wake_ and budget_ are constant; requests_ belongs to the thread that calls request().
    std::function<void()> wake_;
    double budget_;
    std::uint64_t requests_ = 0;

    // `mutex_` guards next_mesh_, next_pose_, own_, begun_, problem_, surface_, coming_, picture_,
    // pick_, unseen_, wants_sheet_, sheet_, sheet_key_, records_ and numbers_: all threads share
    // them.
    mutable std::mutex mutex_;
    std::optional<Mesh> next_mesh_;  ///< mesh set by set_mesh(), not yet taken by the worker
    /// Pose set by set_pose(), not yet taken by the worker; a null pose removes the old one.
    std::optional<std::shared_ptr<const MeshPose>> next_pose_;
    std::optional<OwnAtlas> own_;  ///< atlas laid out in the background and not shown yet
    /// Atlas for which a background job was queued and not taken yet.
    std::optional<AtlasOptions> begun_;
    std::optional<std::string> problem_;  ///< failure of a background job or of a pose
    std::shared_ptr<const EditSurface> surface_, coming_;  ///< the surface shown, and its successor
    std::shared_ptr<const EditPicture> picture_;
    std::shared_ptr<const SurfacePick> pick_;
    bool unseen_ = false;       ///< the last mesh has no picture at level 0 yet
    bool wants_sheet_ = false;  ///< a window shows the sheet
    std::shared_ptr<const AtlasSheet> sheet_;
    SheetKey sheet_key_;  ///< inputs that `sheet_` was made from
    StageRecords records_;
    std::uint64_t numbers_ = 0;  ///< counter of surfaces and pictures

    // The members from pipeline_ to finest_ belong to the worker's thread alone: no lock.
    std::unique_ptr<Pipeline> pipeline_;    ///< pipeline of the atlas shown
    std::uint64_t mesh_ = 0;                ///< number of the mesh, from 1 on
    std::shared_ptr<const MeshPose> pose_;  ///< pose of the mesh; null: none
    EditLevels make_levels_;                ///< converter to OpenGL's format
    std::optional<LevelChoice> choice_;     ///< chooses the level to bake while a slider moves
    AtlasOptions shown_atlas_;              ///< atlas in `pipeline_`
    bool shown_bumps_ = false;              ///< whether the surface has bumps
    bool fresh_ = true;                     ///< no surface of this mesh was made yet
    std::shared_ptr<EditSurface> pending_;  ///< announced surface, published with its first picture
    /// BVH of `pending_`, where it was built in the background.
    std::shared_ptr<const SurfacePick> pending_pick_;
    std::uint64_t errands_of_ = 0;  ///< number of the surface whose background jobs were queued
    std::optional<AtlasOptions> laid_out_;  ///< the recipe's own atlas, once `pipeline_` has it
    std::shared_ptr<const Image<Rgb8>> normals_;  ///< newest normal map of the surface
    std::optional<Recipe> finest_;                ///< recipe of the mesh's last picture at level 0

    EditErrands errands_;  ///< background job queue, on a thread of its own
    EditWorker worker_;    ///< last member: its thread uses all the others
};

}  // namespace burl
