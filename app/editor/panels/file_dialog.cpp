#include "app/editor/panels/file_dialog.h"
#include "app/base/messages.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/editor/panels/files.h"
#include "app/editor/widgets/icons.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/theme.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace fs = std::filesystem;

namespace {

constexpr float places_share = 0.24f;  // the share of the dialog that the places have

std::string with_icon(const char* sign, const std::string& text) {
    const char* shown = icon_or(sign, "");
    return *shown == '\0' ? text : fmt::format("{}  {}", shown, text);
}

bool is_folder(const std::string& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

/// Returns the extension of a file name that is offered; ".burl.json" is one.
std::string usual_extension(std::string_view name) {
    constexpr std::string_view recipe = ".burl.json";
    if (name.ends_with(recipe)) return std::string(recipe);
    return fs::path(name).extension().string();
}

}  // namespace

void FileDialog::open(Wish wish) {
    wish_ = std::move(wish);
    name_ = wish_.name;
    std::error_code unknown;
    folder_ = fs::weakly_canonical(fs::absolute(folder_), unknown).string();
    if (start_.empty()) start_ = folder_;
    places_.clear();
    const auto add = [&](const std::string& label, const std::string& folder) {
        const bool known = std::ranges::count(places_, folder, &Place::folder) > 0;
        if (is_folder(folder) && !known) places_.push_back({label, folder});
    };
    add("Home", expanded_home("~"));
    add(file_name(start_), start_);
    for (const std::string& folder : wish_.places) add(file_name(folder), folder);
    add("/", "/");
    open_ = begins_ = true;
    accepted_ = agreed_ = false;
    asked_.clear();
    made_.reset();
}

void FileDialog::go_to(const std::string& folder) {
    folder_ = folder;
    problem_.clear();
    begins_ = true;
}

/// Draws the folder's path, each part of which leads there.
void FileDialog::crumbs(EditItems& items) {
    fs::path whole;
    std::string wanted;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
    ImGui::AlignTextToFramePadding();
    for (const fs::path& part : fs::path(folder_)) {
        whole /= part;
        const std::string name = part.string();
        const float width =
            ImGui::CalcTextSize(name.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
        if (whole != part) {
            ImGui::SameLine();
            ImGui::TextDisabled(">");
            ImGui::SameLine();
        }
        if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
        if (ImGui::Button(fmt::format("{}##crumb {}", name, whole.string()).c_str()))
            wanted = whole.string();
        items.note("crumb:" + name);
    }
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::Spacing();
    if (!wanted.empty()) go_to(wanted);
}

void FileDialog::places(EditItems& items) {
    for (const Place& place : places_) {
        const char* sign = place.label == "Home" ? icon::home : icon::folder;
        const std::string label = fmt::format("{}##{}", with_icon(sign, place.label), place.folder);
        if (ImGui::Selectable(label.c_str(), place.folder == folder_)) go_to(place.folder);
        items.note("place:" + place.label);
        tip(place.folder.c_str());
    }
}

void FileDialog::entries(EditItems& items) {
    if (ImGui::Selectable(with_icon(icon::up, "..").c_str()))
        go_to(fs::path(folder_).parent_path().string());
    items.note("file:..");
    names_.clear();
    for (const FolderEntry& entry : list_folder(folder_, wish_.extensions)) {
        names_.push_back(entry.name);
        const std::string label = entry.folder ? with_icon(icon::folder, entry.name + "/")
                                               : with_icon(icon::file, entry.name);
        const bool clicked = ImGui::Selectable(label.c_str(), entry.name == name_,
                                               ImGuiSelectableFlags_AllowDoubleClick);
        items.note("file:" + entry.name);
        if (!clicked) continue;
        if (entry.folder) return go_to((fs::path(folder_) / entry.name).string());
        name_ = entry.name;
        begins_ = true;  // so that Enter takes it
        accepted_ = ImGui::IsMouseDoubleClicked(0);
    }
}

/// Returns the path typed: it may lead out of the folder, and may lack the usual extension when
/// saving.
std::string FileDialog::path() const {
    fs::path path = fs::path(folder_) / expanded_home(name_);
    if (wish_.saves && !path.has_extension() && !is_folder(path.string()))
        path += usual_extension(wish_.name);
    return path.string();
}

/// Returns the path typed if it can be accepted; the name of a folder opens that folder instead.
std::optional<std::string> FileDialog::chosen() {
    if (name_.empty()) return {};
    const std::string path = this->path();
    std::error_code unknown;
    if (is_folder(path)) {
        go_to(fs::weakly_canonical(path, unknown).string());
        name_ = wish_.name;
        begins_ = true;
        return {};
    }
    if (!wish_.saves && !fs::is_regular_file(path, unknown)) return {};
    return path;
}

/// Returns the names of existing files that writing to `path` would replace.
std::vector<std::string> FileDialog::replaced(const std::string& path) const {
    std::vector<std::string> names;
    std::error_code unknown;
    for (const std::string& file : wish_.files ? wish_.files(path) : std::vector{path})
        if (fs::exists(file, unknown)) names.push_back(fs::path(file).filename().string());
    return names;
}

/// Returns the path once it needs no confirmation any more.
std::optional<std::string> FileDialog::agreed() {
    const bool yes = std::exchange(agreed_, false);
    const std::optional<std::string> path = chosen();
    if (!path || !wish_.saves) return path;
    std::vector<std::string> names = replaced(*path);
    if (names.empty() || (yes && asked_ == *path && names == replaced_)) return path;
    asked_ = *path;
    replaced_ = std::move(names);
    return {};
}

/// Returns a remark on the path typed, such as that a file will be replaced.
std::string FileDialog::remark() const {
    if (!problem_.empty()) return problem_;
    if (name_.empty()) return {};
    const std::string path = this->path(), name = fs::path(path).filename().string();
    std::error_code unknown;
    const bool there = fs::exists(path, unknown);
    if (is_folder(path)) return fmt::format("{} is a folder", name);
    if (wish_.saves) return there ? fmt::format("{} will be replaced", name) : std::string();
    return there ? std::string() : fmt::format("there is no {} here", name);
}

void FileDialog::name_row(EditItems& items) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const char* make = "New folder";
    const float button = ImGui::CalcTextSize(make).x + 2.0f * style.FramePadding.x;
    ImGui::SetNextItemWidth(
        std::max(1.0f, ImGui::GetContentRegionAvail().x - button - style.ItemSpacing.x));
    if (std::exchange(begins_, false)) ImGui::SetKeyboardFocusHere();
    accepted_ |= ImGui::InputText(
        "##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    items.note("file name");
    ImGui::SameLine();
    if (ImGui::Button(make)) {
        made_ = "";
        problem_.clear();
    }
    items.note("file new folder");
}

/// Draws the row in which the name of a new folder is typed.
void FileDialog::new_folder(EditItems& items) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("New folder");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(0.5f * ImGui::GetContentRegionAvail().x);
    if (made_->empty() && !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    bool made = ImGui::InputText("##folder", &*made_, ImGuiInputTextFlags_EnterReturnsTrue);
    items.note("file folder name");
    ImGui::SameLine();
    made |= ImGui::Button("Make it");
    items.note("file make folder");
    ImGui::SameLine();
    const bool back = ImGui::Button("Back") || pressed("Escape");
    items.note("file folder back");
    if (made && !made_->empty())
        make_folder_named();
    else if (back)
        made_.reset();
}

void FileDialog::make_folder_named() {
    const std::string folder = (fs::path(folder_) / expanded_home(*made_)).string();
    std::error_code problem;
    fs::create_directories(folder, problem);
    if (problem) {
        problem_ = fmt::format("{} cannot be made: {}", *made_, problem.message());
        return;
    }
    made_.reset();
    go_to(fs::weakly_canonical(folder, problem).string());
    begins_ = true;
}

void FileDialog::question(EditItems& items) {
    if (ImGui::Button("Replace")) accepted_ = agreed_ = true;
    items.note("file replace");
    ImGui::SameLine();
    const bool back = ImGui::Button("Back") || pressed("Escape");
    items.note("file back");
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().hint);
    ImGui::TextWrapped("Replace %s?", names_together(replaced_).c_str());
    ImGui::PopStyleColor();
    if (back || path() != asked_) asked_.clear();
}

void FileDialog::answers(EditItems& items) {
    if (made_) return new_folder(items);
    if (!asked_.empty()) return question(items);
    accepted_ |= main_button(wish_.verb ? wish_.verb : wish_.saves ? "Save" : "Open");
    items.note("file ok");
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || (pressed("Escape") && !had_popup_)) open_ = false;
    items.note("file cancel");
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().hint);
    ImGui::TextWrapped("%s", remark().c_str());
    ImGui::PopStyleColor();
}

std::optional<std::string> FileDialog::show(EditItems& items) {
    if (!open_) return {};
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Appearing,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(display.x, std::max(0.55f * display.x, 40.0f * em)),
                              std::min(display.y, std::max(0.7f * display.y, 30.0f * em))},
                             ImGuiCond_Appearing);
    std::optional<std::string> path;
    if (ImGui::Begin(wish_.title.c_str(), &open_, ImGuiWindowFlags_NoCollapse)) {
        crumbs(items);
        const int more = int(!wish_.hint.empty()) + wish_.option_rows;
        const float below = (2.4f + float(more)) * ImGui::GetFrameHeightWithSpacing();
        const float left = places_share * ImGui::GetContentRegionAvail().x;
        if (ImGui::BeginChild("places", {left, -below})) places(items);
        ImGui::EndChild();
        ImGui::SameLine();
        if (ImGui::BeginChild("files", {0.0f, -below}, true)) entries(items);
        ImGui::EndChild();
        if (!wish_.hint.empty()) ImGui::TextDisabled("%s", wish_.hint.c_str());
        name_row(items);
        if (wish_.options) wish_.options(items, this->path());
        answers(items);
        if (accepted_) path = agreed();
        accepted_ = false;
        had_popup_ = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    }
    ImGui::End();
    if (path) open_ = false;
    if (!open_) names_.clear();
    return path;
}

}  // namespace burl
