// Who makes the texture: the choice in the menu, and the papers' passes one by one.
#include <algorithm>

#include <fmt/format.h>

#include "app/editor/widgets/widgets.h"
#include "app/editor/window/program.h"

namespace burl {

namespace {

struct Choice {
    EditSynthesis by;
    const char *words, *about;
};
constexpr Choice choices[] = {
    {EditSynthesis::automatic, "The faster of both",
     "OpenGL where it runs on a graphics processor and is measured to be faster, else the host"},
    {EditSynthesis::host, "Host", "The processor's cores, with SIMD"},
    {EditSynthesis::gl, "OpenGL", "One pass; the texture stays where it is shown"},
    {EditSynthesis::passes, "OpenGL, pass by pass",
     "Noise as graphics hardware of 2001 made it, whose passes can be looked at one by one"}};

constexpr ImGuiWindowFlags badge_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

}  // namespace

/// Gives the baker a context where it may need one: on software OpenGL only if asked for.
void EditorProgram::offer_context(EditSynthesis by) {
    const bool software = is_software(window_->context().gl());
    const bool wanted = by != EditSynthesis::host && (by != EditSynthesis::automatic || !software);
    if (!wanted || baker_.has_context()) return;
    try {
        baker_.offer(window_->context().share(), software);
    } catch (const Error& error) {
        session_.complain(error.what());
    }
}

void EditorProgram::choose_synthesis(EditSynthesis by) {
    offer_context(by);
    requests_.synthesis = {by, 0};
}

void EditorProgram::synthesis_menu() {
    const bool open = ImGui::BeginMenu("Texture by");
    items_.note("menu:Texture by");
    if (!open) return;
    for (const Choice& choice : choices) {
        bool chosen = requests_.synthesis.by == choice.by;
        const bool before = chosen;
        menu_toggle(items_, choice.words, "", chosen);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", choice.about);
        if (chosen && !before) choose_synthesis(choice.by);
    }
    ImGui::EndMenu();
}

/// Shows which pass is looked at, with buttons to the others; where the choice cannot be had, why.
void EditorProgram::passes_badge(const ImVec2& low, const ImVec2& size) {
    const EditPicture* const shown = viewport_.object().picture();
    SynthesisWish& wish = requests_.synthesis;
    const bool asked = wish.by == EditSynthesis::gl || wish.by == EditSynthesis::passes;
    if (!shown || !asked) return;
    const std::optional<ShownPass>& pass = shown->resident.pass;
    if (!pass && shown->resident.pictures) return;
    ImGui::SetNextWindowPos({low.x + 0.5f * size.x, low.y + size.y - 8.0f}, ImGuiCond_Always,
                            {0.5f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("Passes", nullptr, badge_flags);
    if (!pass) {
        ImGui::TextUnformatted(fmt::format("Texture by {}", shown->by).c_str());
        items_.note("synthesis badge");
        ImGui::End();
        return;
    }
    int number = int(wish.pass > 0 ? std::min(wish.pass, pass->count) : pass->count);
    ImGui::SetNextItemWidth(0.35f * size.x);
    const std::string words = fmt::format("pass %d of {}", pass->count);
    ImGui::SliderInt("##pass", &number, 1, int(pass->count), words.c_str());
    items_.note("passes");
    ImGui::SameLine();
    if (ImGui::ArrowButton("##before", ImGuiDir_Left)) --number;
    items_.note("pass before");
    ImGui::SameLine();
    if (ImGui::ArrowButton("##after", ImGuiDir_Right)) ++number;
    items_.note("pass after");
    ImGui::SameLine();
    ImGui::TextUnformatted(pass->words.c_str());
    number = std::clamp(number, 1, int(pass->count));
    wish.pass = number == int(pass->count) ? 0 : std::size_t(number);
    ImGui::End();
}

}  // namespace burl
