#pragma once
// The picking structure of a surface part of the way to its pose. A bounding volume hierarchy does
// not follow moving vertices, so it is built anew in the background once the slider rests.
#include <memory>
#include <mutex>

#include "app/editor/jobs/baker.h"
#include "app/editor/jobs/worker.h"

namespace burl {

/// Builds picking structures on a thread of its own. All functions may be called by one thread.
class EditPosedPick {
  public:
    /// `wake` is called by the worker's thread when a structure is ready.
    explicit EditPosedPick(std::function<void()> wake);

    /// Sets what the window shows, once a frame: a surface that has gone `share` of the way to its
    /// pose. While the slider is `moving`, no structure is begun.
    void follow(const std::shared_ptr<const EditSurface>& surface, double share, bool moving);
    /// The picking structure of this surface at this share; null: not ready.
    std::shared_ptr<const SurfacePick> pick(const std::shared_ptr<const EditSurface>& surface,
                                            double share) const;

    bool idle() const { return worker_.idle(); }
    void wait() const { worker_.wait(); }

  private:
    /// The surface and share that a structure is built for.
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
