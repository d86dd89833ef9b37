#pragma once
// The baking thread of the editor: it owns the pipeline, takes the latest mesh, pose and recipe,
// and publishes pictures, coarse MIP levels first, in a front buffer.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/editor/jobs/atlas.h"
#include "app/editor/jobs/front_buffer.h"
#include "app/editor/jobs/worker.h"
#include "app/pipeline/refinement.h"

namespace burl {

/// Bakes on a worker thread; BVHs and patch atlases are made on the thread of a job queue. All
/// public functions are called by one thread, the user interface's.
class EditBaker {
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
    /// Sets whether a window shows the atlas's sheet. Returns true where that begins now: the sheet
    /// is missing then, and the next request() makes it.
    bool want_sheet(bool wanted) { return front_.want_sheet(wanted); }
    /// Requests textures of `recipe`; a `moving` slider gets one quick coarse level. Returns the
    /// request's number, from 1 on, which its pictures carry in EditPicture::request.
    std::uint64_t request(const Recipe& recipe, bool moving, const SynthesisWish& synthesis = {}) {
        worker_.request({recipe, moving, synthesis, ++requests_});
        return requests_;
    }
    /// Takes a context for OpenGL's synthesis (EditSynthesizer::offer). Pictures that it made must
    /// not outlive this.
    void offer(std::unique_ptr<GlContext> context, bool software) {
        synthesizer_.offer(std::move(context), software);
    }
    /// Whether there is such a context.
    bool has_context() const { return synthesizer_.has_context(); }

    /// What was published.
    const FrontBuffer& front() const { return front_; }

    /// Whether the last mesh has no picture at level 0 yet and the worker is busy with it.
    bool opening() const;
    /// Whether the recipe's own atlas is being laid out in the background while a quad atlas is
    /// shown (app/editor/jobs/atlas.h).
    bool laying_out() const { return own_atlas_.busy(); }
    /// While held, the job queue starts no job: BVHs and the recipe's own atlas wait until pictures
    /// are on screen.
    void hold_jobs(bool held) { jobs_.hold(held); }
    /// Whether neither the worker nor the job queue has anything to do.
    bool idle() const { return worker_.idle() && jobs_.idle(); }
    /// Blocks until idle().
    void wait() const;
    /// Returns and clears the message of the last failure, of a request or of a background job.
    std::optional<std::string> take_problem();

  private:
    void work(const WorkerRequest& request, const std::stop_token& stop);
    bool take_mesh();
    void take_pose(std::shared_ptr<const MeshPose> pose);
    AtlasOptions take_atlas(const AtlasOptions& wanted);
    void renew_surface(const Recipe& recipe, bool posed);
    /// A level that is not published yet.
    struct MadeLevel {
        const Image<Rgb8>* texels;  ///< of the pipeline, until it makes that level again
        std::shared_ptr<const EditMaterial> material;
    };
    bool make_resident(const WorkerRequest& request);
    std::optional<MadeLevel> make_level(std::uint32_t level, const std::stop_token& stop);
    bool bake_levels(const WorkerRequest& request, bool better, const std::stop_token& stop);
    void publish(EditPicture picture);
    void publish_normals();
    void publish_sheet();
    void queue_jobs(const Recipe& recipe, bool moving);
    void report(std::string problem);

    EditSynthesizer synthesizer_;  ///< outlives the pictures, which its context made

    // wake_ and budget_ are constant; requests_ belongs to the thread that calls request().
    std::function<void()> wake_;
    double budget_;
    std::uint64_t requests_ = 0;

    // `mutex_` guards next_mesh_, next_pose_, unseen_ and problem_.
    mutable std::mutex mutex_;
    std::optional<Mesh> next_mesh_;  ///< mesh set by set_mesh(), not yet taken by the worker
    /// Pose set by set_pose(), not yet taken by the worker; a null pose removes the old one.
    std::optional<std::shared_ptr<const MeshPose>> next_pose_;
    bool unseen_ = false;                 ///< the last mesh has no picture at level 0 yet
    std::optional<std::string> problem_;  ///< failure of a background job or of a pose

    // The members from pipeline_ to finest_ belong to the worker's thread alone: no lock.
    std::unique_ptr<Pipeline> pipeline_;    ///< pipeline of the atlas shown
    std::uint64_t mesh_ = 0;                ///< number of the mesh, from 1 on
    std::shared_ptr<const MeshPose> pose_;  ///< pose of the mesh; null: none
    EditLevels make_levels_;                ///< converter to OpenGL's format
    std::optional<LevelChoice> choice_;     ///< chooses the level to bake while a slider moves
    AtlasOptions shown_atlas_;              ///< atlas in `pipeline_`
    bool shown_bumps_ = false;              ///< whether the surface has bumps
    bool bumps_made_ = false;  ///< whether OpenGL made their normal map with the last picture
    std::array<int, material_slots.size()> shown_maps_ = no_material_maps;  ///< the surface's
    std::shared_ptr<const EditMaterial> material_;                          ///< the newest level's
    bool fresh_ = true;          ///< no surface of this mesh was made yet
    bool posed_ = false;         ///< the pose was taken, and its surface not yet announced
    std::uint64_t jobs_of_ = 0;  ///< number of the surface whose background jobs were queued
    std::optional<AtlasOptions> laid_out_;  ///< the recipe's own atlas, once `pipeline_` has it
    std::shared_ptr<const Image<Rgb8>> normals_;  ///< newest normal map of the surface
    std::optional<Recipe> finest_;                ///< recipe of the mesh's last picture at level 0

    FrontBuffer front_;
    JobQueue jobs_;
    BackgroundAtlas own_atlas_;
    EditWorker worker_;  ///< last member: its thread uses all the others
};

}  // namespace burl
