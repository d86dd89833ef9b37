#include "app/editor/jobs/requests.h"

#include <utility>

#include "app/recipe/edit/keyed_recipe.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::size_t opened = 2;

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
    looked_at_.clear();
    look_.reset();
    const auto& kept = session_.kept;
    const bool any = kept[0] || kept[1];
    std::size_t next = compared_with_ ? *compared_with_ + 1 : any ? 0 : opened;
    while (next < opened && !kept[next]) ++next;
    if (next > opened || (next == opened && any))
        compared_with_.reset();
    else
        compared_with_ = next;
    compared_ = session_.recipe();
}

void TextureRequests::look(std::string place) {
    compared_with_.reset();
    looked_at_ = std::move(place);
    look_.reset();
}

std::string TextureRequests::shown_words() const {
    if (!compared_with_) return "";
    if (*compared_with_ == opened) return "as it was opened";
    return *compared_with_ == 0 ? "kept as A" : "kept as B";
}

std::optional<std::array<double, 2>> TextureRequests::look_range() const {
    return look_ ? look_->second.range : std::nullopt;
}

/// Shows the node that is looked at; the recipe where there is no such node any more.
const Recipe& TextureRequests::looked() {
    const Recipe& still = session_.still();
    if (look_ && look_->first == still) return look_->second.recipe;
    try {
        look_.emplace(still, look_at(still, looked_at_));
        return look_->second.recipe;
    } catch (const Error&) {
        looked_at_.clear();
        look_.reset();
        return still;
    }
}

Recipe TextureRequests::recipe() {
    if (!looked_at_.empty()) return looked();
    if (!compared_with_) return session_.still();
    const std::optional<Recipe>* kept =
        *compared_with_ < opened ? &session_.kept[*compared_with_] : nullptr;
    if (kept && *kept) return still_of(**kept, session_.time());
    return still_of(session_.history().opened(), session_.time());
}

void TextureRequests::update(bool sheet) {
    if (baker_.want_sheet(sheet)) requested_.reset();
    if (compared_with_ && compared_ != session_.recipe()) compared_with_.reset();
    WorkerRequest wanted{recipe(), session_.moving(), synthesis};
    wanted.recipe.pose = {};
    const bool same = requested_ && requested_->recipe == wanted.recipe &&
                      requested_->synthesis == wanted.synthesis &&
                      (requested_->moving == wanted.moving || !requested_->moving);
    if (same) return;
    requested_ = wanted;
    last_ = baker_.request(wanted.recipe, wanted.moving, synthesis);
}

}  // namespace burl
