#include "app/edit_files.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace burl {

namespace fs = std::filesystem;

namespace {

bool fits(const std::string& name, const std::vector<std::string>& extensions) {
    std::string extension = fs::path(name).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return extensions.empty() || std::ranges::find(extensions, extension) != extensions.end();
}

}  // namespace

std::vector<FolderEntry> list_folder(const std::string& folder,
                                     const std::vector<std::string>& extensions) {
    std::vector<FolderEntry> entries;
    std::error_code problem;
    for (fs::directory_iterator it(folder, problem), end; !problem && it != end;
         it.increment(problem)) {
        const std::string name = it->path().filename().string();
        std::error_code unknown;
        const bool is_folder = it->is_directory(unknown);
        if (name.starts_with('.') || !(is_folder || fits(name, extensions))) continue;
        entries.push_back({name, is_folder});
    }
    std::ranges::sort(entries, [](const FolderEntry& a, const FolderEntry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
    return entries;
}

void FileDialog::open(Wish wish) {
    wish_ = std::move(wish);
    name_ = wish_.name;
    std::error_code unknown;
    folder_ = fs::weakly_canonical(fs::absolute(folder_), unknown).string();
    open_ = true;
    accepted_ = chose_ = false;
}

void FileDialog::entries(EditItems& items) {
    if (ImGui::Selectable("..", false, ImGuiSelectableFlags_DontClosePopups))
        folder_ = fs::path(folder_).parent_path().string();
    items.note("file:..");
    for (const FolderEntry& entry : list_folder(folder_, wish_.extensions)) {
        const std::string label = entry.folder ? entry.name + "/" : entry.name;
        const bool clicked = ImGui::Selectable(
            label.c_str(), entry.name == name_,
            ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick);
        items.note("file:" + entry.name);
        if (!clicked) continue;
        if (entry.folder) {
            folder_ = (fs::path(folder_) / entry.name).string();
            return;
        }
        name_ = entry.name;
        accepted_ = ImGui::IsMouseDoubleClicked(0);
    }
}

std::optional<std::string> FileDialog::chosen() const {
    if (name_.empty()) return {};
    const std::string path = (fs::path(folder_) / name_).string();
    std::error_code unknown;
    if (!wish_.saves && !fs::is_regular_file(path, unknown)) return {};
    return path;
}

std::optional<std::string> FileDialog::show(EditItems& items) {
    if (!open_) return {};
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({0.55f * display.x, 0.7f * display.y});
    std::optional<std::string> path;
    if (ImGui::Begin(wish_.title.c_str(), &open_, ImGuiWindowFlags_NoCollapse)) {
        ImGui::TextUnformatted(folder_.c_str());
        const int more = int(!wish_.hint.empty()) + int(!wish_.choice.empty());
        const float below = (2.5f + float(more)) * ImGui::GetFrameHeightWithSpacing();
        if (ImGui::BeginChild("files", {0.0f, -below}, true)) entries(items);
        ImGui::EndChild();
        if (!wish_.hint.empty()) ImGui::TextDisabled("%s", wish_.hint.c_str());
        ImGui::SetNextItemWidth(-1.0f);
        accepted_ |= ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
        items.note("file name");
        if (!wish_.choice.empty()) {
            ImGui::Checkbox(wish_.choice.c_str(), &chose_);
            items.note("file choice");
        }
        accepted_ |= ImGui::Button(wish_.saves ? "Save" : "Open");
        items.note("file ok");
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) open_ = false;
        items.note("file cancel");
        if (accepted_) path = chosen();
        accepted_ = false;
    }
    ImGui::End();
    if (path) open_ = false;
    return path;
}

}  // namespace burl
