#include "app/editor/jobs/node_pictures.h"

#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/edit/look.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::size_t most_drawn = 600;  // pictures kept, of some 12 KB each

}  // namespace

NodePictures::NodePictures(std::function<void()> wake) : wake_(std::move(wake)) {}

void NodePictures::set_light(BallLight light) {
    {
        const std::scoped_lock lock(mutex_);
        if (light_ == light) return;
        light_ = std::move(light);
        drawn_.clear();
    }
    cancel();
}

void NodePictures::request(const Recipe& recipe, const std::string& mesh,
                           const std::vector<std::string>& places, int side) {
    const auto shared = std::make_shared<const Recipe>(recipe);
    const std::scoped_lock lock(mutex_);
    for (const std::string& place : places)
        jobs_.add(
            [this, ball = Ball{shared, mesh, place, side, light_}](const std::stop_token& stop) {
                if (!stop.stop_requested()) make(ball);
            });
}

NodePictures::Picture NodePictures::picture(const std::string& place) const {
    const std::scoped_lock lock(mutex_);
    const auto found = places_.find(place);
    return found == places_.end() ? nullptr : found->second;
}

NodePictures::Picture NodePictures::known(const std::string& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = drawn_.find(key);
    return found == drawn_.end() ? nullptr : found->second;
}

NodePictures::Picture NodePictures::drawn_on_mesh(const Recipe& look, const std::string& mesh,
                                                  int side) {
    if (std::exchange(mesh_path_, mesh) != mesh) {
        mesh_.reset();
        mesh_.emplace(mesh);
    }
    return mesh_ ? std::make_shared<const Image<Rgb8>>(mesh_->picture(look, side)) : nullptr;
}

void NodePictures::make(const Ball& ball) {
    std::string key;
    Picture picture;
    try {
        Recipe look = look_at(*ball.recipe, ball.place).recipe;
        const bool masked = reads_masks(look);
        look.name.clear();
        look.about.clear();
        look.atlas = {};
        key = fmt::format("{} {} {}", ball.side, masked ? ball.mesh : "", to_json(look));
        picture = known(key);
        if (!picture)
            // Averages would be grey where a node is finer than the ball's pixels.
            picture = masked ? drawn_on_mesh(look, ball.mesh, ball.side)
                             : std::make_shared<const Image<Rgb8>>(
                                   ball_picture(look, ball.side, "none", ball.light));
    } catch (const Error&) {  // a node that cannot be drawn by itself has no picture
    } catch (const std::bad_alloc&) {
    }
    {
        const std::scoped_lock lock(mutex_);
        if (ball.light != light_) return;
        places_[ball.place] = picture;
        if (drawn_.size() >= most_drawn) drawn_.clear();
        if (picture) drawn_[key] = std::move(picture);
    }
    wake_();
}

}  // namespace burl
