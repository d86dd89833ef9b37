#pragma once
// What the editor's views show besides the texture itself - pictures of the atlas, and lines over
// the object - made on a thread of its own, and only while somebody looks.
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/work/baker.h"
#include "app/editor/work/worker.h"
#include "app/measure/atlas_sheet.h"
#include "app/measure/texture_error.h"
#include "app/scene/surface_lines.h"

namespace burl {

/// What is looked at; null or empty parts: nothing of that kind.
struct ViewWish {
    std::shared_ptr<const EditSurface> lines{};  ///< whose edges
    std::shared_ptr<const AtlasSheet> sheet{};   ///< whose picture
    SheetMode mode = SheetMode::texture;         ///< with `texture` there is no picture
    /// Of mode `error`: the texture at level 0, and its recipe. Null: no picture yet.
    std::shared_ptr<const EditPicture> picture{};
    std::shared_ptr<const Recipe> recipe{};
    bool operator==(const ViewWish&) const = default;
};

/// A picture of the atlas.
struct SheetPicture {
    ViewWish of{};
    std::vector<Image<Rgb8>> levels{};  ///< none: there is a problem
    Image<float> codes{};               ///< of mode `error`, as the next two (TextureError)
    double largest = 0.0, rms = 0.0;
    std::string problem{};  ///< why there is no picture, one sentence
};

class EditViewMaker {
  public:
    /// `wake` is called by another thread whenever there is something new.
    explicit EditViewMaker(std::function<void()> wake);

    /// From now on this; what is under way for another wish is given up.
    void request(ViewWish wish);
    const ViewWish& wish() const { return wish_; }

    /// The newest; null: none yet.
    std::shared_ptr<const SheetPicture> picture() const;
    /// Of the surface wished for; null: not yet.
    std::shared_ptr<const SurfaceLines> lines() const;

    bool idle() const { return worker_.idle(); }
    void wait() const { worker_.wait(); }
    std::optional<std::string> take_problem() { return worker_.take_problem(); }

  private:
    void work(const std::stop_token& stop);
    void make_lines(const std::shared_ptr<const EditSurface>& surface);
    void make_picture(const ViewWish& wish, const std::stop_token& stop);

    ViewWish wish_;

    mutable std::mutex mutex_;  ///< of the next four
    ViewWish next_;
    std::shared_ptr<const SheetPicture> picture_;
    std::shared_ptr<const EditSurface> surface_;  ///< of the lines
    std::shared_ptr<const SurfaceLines> lines_;

    EditWorker worker_;  ///< last: it sees all the others
};

}  // namespace burl
