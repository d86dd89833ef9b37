#pragma once
// The texture that the editor's window shows: that of the edited recipe, of a state to compare it
// with, or of one node alone.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "app/edit/look.h"
#include "app/editor/jobs/baker.h"
#include "app/editor/session/session.h"

namespace burl {

/// Requests textures of the recipe on screen. All functions are called by the user interface's
/// thread.
class TextureRequests {
  public:
    TextureRequests(EditSession& session, EditBaker& baker) : session_(session), baker_(baker) {}

    /// Shows the next of the states to compare with, or after the last one the recipe itself: the
    /// kept states A and B or, where none is kept, the recipe as it was opened. An edit shows the
    /// recipe, too.
    void compare();
    bool comparing() const { return compared_with_.has_value(); }
    /// Who makes the textures from the next update() on.
    SynthesisWish synthesis{};

    /// Shows what the node at a place gives, on the whole object, through all edits until the place
    /// has none; an empty place ends that.
    void look(std::string place);
    const std::string& looking_at() const { return looked_at_; }
    /// The numbers that are black and white in that; empty where they are 0 and 1, or colours.
    std::optional<std::array<double, 2>> look_range() const;
    /// The name of what is on screen in the recipe's place, such as "as it was opened"; empty: the
    /// recipe.
    std::string shown_words() const;
    /// The recipe on screen, without animation.
    Recipe recipe();

    /// Requests the texture of the recipe on screen unless that was done. `sheet`: whether a window
    /// shows the atlas's sheet.
    void update(bool sheet);
    /// Has the next update() request the texture in any case.
    void forget() { requested_.reset(); }
    /// The number of the last request, and its recipe after update(). The pose's weight is left
    /// out: it changes no texel.
    std::uint64_t last() const { return last_; }
    const Recipe& last_recipe() const { return requested_->recipe; }

  private:
    const Recipe& looked();

    EditSession& session_;
    EditBaker& baker_;
    /// The state compared with: 0 and 1 are the kept ones, 2 is what was opened.
    std::optional<std::size_t> compared_with_;
    Recipe compared_;        ///< the session's recipe when comparing began; another one ends it
    std::string looked_at_;  ///< place of a node; empty: none
    std::optional<std::pair<Recipe, NodeLook>> look_;  ///< a recipe, and its look at the place
    std::optional<WorkerRequest> requested_;
    std::uint64_t last_ = 0;
};

}  // namespace burl
