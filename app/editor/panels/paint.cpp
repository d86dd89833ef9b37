#include "app/editor/panels/paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "app/edit/paint_layers.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/slider.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace {

constexpr float slider_width = 150.0f;

/// A number of the brush: its name, its range and what it means.
struct BrushNumber {
    const char* label;
    SliderRange range;
    const char* sentence;
    SliderScale scale = SliderScale::linear;
};

void brush_row(const PanelContext& context, double& value, const BrushNumber& number) {
    slide(fmt::format("##{}", number.label).c_str(), value, number.range, number.scale, "%.3f");
    value = std::clamp(value, number.range.low, number.range.high);
    context.items.note(fmt::format("paint.{}", number.label));
    tip(number.sentence);
    ImGui::SameLine();
    ImGui::TextUnformatted(number.label);
}

void modes(const PanelContext& context, PaintMode& mode) {
    if (radio_button(context.items, "paint", "paint.paint", mode == PaintMode::paint))
        mode = PaintMode::paint;
    tip("Lays the colour over the texture, or raises the mask.");
    ImGui::SameLine();
    if (radio_button(context.items, "erase", "paint.erase", mode == PaintMode::erase))
        mode = PaintMode::erase;
    tip("Uncovers the texture again, or lowers the mask (X).");
}

std::string layer_words(int layer) {
    return layer == 0 ? "the colour" : fmt::format("mask {}", layer);
}

/// Chooses the layer that the brush paints into: the colour over the texture, or a mask.
void layer_row(const PanelContext& context, int& layer) {
    std::vector<int> layers = paint_layers(context.session.recipe());
    layers.insert(layers.begin(), 0);
    if (std::ranges::count(layers, layer) == 0) layers.push_back(layer);
    const bool open = ImGui::BeginCombo("##into", layer_words(layer).c_str());
    context.items.note("paint.into");
    tip("What the brush paints: colour over the texture, or a mask, which is what a node paint of "
        "the graph gives. A new node begins a new mask.");
    if (open) {
        for (const int one : layers) {
            if (ImGui::Selectable(layer_words(one).c_str(), one == layer)) layer = one;
            context.items.note(fmt::format("paint.into={}", one));
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    ImGui::TextUnformatted("into");
}

/// The number of the layer's strokes, and the button that takes them away.
void strokes_row(const PanelContext& context, int layer) {
    const auto strokes =
        std::size_t(std::ranges::count(context.session.recipe().paint, layer, &PaintStroke::layer));
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%zu stroke%s", strokes, strokes == 1 ? "" : "s");
    ImGui::SameLine();
    if (ImGui::Button("Clear") && strokes > 0) clear_paint(context.session, layer);
    context.items.note("paint.clear");
    tip("Takes the paint of this layer away, as one step.");
}

constexpr int brush_points = 48;
constexpr Rgb8 mask_ring{0x40, 0xc0, 0xff};
constexpr int most_steps = 200;  // limit of points between two pointer positions

double solid_units(const ObjectView& view) {
    return glm::length(view.solid_from_mesh.linear[0]);
}

/// Returns the pixels per solid unit at a surface point.
double pixels_per_unit(const ObjectView& view, const SurfaceHit& hit) {
    return 0.5 * view.size.y * camera_of(view).focal_y / (hit.depth * solid_units(view));
}

}  // namespace

void clear_paint(EditSession& session, std::optional<int> layer) {
    Recipe recipe = session.recipe();
    std::erase_if(recipe.paint, [&](const PaintStroke& stroke) {
        return stroke.layer == layer.value_or(stroke.layer);
    });
    session.history().end_gesture();
    session.history().change(std::move(recipe));
}

void paint_shortcuts(PaintTool& tool) {
    if (!tool.on) return;
    if (pressed("Comma")) tool = resized(tool, -1);
    if (pressed("Period")) tool = resized(tool, 1);
    if (pressed("X"))
        tool.brush.mode = tool.brush.mode == PaintMode::erase ? PaintMode::paint : PaintMode::erase;
}

void paint_panel(const PanelContext& context, PaintTool& tool, const ImVec2& low) {
    if (!tool.on) return;
    if (begin_tool_window("Paint (P)", tool.on, low)) {
        ImGui::PushItemWidth(slider_width * float(interface_scale()));
        layer_row(context, tool.brush.layer);
        modes(context, tool.brush.mode);
        brush_row(context, tool.brush.radius,
                  {"radius",
                   {least_brush_radius, largest_brush_radius},
                   "The ball's radius in solid units (comma, period).",
                   SliderScale::logarithmic});
        brush_row(context, tool.brush.hardness,
                  {"hardness", {0.0, 1.0}, "The share of the ball that is covered evenly."});
        brush_row(context, tool.brush.opacity,
                  {"opacity", {0.0, 1.0}, "How much a stroke covers what is below it."});
        if (tool.brush.layer == 0) {
            edit_color("colour", tool.brush.color);
            context.items.note("paint.colour");
        }
        ImGui::PopItemWidth();
        strokes_row(context, tool.brush.layer);
    }
    ImGui::End();
}

/// Paints along the surface from the last pointer position to this one, so that fast strokes have
/// no gaps.
void EditPaint::lead_to(const ObjectView& view, EditSession& session, const Vec2d& pointer) {
    const std::optional<SurfaceHit> hit = hit_at(view, pointer);
    if (!hit) {
        last_.reset();
        return;
    }
    const Vec2d from = last_.value_or(pointer);
    const double pixels = glm::distance(pointer, from);
    const double step = std::max(0.5, 0.5 * tool.brush.radius * pixels_per_unit(view, *hit));
    const int steps = std::clamp(int(std::ceil(pixels / step)), 1, most_steps);
    Recipe recipe = session.recipe();
    bool leads = last_.has_value();
    for (int k = 1; k <= steps; ++k) {
        const auto place = hit_at(view, glm::mix(from, pointer, double(k) / steps));
        if (place)
            recipe =
                painted_at(std::move(recipe), tool, view.solid_from_mesh(place->mesh_point), leads);
        leads = place.has_value();
    }
    last_ = pointer;
    session.history().change(std::move(recipe));
}

bool EditPaint::input(const ObjectView& view, EditSession& session) {
    const ImGuiIO& io = ImGui::GetIO();
    EditHistory& history = session.history();
    const bool began = tool.on && ImGui::IsItemActivated() && ImGui::IsMouseClicked(0) &&
                       !io.KeyAlt && !io.KeyCtrl && hit_at(view, pointer_now());
    if (began) {
        painting_ = true;
        last_.reset();
        history.begin_gesture();
    }
    if (!painting_) return false;
    if (ImGui::IsMouseDown(0) && tool.on && history.in_gesture())  // undo has not ended the stroke
        lead_to(view, session, pointer_now());
    else {
        painting_ = false;
        history.end_gesture();
    }
    return true;
}

void EditPaint::draw(const ObjectView& view) const {
    const Vec2d pointer = pointer_now();
    if (!tool.on || !is_over(view, pointer)) return;
    const auto hit = hit_at(view, pointer);
    if (!hit) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto ring = [&](double radius, ImU32 color, float width) {
        std::vector<ImVec2> points;
        for (const Vec3d& p : circle(hit->point, view.pick->normal(*hit),
                                     radius / solid_units(view), brush_points)) {
            const Vec3d seen = on_screen(view, p);
            points.push_back({float(seen.x), float(seen.y)});
        }
        list.AddPolyline(points.data(), brush_points, color, ImDrawFlags_Closed, width);
    };
    const Rgb8 c = tool.brush.layer == 0 ? tool.brush.color : mask_ring;
    const bool erases = tool.brush.mode == PaintMode::erase;
    ring(tool.brush.radius, IM_COL32(0, 0, 0, 200), 4.0f);
    ring(tool.brush.radius, erases ? IM_COL32(255, 255, 255, 255) : IM_COL32(c.r, c.g, c.b, 255),
         2.0f);
    ring(tool.brush.hardness * tool.brush.radius, IM_COL32(255, 255, 255, 110), 1.0f);
}

}  // namespace burl
