#include "app/editor/panels/welcome.h"

#include <algorithm>

#include "app/editor/widgets/icons.h"
#include "app/editor/widgets/theme.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace {

constexpr float window_width = 19.0f;  // in font sizes

/// `width` is that of the text, from the window's left edge.
void step(bool done, const char* what, const char* how, float width) {
    ImGui::PushStyleColor(ImGuiCol_Text, done ? palette().accent : palette().quiet);
    ImGui::TextUnformatted(icon_or(done ? icon::done : icon::not_done, done ? "x" : "-"));
    ImGui::PopStyleColor();
    ImGui::SameLine(0.0f, 0.5f * ImGui::GetFontSize());
    ImGui::BeginGroup();
    ImGui::TextUnformatted(what);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    ImGui::PushTextWrapPos(width);
    ImGui::TextUnformatted(how);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::EndGroup();
    ImGui::Spacing();
}

}  // namespace

void follow(FirstSteps& steps, const EditHistory& history, const EditCamera& camera) {
    if (!steps.camera) steps.camera = camera;
    if (!steps.document) steps.document = history.document_number();
    steps.turned |= camera.view != steps.camera->view;
    steps.chosen |= history.document_number() != *steps.document;
    steps.changed |= history.changed();
}

bool first_steps_window(EditItems& items, const FirstSteps& steps, const ImVec2& corner) {
    bool open = true;
    const float gap = 0.5f * ImGui::GetFontSize();
    // No wider than the object's view, which ends at the corner.
    const float width = std::min(window_width * ImGui::GetFontSize(), corner.x - 4.0f * gap);
    ImGui::SetNextWindowPos({corner.x - gap, corner.y + gap}, ImGuiCond_Always, {1.0f, 0.0f});
    if (ImGui::Begin("Three things to try", &open,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing)) {
        step(steps.turned, "Turn the object",
             "Drag it. The wheel brings nearer what is under the pointer.", width);
        step(steps.chosen, "Choose another material",
             "Click a picture in the library. Ctrl+Z takes you back.", width);
        step(steps.changed, "Make it yours",
             "Drag a control under Parameters, and watch the object.", width);
        const bool all = steps.turned && steps.chosen && steps.changed;
        if (all ? main_button("Done") : ImGui::Button("Close")) open = false;
        items.note("close first steps");
    }
    ImGui::End();
    return open;
}

}  // namespace burl
