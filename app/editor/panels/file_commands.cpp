#include "app/editor/panels/file_commands.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>
#include <utility>

#include "app/editor/panels/keys.h"
#include "app/editor/panels/widgets.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

void FileCommands::ask(FileDialog::Wish wish, std::function<void(const std::string& path)> then) {
    chosen_ = std::move(then);
    dialog_.open(std::move(wish));
}

void FileCommands::show_dialog(EditItems& items) {
    if (const auto path = dialog_.show(items)) chosen_(*path);
}

void FileCommands::open_dialog() {
    std::vector<std::string> extensions = mesh_extensions();
    extensions.push_back(".json");
    ask({"Open a mesh or recipe", std::move(extensions), false, {}},
        [this](const std::string& path) { loader_.files().open(path); });
}

void FileCommands::recent_menu(EditItems& items) {
    const std::vector<std::string>& paths = loader_.files().recent().paths();
    const bool open = ImGui::BeginMenu("Open recent", !paths.empty());
    items.note("menu:Open recent");
    if (!open) return;
    for (const std::string& path : paths) {
        std::error_code unknown;
        const bool there = std::filesystem::is_regular_file(path, unknown);
        const std::string folder = file_name(std::filesystem::path(path).parent_path());
        ImGui::PushID(path.c_str());
        if (ImGui::MenuItem(file_name(path).c_str(), folder.c_str(), false, there))
            loader_.files().open(path);
        items.note(fmt::format("recent:{}", file_name(path)));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", path.c_str());
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

void FileCommands::pose_menu(EditItems& items) {
    EditOpenFiles& files = loader_.files();
    const auto open_pose = [this](const std::string& path) { loader_.files().open_pose(path); };
    if (menu_item(items, "Open pose...", "", !files.mesh().empty()))
        ask({"Open a pose: a mesh with the same faces", mesh_extensions(), false, {}}, open_pose);
    const std::vector<std::string>& poses = files.own_poses();
    const bool open = ImGui::BeginMenu("Poses of the file", !poses.empty());
    items.note("menu:Poses of the file");
    if (open) {
        for (const std::string& pose : poses) {
            if (ImGui::MenuItem(pose.c_str(), nullptr, pose == files.pose())) open_pose(pose);
            items.note("pose:" + pose);
        }
        ImGui::EndMenu();
    }
    if (menu_item(items, "Close pose", "", loader_.posed())) loader_.close_pose();
}

void FileCommands::save() {
    if (session_.recipe_path().ends_with(".json"))
        save_as(session_.recipe_path());
    else
        save_dialog();
}

void FileCommands::save_dialog() {
    ask({"Save the recipe", {".json"}, true, session_.recipe().name + ".json"},
        [this](const std::string& path) { save_as(path); });
}

void FileCommands::save_as(const std::string& path) {
    try {
        session_.save_recipe(path);
        loader_.files().set_recipe(path);
        notices_.tell(fmt::format("saved {}", path));
        closing_ = asks_to_close_ && !session_.history().unsaved();
    } catch (const Error& error) {
        session_.complain(error.what());
    }
}

void FileCommands::quit() {
    if (session_.history().unsaved())
        asks_to_close_ = true;
    else
        closing_ = true;
}

void FileCommands::closing_window(EditItems& items) {
    if (!asks_to_close_ || dialog_.is_open()) return;
    begin_centred_window("Quit", &asks_to_close_);
    EditHistory& history = session_.history();
    ImGui::TextUnformatted(history.changed()
                               ? "The recipe has changes that are not saved."
                               : fmt::format("Changes made before {} was opened are not saved.",
                                             file_name(session_.recipe_path()))
                                     .c_str());
    const auto answer = [&](const char* label) {
        const bool chosen = ImGui::Button(label);
        items.note(label);
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

/// Returns the time on the clock in seconds; 0 without animation.
double FileCommands::seen_time() const {
    return session_.recipe().animation.tracks.empty() ? 0.0 : session_.time();
}

/// Returns the `burl bake` command of the present recipe at a time on the clock.
std::string FileCommands::command(std::vector<std::string> output, double time) const {
    const EditHistory& history = session_.history();
    const EditOpenFiles& files = loader_.files();
    const bool saved = !history.changed();
    const std::string line =
        bake_command(files.mesh(), saved ? session_.recipe_path() : history.opened_path(),
                     saved ? session_.recipe() : history.opened(), session_.recipe(),
                     std::move(output), loader_.posed() ? files.pose() : "");
    return time > 0.0 ? fmt::format("{} --time {}", line, time) : line;
}

std::string FileCommands::command_line() const {
    return command({}, seen_time());
}

void FileCommands::export_dialog() {
    ask({"Export the textured mesh",
         {".glb", ".gltf", ".obj", ".png", ".exr", ".frag", ".glsl"},
         true,
         session_.recipe().name + ".glb",
         ".glb .gltf .obj: mesh and texture   .png .exr: texture   .frag .glsl: shader",
         "Write all MIP levels, too",
         [this](const std::string& path, bool levels) {
             return export_files({loader_.files().mesh(), session_.still(), path, levels});
         }},
        [this](const std::string& path) { export_as(path); });
}

void FileCommands::export_frames_dialog() {
    ask({"Export every frame as a texture, numbered from NAME.0001 on",
         {".png", ".exr"},
         true,
         session_.recipe().name + ".png",
         "",
         "",
         [this](const std::string& path, bool) {
             return export_files({loader_.files().mesh(), session_.recipe(), path});
         }},
        [this](const std::string& path) { export_frames_as(path); });
}

/// Exports the recipe with its own atlas, even while a quad atlas is shown.
void FileCommands::export_as(const std::string& path) {
    ExportRequest request{loader_.files().mesh(), session_.still(), path, dialog_.chose()};
    if (loader_.posed()) request.pose = loader_.files().pose();
    request.recipe_path = session_.recipe_path();
    session_.tell(
        fmt::format("exporting {}, as {}", path, command(bake_options(request), seen_time())));
    export_.start(std::move(request));
}

void FileCommands::export_frames_as(const std::string& path) {
    ExportRequest request{loader_.files().mesh(), session_.recipe(), path};
    request.recipe_path = session_.recipe_path();
    session_.tell(fmt::format("exporting the frames of {}, as {}", path,
                              command(bake_options(request), 0.0)));
    export_.start(std::move(request));
}

void FileCommands::take_outcome() {
    const auto outcome = export_.take_outcome();
    if (!outcome) return;
    if (outcome->problem) return session_.complain(outcome->text);
    session_.tell(outcome->text);
    notices_.tell(outcome->text);
}

}  // namespace burl
