#include "app/editor/panels/files.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "app/editor/panels/keys.h"
#include "app/editor/panels/theme.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

namespace fs = std::filesystem;

namespace {

bool fits(const std::string& name, const std::vector<std::string>& extensions) {
    const std::string extension = lower_extension(name);
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

std::string file_name(const std::string& path) {
    return fs::path(path).filename().string();
}

std::string claim_numbered(const std::string& stem, const std::string& extension) {
    for (int number = 1;; ++number) {
        const std::string path = fmt::format("{}-{:03}{}", stem, number, extension);
        const int descriptor = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            ::close(descriptor);
            return path;
        }
        if (errno != EEXIST)
            throw Error(ExitCode::io, fmt::format("{}: cannot be written: {}", path,
                                                  std::generic_category().message(errno)));
    }
}

std::string names_together(const std::vector<std::string>& names) {
    constexpr std::size_t most = 4;
    const std::size_t count = std::min(names.size(), most);
    std::string text = count > 0 ? names[0] : "";
    for (std::size_t i = 1; i < count; ++i)
        text += (i + 1 == names.size() ? " and " : ", ") + names[i];
    if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
    return text;
}

void FileDialog::open(Wish wish) {
    wish_ = std::move(wish);
    name_ = wish_.name;
    std::error_code unknown;
    folder_ = fs::weakly_canonical(fs::absolute(folder_), unknown).string();
    open_ = begins_ = true;
    accepted_ = chose_ = agreed_ = false;
    asked_.clear();
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

/// Returns the path typed: it may lead out of the folder, and may lack the usual extension when
/// saving.
std::string FileDialog::path() const {
    fs::path path = fs::path(folder_) / name_;
    std::error_code unknown;
    if (wish_.saves && !path.has_extension() && !fs::is_directory(path, unknown))
        path.replace_extension(fs::path(wish_.name).extension());
    return path.string();
}

/// Returns the path typed if it can be accepted; the name of a folder opens that folder instead.
std::optional<std::string> FileDialog::chosen() {
    if (name_.empty()) return {};
    const std::string path = this->path();
    std::error_code unknown;
    if (fs::is_directory(path, unknown)) {
        folder_ = fs::weakly_canonical(path, unknown).string();
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
    for (const std::string& file : wish_.files ? wish_.files(path, chose_) : std::vector{path})
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
    if (name_.empty()) return {};
    const std::string path = this->path(), name = fs::path(path).filename().string();
    std::error_code unknown;
    const bool there = fs::exists(path, unknown);
    if (fs::is_directory(path, unknown)) return fmt::format("{} is a folder", name);
    if (wish_.saves) return there ? fmt::format("{} will be replaced", name) : std::string();
    return there ? std::string() : fmt::format("there is no {} here", name);
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
    if (!asked_.empty()) return question(items);
    accepted_ |= ImGui::Button(wish_.saves ? "Save" : "Open");
    items.note("file ok");
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || pressed("Escape")) open_ = false;
    items.note("file cancel");
    ImGui::SameLine();
    ImGui::TextColored(style_color(palette().hint), "%s", remark().c_str());
}

std::optional<std::string> FileDialog::show(EditItems& items) {
    if (!open_) return {};
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Appearing,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSize({0.55f * display.x, 0.7f * display.y}, ImGuiCond_Appearing);
    std::optional<std::string> path;
    if (ImGui::Begin(wish_.title.c_str(), &open_, ImGuiWindowFlags_NoCollapse)) {
        ImGui::TextUnformatted(folder_.c_str());
        const int more = int(!wish_.hint.empty()) + int(!wish_.choice.empty());
        const float below = (2.5f + float(more)) * ImGui::GetFrameHeightWithSpacing();
        if (ImGui::BeginChild("files", {0.0f, -below}, true)) entries(items);
        ImGui::EndChild();
        if (!wish_.hint.empty()) ImGui::TextDisabled("%s", wish_.hint.c_str());
        ImGui::SetNextItemWidth(-1.0f);
        if (std::exchange(begins_, false)) ImGui::SetKeyboardFocusHere();
        accepted_ |= ImGui::InputText(
            "##name", &name_,
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        items.note("file name");
        if (!wish_.choice.empty()) {
            ImGui::Checkbox(wish_.choice.c_str(), &chose_);
            items.note("file choice");
        }
        answers(items);
        if (accepted_) path = agreed();
        accepted_ = false;
    }
    ImGui::End();
    if (path) open_ = false;
    return path;
}

}  // namespace burl
