#pragma once
// The surfaces that the editor draws: a mesh under one layout of its atlas, and the BVHs by which
// points on it are picked.
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/editor/jobs/worker.h"
#include "app/scene/surface_pick.h"
#include "atlas/read/pose.h"

namespace burl {

struct SceneParts;

/// Crease angle of the surface's normals, the default of `burl bake`.
inline constexpr double edit_crease_degrees = 40.0;

/// The mesh under one layout of its atlas, ready to be drawn.
struct EditSurface {
    std::uint64_t number = 0;     ///< unique for every layout, from the counter that pictures share
    Scene scene{};                ///< the geometry, without textures (app/gl/draw/view_scene.h)
    std::vector<Mat4d> frames{};  ///< one per surface of the scene (app/scene/scene.h)
    Sphere sphere{};
    Affine3 unit_from_mesh{};  ///< solid_from_mesh of SolidSpace::unit
    std::uint32_t size = 0;    ///< side of the texture at level 0, in texels
    std::size_t triangles = 0;
    std::string atlas{};  ///< name of the atlas kind
    bool posed = false;   ///< whether the scene has morph targets
};

/// Returns the surface of a mesh that was laid out, without its number. `pose` (null: none) becomes
/// the scene's morph targets.
std::shared_ptr<EditSurface> edit_surface(const SceneParts& parts, const MeshPose* pose);

/// Builds the BVH of a surface that has gone `share` of the way to its pose, 0 to 1. The BVH keeps
/// the surface alive.
std::shared_ptr<const SurfacePick> pick_of(const std::shared_ptr<const EditSurface>& surface,
                                           double share = 0.0);

/// Builds BVHs of a surface part of the way to its pose on a thread of its own: a BVH does not
/// follow moving vertices, so it is built anew once the slider rests. All functions may be called
/// by one thread.
class EditPosedPick {
  public:
    /// `wake` is called by the worker's thread when a BVH is ready.
    explicit EditPosedPick(std::function<void()> wake);

    /// Sets what the window shows, once a frame: a surface that has gone `share` of the way to its
    /// pose. While the slider is `moving`, no BVH is begun.
    void follow(const std::shared_ptr<const EditSurface>& surface, double share, bool moving);
    /// The BVH of this surface at this share; null: not ready.
    std::shared_ptr<const SurfacePick> pick(const std::shared_ptr<const EditSurface>& surface,
                                            double share) const;

    bool idle() const { return worker_.idle(); }
    void wait() const { worker_.wait(); }

  private:
    /// The surface and share that a BVH is built for.
    struct Wish {
        std::shared_ptr<const EditSurface> surface{};  ///< null: none
        double share = 0.0;
        bool operator==(const Wish&) const = default;
    };
    void work();

    Wish asked_;  ///< wish of the last follow(); the calling thread's alone
    // `mutex_` guards wish_ and pick_.
    mutable std::mutex mutex_;
    Wish wish_;
    std::shared_ptr<const SurfacePick> pick_;
    EditWorker worker_;  ///< last member: its thread uses all the others
};

}  // namespace burl
