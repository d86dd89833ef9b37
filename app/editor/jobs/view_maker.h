#pragma once
// Pictures of the atlas and edge lines of the object, which the editor's views show besides the
// texture: made on a thread of its own, and only while a view shows them.
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/jobs/front_buffer.h"
#include "app/editor/jobs/worker.h"
#include "app/measure/atlas_sheet.h"
#include "app/measure/texture_error.h"
#include "app/scene/surface_lines.h"

namespace burl {

/// The content that the views show; a null part is not wanted.
struct ViewWish {
    std::shared_ptr<const EditSurface> lines{};  ///< surface whose edges are drawn
    std::shared_ptr<const AtlasSheet> sheet{};   ///< atlas sheet to be made into a picture
    SheetMode mode = SheetMode::texture;         ///< kind of picture; `texture` needs none
    /// Mode `error` compares the texture at level 0 with its recipe. Null: not available yet.
    std::shared_ptr<const EditPicture> picture{};
    std::shared_ptr<const Recipe> recipe{};
    bool operator==(const ViewWish&) const = default;
};

/// A picture of the atlas for the wish `of`.
struct SheetPicture {
    ViewWish of{};
    std::vector<Image<Rgb8>> levels{};  ///< MIP levels; empty where there is a problem
    Image<float> codes{};  ///< mode `error` only, as `largest` and `rms` are: TextureError
    double largest = 0.0, rms = 0.0;
    std::string problem{};  ///< one sentence why there is no picture; empty: none
};

/// Makes pictures and lines on a worker thread. All functions may be called by one thread.
class EditViewMaker {
  public:
    /// `wake` is called by the worker's thread when something new is ready.
    explicit EditViewMaker(std::function<void()> wake);

    /// Replaces the wish; work for another wish is given up.
    void request(ViewWish wish);
    const ViewWish& wish() const { return wish_; }

    /// The newest picture of the atlas; null: none yet.
    std::shared_ptr<const SheetPicture> picture() const;
    /// The lines of the surface wished for; null: not ready.
    std::shared_ptr<const SurfaceLines> lines() const;

    bool idle() const { return worker_.idle(); }
    void wait() const { worker_.wait(); }
    std::optional<std::string> take_problem() { return worker_.take_problem(); }

  private:
    void work(const std::stop_token& stop);
    void make_lines(const std::shared_ptr<const EditSurface>& surface);
    void make_picture(const ViewWish& wish, const std::stop_token& stop);

    ViewWish wish_;  ///< last wish requested; the calling thread's alone

    // `mutex_` guards next_, picture_, surface_ and lines_.
    mutable std::mutex mutex_;
    ViewWish next_;  ///< wish that the worker serves next
    std::shared_ptr<const SheetPicture> picture_;
    std::shared_ptr<const EditSurface> surface_;  ///< surface whose edges `lines_` are
    std::shared_ptr<const SurfaceLines> lines_;

    EditWorker worker_;  ///< last member: its thread uses all the others
};

}  // namespace burl
