#include "app/editor/window/viewport.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/base/stopwatch.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace {

constexpr double degrees_per_second = 20.0;  // of the turntable

}  // namespace

ObjectViewport::ObjectViewport(const GladGLContext& gl, EditSession& session,
                               const EditBaker& baker, TextureRequests& requests,
                               GlEditAtlas& atlas, std::function<void()> wake)
    : light(gl, wake),
      session_(session),
      baker_(baker),
      requests_(requests),
      atlas_(atlas),
      is_software_(is_software(gl)),
      posed_pick_(wake),
      coarse_(std::move(wake)),
      object_(gl) {}

void ObjectViewport::take_tool(bool& tool) {
    const bool on = !tool;
    paint.tool.on = move.on = false;
    tool = on;
    if (move.on) ImGui::SetWindowFocus("Object");  // the arrow keys belong to the tool
}

void ObjectViewport::follow() {
    light.light();
    const auto& surface = object_.surface();
    share_ = surface && surface->posed ? requests_.recipe().pose.weight : 0.0;
    posed_pick_.follow(surface, share_, session_.moving());
}

std::shared_ptr<const SurfacePick> ObjectViewport::pick() const {
    const auto& surface = object_.surface();
    if (!surface) return nullptr;
    if (share_ != 0.0) return posed_pick_.pick(surface, share_);
    auto pick = baker_.front().pick();
    if (pick && &pick->scene() != &surface->scene) pick.reset();  // it belongs to another surface
    return pick;
}

ObjectView ObjectViewport::view(const ImVec2& low, const ImVec2& size) const {
    ObjectView view;
    view.pick = pick();
    view.share = share_;
    view.camera = camera;
    view.low = {double(low.x), double(low.y)};
    view.size = {double(size.x), double(size.y)};
    const auto& surface = object_.surface();
    if (view.pick) view.sphere = surface->sphere;
    if (surface) view.unit_from_mesh = surface->unit_from_mesh;
    if (surface && session_.recipe().solid.space == SolidSpace::unit)
        view.solid_from_mesh = surface->unit_from_mesh;
    return view;
}

void ObjectViewport::input(const ImVec2& low, const ImVec2& size, EditItems& items) {
    ImGui::InvisibleButton("object", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    items.note("object");
    atlas_.look_at_object(view(low, size));
    const bool paints = paint.input(view(low, size), session_);
    const bool moves = move.input(view(low, size), session_);
    moving_camera_ = ImGui::IsItemActive() && !paints && !moves;
    move_camera(size);
    const bool points = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (points && paint.tool.on && !moving_camera_)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);  // a cross
    else if (points && (move.on || moving_camera_))
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

void ObjectViewport::move_camera(const ImVec2& size) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto shorter = double(std::min(size.x, size.y));
    if (moving_camera_ && ImGui::IsMouseDown(0))
        camera = orbited(camera, {io.MouseDelta.x, io.MouseDelta.y}, shorter);
    else if (moving_camera_)
        camera = panned(camera, {io.MouseDelta.x, io.MouseDelta.y}, shorter);
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0f) {
        const ImVec2 low = ImGui::GetItemRectMin(), at = io.MousePos;
        camera = zoomed(camera, double(io.MouseWheel),
                        {at.x - low.x - 0.5f * size.x, at.y - low.y - 0.5f * size.y}, shorter);
    }
    if (turntable) {
        camera = orbited(camera, {-degrees_per_second * double(io.DeltaTime), 0.0}, 180.0);
        moving_camera_ = true;
    }
}

/// Whether a finer level will replace the texture on screen soon, or the first texture of an opened
/// mesh has just come: supersampling waits for the next frame.
bool ObjectViewport::is_rough(bool opening) const {
    const EditPicture* picture = object_.picture();
    return picture && (picture->level > 0 || (opening && !baker_.opening()));
}

/// Whether movement has ended and its last texture is not on screen yet: that frame is drawn first,
/// and supersampling waits for the next one.
bool ObjectViewport::comes_to_rest() const {
    const auto newest = baker_.front().picture();
    const EditPicture* shown = object_.picture();
    if (!shown || object_.drawn_samples() != 1) return false;
    return shown != newest.get() || (shown->request < requests_.last() && !baker_.idle());
}

/// Has coarse surfaces made where the processor draws, once the surface shown has its finest
/// texture.
void ObjectViewport::follow_coarse(bool opening) {
    if (!is_software_) return;
    if (!opening) coarse_.follow(object_.surface());
    object_.show_coarse(coarse_.surfaces(object_.surface()));
}

/// The view at rest; `rough`: with one sample per pixel, by the coarse surfaces if there are any,
/// and where the processor draws triangles, with half as many pixels a side.
ObjectViewOptions ObjectViewport::options(const PictureSize& size, bool rough) const {
    ObjectViewOptions options;
    options.size = size;
    options.camera = camera;
    options.lit = lit;
    options.light = lit ? light_ : nullptr;
    options.share = share_;
    options.edges = atlas_.edges;
    options.borders = atlas_.borders;
    options.supersample = rough ? 1 : 2;
    options.every_layer = !rough && !is_software_;  // 1 to 3 s by the processor
    options.coarse = rough;
    options.half = rough && is_software_ && !object_.has_coarse() &&
                   (moving_camera_ || !object_.keeps_places(options));
    return options;
}

void ObjectViewport::draw(const ImVec2& low, const ImVec2& size, bool rough, FrameTimes& times) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const PictureSize pixels{int(size.x * scale.x), int(size.y * scale.y)};
    const double began = thread_seconds();
    light_ = light.light();
    const GlTexture* texture = object_.draw(options(pixels, rough));
    if (!rough && !object_.drawing()) prepare(pixels);
    times.worked -= thread_seconds() - began;
    if (!texture) return;
    image_ = {object_.target(), !object_.drew()};
    ImGui::GetWindowDrawList()->AddImage(imgui_texture(*texture), low,
                                         {low.x + size.x, low.y + size.y});
}

/// Makes the first frame of a slider that moves ready, while nothing does.
void ObjectViewport::prepare(const PictureSize& size) {
    if (object_.drew()) return;
    object_.prepare(options(size, true));
}

bool ObjectViewport::window(EditItems& items, bool opening, FrameTimes& times) {
    bool rests = false;
    image_ = {};
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    if (ImGui::Begin("Object", nullptr,
                     fixed_window | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNavInputs)) {
        const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
        if (size.x >= 1.0f && size.y >= 1.0f) {
            input(low, size, items);
            timed(times.object, [&] {
                rests = comes_to_rest();
                const FrontBuffer& front = baker_.front();
                object_.show(front.surface(), front.picture(), front.coming());
                follow_coarse(opening);
                object_.show_lines(object_.uploading() ? nullptr : atlas_.lines());
                const bool resized =
                    std::exchange(size_, Vec2d(size.x, size.y)) != Vec2d(size.x, size.y);
                rests |= resized;
                const bool rough =
                    moving_camera_ || session_.moving() || is_rough(opening) || rests;
                // The first picture of all waits for its light, which takes half a second.
                if (!lit || !light.begins()) draw(low, size, rough, times);
                rests |= object_.drawing();
            });
            if (const EditPicture* picture = object_.picture())
                coarse_sign(items, low, size, picture->level);
            paint.draw(view(low, size));
            move.draw(view(low, size), session_, items);
            atlas_.mark_object(view(low, size));
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
    return rests;
}

}  // namespace burl
