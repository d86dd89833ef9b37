#include "app/editor/jobs/node_pictures.h"

#include <utility>

#include <fmt/format.h>

#include "app/edit/look.h"
#include "app/editor/jobs/thumbnails.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::size_t most_drawn = 600;  // pictures kept, of some 12 KB each

}  // namespace

NodePictures::NodePictures(std::function<void()> wake) : wake_(std::move(wake)) {}

void NodePictures::request(const Recipe& recipe, const std::string& mesh,
                           const std::vector<std::string>& places, int side) {
    const auto shared = std::make_shared<const Recipe>(recipe);
    for (const std::string& place : places)
        jobs_.add([this, shared, mesh, place, side](const std::stop_token& stop) {
            if (!stop.stop_requested()) make(*shared, mesh, place, side);
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

/// Averages would be grey where a node is finer than the ball's pixels.
NodePictures::Picture NodePictures::drawn_on_ball(const Recipe& look, int side) {
    return std::make_shared<const Image<Rgb8>>(ball_picture(look, side, "none"));
}

NodePictures::Picture NodePictures::drawn_on_mesh(const Recipe& look, const std::string& mesh,
                                                  int side) {
    if (std::exchange(mesh_path_, mesh) != mesh) {
        mesh_.reset();
        mesh_.emplace(mesh);
    }
    return mesh_ ? std::make_shared<const Image<Rgb8>>(mesh_->picture(look, side)) : nullptr;
}

void NodePictures::make(const Recipe& recipe, const std::string& mesh, const std::string& place,
                        int side) {
    std::string key;
    Picture picture;
    try {
        Recipe look = look_at(recipe, place).recipe;
        const bool masked = reads_masks(look);
        look.name.clear();
        look.about.clear();
        look.atlas = {};
        key = fmt::format("{} {} {}", side, masked ? mesh : "", to_json(look));
        picture = known(key);
        if (!picture)
            picture = masked ? drawn_on_mesh(look, mesh, side) : drawn_on_ball(look, side);
    } catch (const Error&) {  // a node that cannot be drawn by itself has no picture
    }
    {
        const std::scoped_lock lock(mutex_);
        places_[place] = picture;
        if (drawn_.size() >= most_drawn) drawn_.clear();
        if (picture) drawn_[key] = std::move(picture);
    }
    wake_();
}

}  // namespace burl
