#pragma once
// The texture that the editor's window shows: that of the edited recipe, or while comparing that of
// the recipe as it was opened.
#include <cstdint>
#include <optional>

#include "app/editor/jobs/baker.h"
#include "app/editor/session/session.h"

namespace burl {

/// Requests textures of the recipe on screen. All functions are called by the user interface's
/// thread.
class TextureRequests {
  public:
    TextureRequests(EditSession& session, EditBaker& baker) : session_(session), baker_(baker) {}

    /// Begins to show the recipe as it was opened, or ends that; an edit ends it, too.
    void compare();
    bool comparing() const { return comparing_; }
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
    EditSession& session_;
    EditBaker& baker_;
    bool comparing_ = false;
    Recipe compared_;  ///< the session's recipe when comparing began; another recipe ends it
    std::optional<WorkerRequest> requested_;
    std::uint64_t last_ = 0;
};

}  // namespace burl
