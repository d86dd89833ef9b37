// The editor's open files, its file menu and its dialogs.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/editor/panels/keys.h"
#include "app/editor/panels/notices.h"
#include "app/editor/panels/timeline.h"
#include "app/editor/window/program.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

namespace {

constexpr double news_seconds = 12.0;

std::string name_of(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

}  // namespace

void EditorProgram::open(const std::string& path) {
    files_.open(path);
}

/// Drops selections of the recipe shown before, after a preset was opened or undo has brought back
/// another document.
void EditorProgram::follow_document() {
    const std::uint64_t number = session_.history().document_number();
    if (std::exchange(document_, number) != number) {
        stop_ = {};
        timeline_.chosen = {};
    }
    if (files_.recipe() != session_.recipe_path()) files_.set_recipe(session_.recipe_path());
}

void EditorProgram::take_files() {
    follow_document();
    const bool asked = files_.asks();
    for (FileRead& read : files_.take(session_.history().changed())) {
        const bool nothing_open = read.kind == FileKind::mesh && files_.mesh().empty();
        if (read.problem && nothing_open && read.path == first_mesh_) throw Error(*read.problem);
        // The file opened in its place cannot be read.
        if (read.problem && nothing_open) files_.open(first_mesh_);
        if (read.problem)
            session_.complain(read.problem->what());
        else if (read.kind == FileKind::mesh)
            take_mesh(std::move(read));
        else if (read.kind == FileKind::pose)
            take_pose(read);
        else
            take_recipe(std::move(read));
    }
    if (files_.asks() && !asked)
        session_.complain(fmt::format("{} has changed on disk, and the recipe here is not saved",
                                      files_.recipe()));
}

void EditorProgram::take_mesh(FileRead read) {
    session_.tell(fmt::format("mesh {}{}: {} triangles, read in {:.2f} s", read.path,
                              read.again ? " again" : "", read.mesh->triangles.size(),
                              read.seconds));
    for (const std::string& note : sentences_of(read.mesh->notes))
        session_.tell(fmt::format("{}: {}", read.path, note));
    baker_.set_mesh(std::move(*read.mesh));
    posed_ = false;
    requested_.reset();
}

void EditorProgram::take_pose(const FileRead& read) {
    session_.tell(fmt::format("pose {}{}, read in {:.2f} s", read.path, read.again ? " again" : "",
                              read.seconds));
    baker_.set_pose(read.pose);
    posed_ = true;
    requested_.reset();
}

void EditorProgram::open_pose(const std::string& path) {
    files_.open_pose(path);
}

void EditorProgram::close_pose() {
    files_.close_pose();
    baker_.set_pose(nullptr);
    posed_ = false;
    requested_.reset();
}

/// Returns the share of the way to the pose, 0 to 1; 0 without a pose.
double EditorProgram::pose_share() {
    const auto& surface = object_.surface();
    if (!surface || !surface->posed) return 0.0;
    return shown_recipe().pose.weight;
}

/// Returns the picking structure of the surface on screen; null: not ready.
std::shared_ptr<const SurfacePick> EditorProgram::pick() const {
    const auto& surface = object_.surface();
    if (!surface) return nullptr;
    if (share_ != 0.0) return posed_pick_.pick(surface, share_);
    auto pick = baker_.pick();
    if (pick && &pick->scene() != &surface->scene) pick.reset();  // it belongs to another surface
    return pick;
}

/// Draws the menu items for poses: files, and those in the mesh's own file.
void EditorProgram::pose_menu() {
    if (menu_item("Open pose...", "", !files_.mesh().empty()))
        ask_for_file(&EditorProgram::open_pose,
                     {"Open a pose: a mesh with the same faces", mesh_extensions(), false, {}});
    const std::vector<std::string>& poses = files_.own_poses();
    const bool open = ImGui::BeginMenu("Poses of the file", !poses.empty());
    items_.note("menu:Poses of the file");
    if (open) {
        for (const std::string& pose : poses) {
            if (ImGui::MenuItem(pose.c_str(), nullptr, pose == files_.pose())) open_pose(pose);
            items_.note("pose:" + pose);
        }
        ImGui::EndMenu();
    }
    if (menu_item("Close pose", "", posed_)) close_pose();
}

/// Takes over a recipe that was read. A file that holds the present recipe, such as one just saved
/// by the editor, only counts as saved.
void EditorProgram::take_recipe(FileRead read) {
    if (read.again && read.path != session_.recipe_path()) return;  // another was opened since
    if (read.again && *read.recipe == session_.recipe())
        return session_.history().open(std::move(*read.recipe), read.path);
    const double time = session_.time();
    session_.take_recipe(std::move(*read.recipe), read.path);
    if (read.again) session_.set_time(std::min(time, session_.recipe().animation.seconds));
}

void EditorProgram::recent_menu() {
    if (!ImGui::BeginMenu("Open recent", !files_.recent().paths().empty())) {
        items_.note("menu:Open recent");
        return;
    }
    items_.note("menu:Open recent");
    for (const std::string& path : files_.recent().paths()) {
        std::error_code unknown;
        const bool there = std::filesystem::is_regular_file(path, unknown);
        const std::string folder = name_of(std::filesystem::path(path).parent_path());
        ImGui::PushID(path.c_str());
        if (ImGui::MenuItem(name_of(path).c_str(), folder.c_str(), false, there)) open(path);
        items_.note(fmt::format("recent:{}", name_of(path)));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", path.c_str());
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

/// Draws notices in the lower left corner of the object's view.
void EditorProgram::notices() {
    std::vector<Notice> notices;
    for (const FileKind kind : {FileKind::mesh, FileKind::recipe, FileKind::pose})
        if (const std::string path = files_.reading(kind); !path.empty())
            notices.push_back({fmt::format("Reading {} ...", name_of(path))});
    if (baker_.laying_out())
        notices.push_back(
            {"Laying out patches; until they are done, pairs of triangles are shown"});
    if (export_.busy()) notices.push_back({"Exporting ..."});
    if (files_.asks())
        notices.push_back({fmt::format("{} has changed on disk; the recipe here is not saved",
                                       name_of(files_.recipe())),
                           {"Take the file's", "Keep this one"}});
    if (window_->seconds() < news_.until)
        notices.push_back({news_.text, {"Dismiss"}, news_.problem});
    const float strip = timeline_.open ? timeline_height(session_) : 0.0f;
    const std::string answer = notices_panel(items_, notices, ImGui::GetIO().DisplaySize.y - strip);
    if (answer == "Dismiss") news_ = {};
    if (answer == "Take the file's") files_.reload();
    if (answer == "Keep this one") {
        files_.keep();
        session_.history().forget_saved();
    }
}

void EditorProgram::news(std::string text, bool problem) {
    news_ = {std::move(text), problem, window_->seconds() + news_seconds};
}

/// Draws a left recipe with its buttons; returns whether one was pressed.
bool EditorProgram::left_row(std::size_t left) {
    const LeftRecipe& recipe = autosave_.left_behind()[left];
    const std::string number = left == 0 ? "" : fmt::format(" {}", left + 1);
    ImGui::PushID(int(left));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(recipe.title.c_str());
    ImGui::SameLine();
    const bool taken = ImGui::Button("Take it");
    items_.note("recover" + number);
    ImGui::SameLine();
    const bool unwanted = ImGui::Button("Throw it away");
    items_.note("do not recover" + number);
    ImGui::PopID();
    if (taken && session_.recover_recipe(recipe.json, recipe.file))
        autosave_.take(left, session_.history());
    else if (unwanted)
        autosave_.throw_away(left);
    return taken || unwanted;
}

void EditorProgram::recovery_window() {
    if (autosave_.left_behind().empty()) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("Unsaved work", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
    ImGui::TextUnformatted("What was not saved by an editor that did not end well:");
    for (std::size_t i = 0; i < autosave_.left_behind().size(); ++i)
        if (left_row(i)) break;
    if (ImGui::Button("Ask again at the next start")) autosave_.leave_all();
    items_.note("recover later");
    ImGui::End();
}

void EditorProgram::ask_to_close() {
    if (session_.history().unsaved())
        asks_to_close_ = true;
    else
        closing_ = true;
}

/// Asks about unsaved changes until there are none or the user cancels.
void EditorProgram::closing_window() {
    if (!asks_to_close_ || dialog_.is_open()) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("Quit", &asks_to_close_,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
    EditHistory& history = session_.history();
    ImGui::TextUnformatted(history.changed()
                               ? "The recipe has changes that are not saved."
                               : fmt::format("Changes made before {} was opened are not saved.",
                                             name_of(session_.recipe_path()))
                                     .c_str());
    const auto answer = [&](const char* label) {
        const bool chosen = ImGui::Button(label);
        items_.note(label);
        ImGui::SameLine();
        return chosen;
    };
    if (answer("Save it")) {
        history.return_to_unsaved();
        save();
    }
    if (answer("Quit without saving")) closing_ = true;
    if (answer("Stay") || pressed("Escape")) asks_to_close_ = false;
    ImGui::End();
}

void EditorProgram::save() {
    if (session_.recipe_path().ends_with(".json"))
        save_as(session_.recipe_path());
    else
        save_dialog();
}

void EditorProgram::save_dialog() {
    ask_for_file(&EditorProgram::save_as,
                 {"Save the recipe", {".json"}, true, session_.recipe().name + ".json"});
}

void EditorProgram::save_as(const std::string& path) {
    try {
        session_.save_recipe(path);
        files_.set_recipe(path);
        news(fmt::format("saved {}", path), false);
        closing_ = asks_to_close_ && !session_.history().unsaved();
    } catch (const Error& error) {
        session_.complain(error.what());
    }
}

void EditorProgram::ask_for_file(void (EditorProgram::*then)(const std::string&),
                                 FileDialog::Wish wish) {
    chosen_ = then;
    dialog_.open(std::move(wish));
}

void EditorProgram::open_dialog() {
    std::vector<std::string> extensions = mesh_extensions();
    extensions.push_back(".json");
    ask_for_file(&EditorProgram::open, {"Open a mesh or recipe", std::move(extensions), false, {}});
}

void EditorProgram::export_dialog() {
    ask_for_file(&EditorProgram::export_as,
                 {"Export the textured mesh",
                  {".glb", ".gltf", ".obj", ".png", ".exr", ".frag", ".glsl"},
                  true,
                  session_.recipe().name + ".glb",
                  ".glb .gltf .obj: mesh and texture   .png .exr: texture   .frag .glsl: shader",
                  "Write all MIP levels, too",
                  [this](const std::string& path, bool levels) {
                      return export_files({files_.mesh(), session_.still(), path, levels});
                  }});
}

void EditorProgram::export_frames_dialog() {
    ask_for_file(&EditorProgram::export_frames_as,
                 {"Export every frame as a texture, numbered from NAME.0001 on",
                  {".png", ".exr"},
                  true,
                  session_.recipe().name + ".png",
                  "",
                  "",
                  [this](const std::string& path, bool) {
                      return export_files({files_.mesh(), session_.recipe(), path});
                  }});
}

double EditorProgram::seen_time() const {
    return session_.recipe().animation.tracks.empty() ? 0.0 : session_.time();
}

/// Returns the `burl bake` command of the present recipe.
std::string EditorProgram::command(std::vector<std::string> output, double time) const {
    const EditHistory& history = session_.history();
    const bool saved = !history.changed();
    const std::string line =
        bake_command(files_.mesh(), saved ? session_.recipe_path() : history.opened_path(),
                     saved ? session_.recipe() : history.opened(), session_.recipe(),
                     std::move(output), posed_ ? files_.pose() : "");
    return time > 0.0 ? fmt::format("{} --time {}", line, time) : line;
}

/// Exports the recipe with its own atlas, even while a quad atlas is shown.
void EditorProgram::export_as(const std::string& path) {
    ExportRequest request{files_.mesh(), session_.still(), path, dialog_.chose()};
    if (posed_) request.pose = files_.pose();
    request.recipe_path = session_.recipe_path();
    session_.tell(
        fmt::format("exporting {}, as {}", path, command(bake_options(request), seen_time())));
    export_.start(std::move(request));
}

void EditorProgram::export_frames_as(const std::string& path) {
    ExportRequest request{files_.mesh(), session_.recipe(), path};
    request.recipe_path = session_.recipe_path();
    session_.tell(fmt::format("exporting the frames of {}, as {}", path,
                              command(bake_options(request), 0.0)));
    export_.start(std::move(request));
}

}  // namespace burl
