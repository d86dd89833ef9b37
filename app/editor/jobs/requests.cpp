#include "app/editor/jobs/requests.h"

#include "app/recipe/edit/keyed_recipe.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// Evaluates a recipe's animation at a time; a recipe invalid at that time is returned unevaluated.
Recipe still_of(const Recipe& recipe, double seconds) {
    try {
        return recipe_at(recipe, seconds);
    } catch (const Error&) {
        return recipe;
    }
}

}  // namespace

void TextureRequests::compare() {
    comparing_ = !comparing_;
    compared_ = session_.recipe();
}

Recipe TextureRequests::recipe() {
    return comparing_ ? still_of(session_.history().opened(), session_.time()) : session_.still();
}

void TextureRequests::update(bool sheet) {
    if (baker_.want_sheet(sheet)) requested_.reset();
    if (comparing_ && compared_ != session_.recipe()) comparing_ = false;
    WorkerRequest wanted{recipe(), session_.moving()};
    wanted.recipe.pose = {};
    const bool same = requested_ && requested_->recipe == wanted.recipe &&
                      (requested_->moving == wanted.moving || !requested_->moving);
    if (same) return;
    requested_ = wanted;
    last_ = baker_.request(wanted.recipe, wanted.moving);
}

}  // namespace burl
