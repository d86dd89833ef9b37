#pragma once
// Small pictures of the presets for the editor's gallery: balls, drawn by the ray-exact renderer on
// a thread of its own when they are first asked for, and kept.
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/work/errands.h"
#include "app/recipe/recipe.h"
#include "atlas/base/image.h"

namespace burl {

/// A lit ball of the recipe's texture that touches all four sides of a picture of side x side
/// pixels, side >= 1; what lies outside the circle is of no meaning. Bit-identical for every thread
/// count. Throws Error(unsupported) for a recipe that cannot be drawn.
Image<Rgb8> ball_picture(const Recipe& recipe, int side);

/// The picture and its MIP levels, of means of codes, down to a side of one pixel: a software
/// OpenGL that makes levels compiles a program for it first, and a frame waits.
std::vector<Image<Rgb8>> picture_levels(Image<Rgb8> picture);

/// All functions may be called by one thread.
class EditThumbnails {
  public:
    /// `wake` is called by another thread after every picture.
    explicit EditThumbnails(std::function<void()> wake);

    /// A preset's ball; null: it is not ready, and is made after those asked for before it. Null
    /// for ever where it cannot be drawn.
    std::shared_ptr<const Image<Rgb8>> picture(const std::string& preset, int side);
    /// While held, no picture is begun.
    void hold(bool held) { errands_.hold(held); }
    /// Nothing is under way or waits.
    bool idle() const { return errands_.idle(); }
    void wait() const { errands_.wait(); }

  private:
    using Key = std::pair<std::string, int>;
    void make(const Key& key);

    std::function<void()> wake_;
    std::mutex mutex_;
    std::map<Key, std::shared_ptr<const Image<Rgb8>>> pictures_;  ///< null: asked for
    EditErrands errands_;                                         ///< last: it sees all the others
};

}  // namespace burl
