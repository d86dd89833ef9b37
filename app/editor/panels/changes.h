#pragma once
// Dirty rectangles of the user interface: the parts of the screen where a frame of Dear ImGui's
// draw lists differs from the last one, so that only they are drawn again. A software OpenGL takes
// longer to draw the user interface than the host takes to synthesise a texture.
#include <imgui.h>

#include <functional>
#include <vector>

namespace burl {

/// Rectangle in Dear ImGui's screen coordinates, y down.
struct ScreenRect {
    ImVec2 low{}, high{};
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
};
/// The intersection of two rectangles, which may be empty().
ScreenRect common(const ScreenRect& a, const ScreenRect& b);

/// Dirty rectangles from one frame to the next.
class ScreenChanges {
  public:
    /// The dirty rectangles of a frame: outside of them the last call's frame and this one show the
    /// same. They may overlap. still(texture) tells whether the texture's texels have not changed
    /// since the last call. The whole screen is dirty at the first call, and when the screen's size
    /// or scale or the number of draw commands has changed.
    std::vector<ScreenRect> update(const ImDrawData& data,
                                   const std::function<bool(ImTextureID)>& still);

  private:
    struct Triangle {
        ImDrawVert corners[3];
    };
    /// Triangles of one draw command, with its clip rectangle and texture.
    struct Piece {
        ScreenRect clip{};
        ImTextureID texture{};
        std::vector<Triangle> triangles{};
    };
    static std::vector<Piece> pieces_of(const ImDrawData& data);
    static ScreenRect extent(const Piece& piece, std::size_t begin, std::size_t end);
    static void compare(const Piece& before, const Piece& now, std::vector<ScreenRect>& changes);

    std::vector<Piece> last_;
    ImVec2 size_{}, scale_{};
};

}  // namespace burl
