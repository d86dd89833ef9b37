#include "app/editor/jobs/thumbnails.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

#include "app/direct/picture.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// Returns the distance in radii at which a ball slightly exceeds the view's height, so that its
/// rim is not seen as a polygon.
double filling_distance() {
    const double half = 0.5 * vertical_field_of_view_degrees * std::numbers::pi / 180.0;
    return 0.985 / std::sin(half);
}

std::uint8_t mean(int a, int b, int c, int d) {
    return static_cast<std::uint8_t>((a + b + c + d + 2) / 4);
}

/// Halves a square picture by means of 2 x 2 codes.
Image<Rgb8> halved(const Image<Rgb8>& fine) {
    const std::size_t side = std::max<std::size_t>(fine.width() / 2, 1);
    Image<Rgb8> coarse(side, side);
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
            const Rgb8 &a = fine(2 * x, 2 * y), &b = fine(2 * x + 1, 2 * y),
                       &c = fine(2 * x, 2 * y + 1), &d = fine(2 * x + 1, 2 * y + 1);
            coarse(x, y) = {mean(a.r, b.r, c.r, d.r), mean(a.g, b.g, c.g, d.g),
                            mean(a.b, b.b, c.b, d.b)};
        }
    return coarse;
}

}  // namespace

std::vector<Image<Rgb8>> picture_levels(Image<Rgb8> picture) {
    std::vector<Image<Rgb8>> levels{std::move(picture)};
    while (levels.back().width() > 1) levels.push_back(halved(levels.back()));
    return levels;
}

Image<Rgb8> ball_picture(const Recipe& recipe, int side, const std::string& filter,
                         const BallLight& light) {
    DirectOptions options;
    options.scene = "sample:icosphere";
    options.view = fmt::format("50,25,{}", filling_distance());
    options.size = fmt::format("{}x{}", side, side);
    if (!light) options.light.light = "headlight";
    if (recipe.precision.kind != PrecisionKind::fixed) options.filter = filter;
    return DirectPicture(options, light)({recipe, {}});
}

EditThumbnails::EditThumbnails(std::function<void()> wake) : wake_(std::move(wake)) {}

void EditThumbnails::set_light(BallLight light) {
    {
        const std::scoped_lock lock(mutex_);
        if (light_ == light) return;
        light_ = std::move(light);
        ++light_number_;
    }
    jobs_.cancel();
}

std::shared_ptr<const Image<Rgb8>> EditThumbnails::picture(const std::string& preset, int side) {
    const std::scoped_lock lock(mutex_);
    const Key key{preset, side};
    Thumbnail& thumbnail = pictures_[key];
    if (thumbnail.light != light_number_) {
        thumbnail.light = light_number_;
        jobs_.add([this, key, light = light_, number = light_number_](const std::stop_token&) {
            make(key, light, number);
        });
    }
    return thumbnail.picture;
}

void EditThumbnails::make(const Key& key, const BallLight& light, int number) {
    std::shared_ptr<const Image<Rgb8>> picture;
    try {
        picture = std::make_shared<Image<Rgb8>>(
            ball_picture(load_recipe(key.first), key.second, "trapezoid", light));
    } catch (const Error&) {  // a recipe that cannot be drawn has no thumbnail
    } catch (const std::bad_alloc&) {
    }
    {
        const std::scoped_lock lock(mutex_);
        Thumbnail& thumbnail = pictures_[key];
        if (thumbnail.light == number) thumbnail.picture = std::move(picture);
    }
    wake_();
}

}  // namespace burl
