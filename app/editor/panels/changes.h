#pragma once
// Where a frame of Dear ImGui's lists differs from the last one, so that only that is drawn again:
// a software OpenGL takes longer for the user interface than a texture's synthesis does.
#include <imgui.h>

#include <functional>
#include <vector>

namespace burl {

/// In ImGui's screen coordinates, y down.
struct ScreenRect {
    ImVec2 low{}, high{};
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
};
ScreenRect common(const ScreenRect& a, const ScreenRect& b);

class ScreenChanges {
  public:
    /// Rectangles outside of which the screen still shows what these lists say, given that it shows
    /// what the last call's do; they may overlap. `still`: whether a texture has the texels that it
    /// had then. Everything at the first call and whenever the screen's size is another one.
    std::vector<ScreenRect> update(const ImDrawData& data,
                                   const std::function<bool(ImTextureID)>& still);

  private:
    struct Triangle {
        ImDrawVert corners[3];
    };
    /// What one command draws.
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
