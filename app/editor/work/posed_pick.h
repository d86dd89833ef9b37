#pragma once
// What finds places on a surface on its way to a pose, made beside the user interface once the
// slider rests: a tree of boxes follows no vertex.
#include <memory>
#include <mutex>

#include "app/editor/work/baker.h"
#include "app/editor/work/worker.h"

namespace burl {

class EditPosedPick {
  public:
    /// `wake` is called by another thread when there is a new one.
    explicit EditPosedPick(std::function<void()> wake);

    /// Once a frame: what is shown. While it is `moving` none is begun.
    void follow(const std::shared_ptr<const EditSurface>& surface, double share, bool moving);
    /// Of this surface and share; null: not yet.
    std::shared_ptr<const SurfacePick> pick(const std::shared_ptr<const EditSurface>& surface,
                                            double share) const;

    bool idle() const { return worker_.idle(); }
    void wait() const { worker_.wait(); }

  private:
    struct Wish {
        std::shared_ptr<const EditSurface> surface{};  ///< null: none
        double share = 0.0;
        bool operator==(const Wish&) const = default;
    };
    void work();

    Wish asked_;
    mutable std::mutex mutex_;  ///< of the next two
    Wish wish_;
    std::shared_ptr<const SurfacePick> pick_;
    EditWorker worker_;  ///< last: it sees all the others
};

}  // namespace burl
