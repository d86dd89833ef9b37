#include "app/editor/window/atlas.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/widgets/keys.h"
#include "app/editor/window/imgui.h"

namespace burl {

namespace {

constexpr std::size_t most_lines = 4000;  ///< the longest outline drawn in every frame
/// Largest distance of a pointer in a gutter from the chart it picks.
constexpr double reach_texels = 4.0;
constexpr ImU32 mark_color = IM_COL32(255, 230, 60, 255), hidden_color = IM_COL32(255, 230, 60, 90),
                dark = IM_COL32(0, 0, 0, 200);

ImVec2 screen_point(const Vec2d& place) {
    return {float(place.x), float(place.y)};
}

void cross(ImDrawList& list, const ImVec2& at, ImU32 color) {
    constexpr float inner = 4.0f, outer = 11.0f;
    for (const auto& [line, width] : {std::pair(dark, 3.5f), std::pair(color, 1.5f)})
        for (const float sign : {-1.0f, 1.0f}) {
            list.AddLine({at.x + sign * inner, at.y}, {at.x + sign * outer, at.y}, line, width);
            list.AddLine({at.x, at.y + sign * inner}, {at.x, at.y + sign * outer}, line, width);
        }
}

/// Whether no other surface lies between the eye and a point of the surface, within 1 % of the
/// scene's radius. `place` is the point's position on the screen.
bool is_seen(const ObjectView& view, const Vec3d& point, const Vec3d& place) {
    const auto first = hit_at(view, Vec2d(place));
    const Vec3d eye = camera_of(view).eye;
    return !first ||
           glm::distance(first->point, eye) > glm::distance(point, eye) - 1e-2 * view.sphere.radius;
}

std::int64_t texel_of(double coordinate, std::uint32_t side) {
    return std::int64_t(std::floor(coordinate * side));
}

}  // namespace

GlEditSheet::GlEditSheet(const GladGLContext& gl)
    : gl_(&gl),
      program_(make_full_screen_program(
          gl, "the atlas view",
          ShaderSource().add("color/srgb_encode.glsl").add("draw/sheet.frag"))),
      pass_(gl) {}

const GlTexture* GlEditSheet::draw(const std::shared_ptr<const SheetPicture>& picture,
                                   const SheetViewOptions& options) {
    if (!picture || picture->levels.empty()) return nullptr;
    if (picture != picture_) {
        texture_ = upload_levels(*gl_, picture->levels, GL_SRGB8);
        picture_ = picture;
        ++uploads_;
    }
    return draw(texture_, std::uint32_t(picture->levels.front().width()), uploads_, options);
}

const GlTexture* GlEditSheet::draw(const GlTexture& texture, std::uint32_t side,
                                   std::uint64_t number, const SheetViewOptions& options) {
    if (options.size.x <= 0 || options.size.y <= 0) return nullptr;
    const Drawn now{texture.get(), number, options};
    if (drawn_ == now) return &shown_->texture();
    if (!shown_ || shown_->size() != options.size)
        shown_.emplace(*gl_, options.size, std::initializer_list<GLenum>{GL_RGBA8});
    const int coarsest = int(std::bit_width(std::max(side, 1U))) - 1;
    const Vec2d size(options.size);
    shown_->bind();
    program_.use();
    program_.set("image", 0);
    program_.set("uv_low", glm::vec2(uv_at(options.frame, size, Vec2d(0.0))));
    program_.set("uv_per_pixel", glm::vec2(float(1.0 / pixels_per_unit(options.frame, size))));
    program_.set("level", std::clamp(options.level, 0, coarsest));
    bind_texture(*gl_, 0, texture);
    pass_.draw();
    check_gl(*gl_, "drawing the atlas");
    drawn_ = now;
    return &shown_->texture();
}

void GlEditSheet::release() {
    picture_.reset();
    texture_ = {};
    shown_.reset();
    drawn_.reset();
}

GlEditAtlas::GlEditAtlas(const GladGLContext& gl, std::function<void()> wake)
    : maker_(std::move(wake)), sheet_(gl) {}

bool GlEditAtlas::shortcuts() {
    if (pressed("V")) state.shown = !state.shown;
    if (pressed("W")) edges = !edges;
    if (pressed("B")) borders = !borders;
    if (!state.shown || !pointer_ || !pressed("F")) return false;
    state.frame = {};
    return true;
}

void GlEditAtlas::follow(const FrontBuffer& baked, std::uint64_t request, const Recipe& recipe) {
    ViewWish wish;
    if (state.shown || edges || borders) wish.lines = baked.surface();
    if (state.shown) {
        wish.sheet = baked.sheet();
        wish.mode = state.mode;
    } else {
        sheet_.release();
        pointer_.reset();
        on_atlas_.reset();
        on_object_.reset();
    }
    if (state.shown && state.mode == SheetMode::error) {
        const auto picture = baked.picture();
        late_ = !picture || picture->request != request || picture->level != 0;
        if (!late_) {
            wish.picture = picture;
            wish.recipe = picture == maker_.wish().picture ? maker_.wish().recipe
                                                           : std::make_shared<const Recipe>(recipe);
        }
    }
    maker_.request(std::move(wish));
}

std::shared_ptr<const SheetPicture> GlEditAtlas::picture() const {
    const auto picture = maker_.picture();
    const ViewWish& wish = maker_.wish();
    const bool fits = picture && picture->of.mode == wish.mode && picture->of.sheet == wish.sheet;
    return fits ? picture : nullptr;
}

void GlEditAtlas::look_at_object(const ObjectView& view) {
    on_object_.reset();
    if (!state.shown || !ImGui::IsItemHovered()) return;
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    on_object_ = hit_at(view, {pointer.x, pointer.y});
}

/// Returns the outline of the chart that was hit; empty where it is too long to draw in every
/// frame.
std::span<const BorderLine> GlEditAtlas::outline(const SurfaceHit& hit) const {
    const auto lines = maker_.lines();
    if (!lines || hit.surface >= lines->charts.size()) return {};
    const std::vector<std::uint32_t>& charts = lines->charts[hit.surface];
    if (hit.triangle >= charts.size()) return {};
    const auto outline = lines->outline(charts[hit.triangle]);
    return outline.size() <= most_lines ? outline : std::span<const BorderLine>{};
}

void GlEditAtlas::mark_object(const ObjectView& view) const {
    if (!on_atlas_ || !view.pick) return;
    const Camera camera = camera_of(view);
    const auto seen = [&](const Vec3d& p) { return on_screen(view, p); };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const BorderLine& rest : outline(*on_atlas_)) {
        const BorderLine border = rest.at(view.share);
        const Vec3d from = seen(border.line.from), to = seen(border.line.to);
        if (from.z <= 0.0 || to.z <= 0.0) continue;
        const Vec3d middle = 0.5 * (border.line.from + border.line.to);
        const bool faces = glm::dot(border.normal, camera.eye - border.line.from) > 0.0 &&
                           is_seen(view, middle, seen(middle));
        list.AddLine(screen_point(Vec2d(from)), screen_point(Vec2d(to)),
                     faces ? mark_color : hidden_color, faces ? 1.5f : 1.0f);
    }
    const Vec3d place = seen(on_atlas_->point);
    if (place.z > 0.0)
        cross(list, screen_point(Vec2d(place)),
              is_seen(view, on_atlas_->point, place) ? mark_color : hidden_color);
}

void GlEditAtlas::mark_atlas(const Vec2d& low, const Vec2d& size) const {
    const std::optional<SurfaceHit>& hit = on_object_ ? on_object_ : on_atlas_;
    if (!hit) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](const Vec2d& uv) {
        return screen_point(low + pixel_at(state.frame, size, uv));
    };
    for (const BorderLine& border : outline(*hit))
        list.AddLine(at(border.from_uv), at(border.to_uv), mark_color, 1.5f);
    if (on_object_) cross(list, at(hit->uv), mark_color);
}

void GlEditAtlas::input(const Vec2d& low, const Vec2d& size, const SurfacePick* pick,
                        std::uint32_t side) {
    const ImGuiIO& io = ImGui::GetIO();
    const Vec2d pixel = Vec2d(io.MousePos.x, io.MousePos.y) - low;
    if (ImGui::IsItemActive())
        state.frame = panned(state.frame, size, {io.MouseDelta.x, io.MouseDelta.y});
    pointer_.reset();
    on_atlas_.reset();
    if (!ImGui::IsItemHovered()) return;
    if (io.MouseWheel != 0.0f) state.frame = zoomed(state.frame, size, pixel, io.MouseWheel);
    if (ImGui::IsMouseDoubleClicked(0)) state.frame = {};
    pointer_ = uv_at(state.frame, size, pixel);
    if (pick && side > 0) on_atlas_ = pick->at(*pointer_, reach_texels / side);
}

/// Returns the texture to show: the object's, or a picture of the atlas.
const GlTexture* GlEditAtlas::draw(const GlEditObject& object, const Vec2d& size) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    SheetViewOptions options{
        {int(size.x * double(scale.x)), int(size.y * double(scale.y))}, state.frame, state.level};
    if (state.mode != SheetMode::texture) return sheet_.draw(picture(), options);
    const GlTexture* texture = object.texture();
    if (!texture) return nullptr;
    // Level 0 of the uploaded picture is level picture()->level of the texture.
    options.level -= int(object.picture()->level);
    return sheet_.draw(*texture, object.picture()->side, object.picture()->number, options);
}

std::optional<TexelView> GlEditAtlas::texel(const FrontBuffer& baked, const GlEditObject& object,
                                            std::uint32_t side) const {
    std::optional<Vec2d> uv = pointer_;
    if (!uv && on_object_) uv = on_object_->uv;
    if (!uv || glm::any(glm::lessThan(*uv, Vec2d(0.0))) ||
        glm::any(glm::greaterThanEqual(*uv, Vec2d(1.0))))
        return {};
    TexelView view{texel_of(uv->x, side), texel_of(uv->y, side)};
    if (const auto sheet = baked.sheet()) view.facts = texel_facts(*sheet, view.x, view.y);
    const auto at = [&](const auto& image) {
        return image(std::size_t(uv->x * double(image.width())),
                     std::size_t(uv->y * double(image.height())));
    };
    if (const EditPicture* shown = object.picture(); shown && shown->texels.width() > 0)
        view.color = at(shown->texels);
    if (const auto error = picture(); error && error->codes.width() > 0 && at(error->codes) >= 0.0f)
        view.error = double(at(error->codes));
    return view;
}

void GlEditAtlas::panel(const PanelContext& context, const FrontBuffer& baked,
                        const GlEditObject& object, const SurfacePick* pick) {
    const auto surface = baked.surface();
    const std::uint32_t side = surface ? surface->size : 1;
    atlas_controls(context, state, int(std::bit_width(side)) - 1);
    const ImVec2 low = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const ImVec2 size(room.x, room.y - atlas_footer_height());
    const auto shown = state.mode == SheetMode::texture ? nullptr : picture();
    if (size.x >= 8.0f && size.y >= 8.0f) {
        ImGui::InvisibleButton("atlas", size,
                               ImGuiButtonFlags_MouseButtonLeft |
                                   ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
        context.items.note("atlas view");
        const Vec2d corner(low.x, low.y), extent(size.x, size.y);
        input(corner, extent, pick, side);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 high(low.x + size.x, low.y + size.y);
        list.PushClipRect(low, high, true);
        if (const GlTexture* texture = draw(object, extent))
            list.AddImage(imgui_texture(*texture), low, high);
        mark_atlas(corner, extent);
        list.PopClipRect();
    }
    atlas_legend(state.mode, shown.get(), late_ && state.mode == SheetMode::error);
    if (shown && !shown->problem.empty())
        ImGui::TextWrapped("%s", shown->problem.c_str());
    else
        atlas_readout(texel(baked, object, side));
}

}  // namespace burl
