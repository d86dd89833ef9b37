#pragma once
// Thumbnails of the presets for the editor's gallery: balls drawn by the ray-exact renderer on a
// thread of its own when they are asked for, and kept until the light changes.
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/jobs/worker.h"
#include "app/light/prefilter.h"
#include "app/recipe/recipe.h"
#include "atlas/base/image.h"

namespace burl {

/// Light that balls are drawn in: an environment's, prefiltered once for all of them; null: the
/// headlight.
using BallLight = std::shared_ptr<const PrefilteredLight>;

/// Draws a lit ball with the recipe's texture that touches all four sides of a picture of side x
/// side pixels, side >= 1; pixels outside the circle have no meaning. Bit-identical for every
/// thread count. `filter` is that of `burl render --direct`. Throws Error(unsupported) for a recipe
/// that cannot be drawn.
Image<Rgb8> ball_picture(const Recipe& recipe, int side, const std::string& filter = "trapezoid",
                         const BallLight& light = nullptr);

/// Returns the picture, which must be square with a power of two as its side, and its MIP levels
/// down to one pixel, as means of sRGB codes. OpenGL's software renderer would compile a program
/// before its first MIP level, and a frame would wait.
std::vector<Image<Rgb8>> picture_levels(Image<Rgb8> picture);

/// Draws and caches thumbnails in the background. All functions may be called by one thread.
class EditThumbnails {
  public:
    /// `wake` is called by the drawing thread after every picture.
    explicit EditThumbnails(std::function<void()> wake);

    /// Sets the light. Thumbnails in another light are shown until they are asked for again and
    /// made anew; those that wait are dropped.
    void set_light(BallLight light);
    /// The thumbnail of a preset; null: not ready. Where there is none in the light that was set,
    /// it is queued behind those asked for before. It stays null where the preset cannot be drawn.
    std::shared_ptr<const Image<Rgb8>> picture(const std::string& preset, int side);
    /// While held, no thumbnail is begun.
    void hold(bool held) { jobs_.hold(held); }
    /// Whether no thumbnail is being drawn or queued.
    bool idle() const { return jobs_.idle(); }
    void wait() const { jobs_.wait(); }

  private:
    using Key = std::pair<std::string, int>;
    struct Thumbnail {
        std::shared_ptr<const Image<Rgb8>> picture;  ///< null: queued, or cannot be drawn
        int light = 0;                               ///< in which it was last asked for
    };
    void make(const Key& key, const BallLight& light, int number);

    std::function<void()> wake_;
    std::mutex mutex_;
    // `mutex_` guards the members up to jobs_.
    std::map<Key, Thumbnail> pictures_;
    BallLight light_;
    int light_number_ = 1;
    JobQueue jobs_;  ///< last member: its thread uses all the others
};

}  // namespace burl
