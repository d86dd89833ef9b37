#pragma once
// The viewport: the window of the object, with the camera and the tools on its surface.
#include <functional>
#include <memory>

#include "app/editor/jobs/coarse.h"
#include "app/editor/jobs/requests.h"
#include "app/editor/panels/move.h"
#include "app/editor/panels/paint.h"
#include "app/editor/window/atlas.h"
#include "app/editor/window/imgui.h"
#include "app/editor/window/light.h"
#include "app/editor/window/object.h"

namespace burl {

/// Wall-clock times of a frame's parts on the user interface's thread, in seconds.
struct FrameTimes {
    double panels = 0.0;  ///< input, panels and everything but drawing
    double object = 0.0;  ///< uploading the surface and the texture, and drawing the object
    double screen = 0.0;  ///< drawing the user interface
    /// Processor time of the user interface's thread for `panels` and uploads, whatever the load.
    double worked = 0.0;
};

/// Draws the object and handles the pointer over it. All functions are called by the user
/// interface's thread.
class ObjectViewport {
  public:
    /// `wake` is called by another thread when a BVH is ready.
    ObjectViewport(const GladGLContext& gl, EditSession& session, const EditBaker& baker,
                   TextureRequests& requests, GlEditAtlas& atlas, std::function<void()> wake);

    EditCamera camera{};
    bool lit = true, turntable = false;
    EditLight light;
    EditPaint paint;
    EditMove move;

    /// Switches a tool (`paint.tool.on` or `move.on`) on or off; the other tool goes off.
    void take_tool(bool& tool);
    /// Follows the pose's weight on screen and the light, at the beginning of a frame.
    void follow();
    /// Draws the window at the place set for ImGui's next window. `opening`: whether a mesh is
    /// being opened. Adds to `times`. Returns whether the frame after this one must be drawn, too.
    bool window(EditItems& items, bool opening, FrameTimes& times);

    GlEditObject& object() { return object_; }
    const GlEditObject& object() const { return object_; }
    /// The image of the object in the frame's user interface; no target: none.
    const GlImGui::OpaqueImage& image() const { return image_; }
    /// The BVH of the surface on screen; null: not ready.
    std::shared_ptr<const SurfacePick> pick() const;

    bool idle() const { return posed_pick_.idle() && coarse_.idle() && light.idle(); }
    void wait() const {
        posed_pick_.wait();
        coarse_.wait();
        light.wait();
    }

  private:
    ObjectView view(const ImVec2& low, const ImVec2& size) const;
    void input(const ImVec2& low, const ImVec2& size, EditItems& items);
    void move_camera(const ImVec2& size);
    bool is_rough(bool opening) const;
    bool comes_to_rest() const;
    void follow_coarse(bool opening);
    ObjectViewOptions options(const PictureSize& size, bool rough) const;
    void draw(const ImVec2& low, const ImVec2& size, bool rough, FrameTimes& times);
    void prepare(const PictureSize& size);

    EditSession& session_;
    const EditBaker& baker_;
    TextureRequests& requests_;
    GlEditAtlas& atlas_;
    bool is_software_;  ///< whether the processor draws
    bool moving_camera_ = false;
    std::shared_ptr<const GlLight> light_;  ///< of this frame; null: the headlight
    Vec2d size_{0.0};                       ///< of the view in the last frame
    double share_ = 0.0;                    ///< share of the way to the pose that is shown, 0 to 1
    EditPosedPick posed_pick_;
    EditCoarse coarse_;
    GlEditObject object_;
    GlImGui::OpaqueImage image_{};
};

}  // namespace burl
