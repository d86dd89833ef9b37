#include "app/editor/panels/file_commands.h"
#include "app/base/messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/editor/panels/files.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/widgets.h"
#include "app/pipeline/mask_picture.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

namespace {

constexpr int export_option_rows = 4;

void size_row(EditItems& items, std::uint32_t& size, std::uint32_t own) {
    begin_row("Size", "export");
    const auto label = [&](std::uint32_t side) {
        return side == 0 ? fmt::format("{0} x {0}, as the recipe says", own)
                         : fmt::format("{0} x {0}", side);
    };
    const bool open = ImGui::BeginCombo("##size", label(size).c_str());
    items.note("export size");
    tip("The texture's side in texels, for this export alone.");
    if (!open) return;
    for (const std::uint32_t side : {0U, 256U, 512U, 1024U, 2048U, 4096U, 8192U}) {
        if (ImGui::Selectable(label(side).c_str(), side == size)) size = side;
        items.note(fmt::format("export size={}", side));
    }
    ImGui::EndCombo();
}

void mask_row(EditItems& items, std::set<std::string>& masks) {
    begin_row("Masks besides", "export");
    const std::string shown = masks.empty() ? "none" : fmt::format("{}", fmt::join(masks, ", "));
    const bool open = ImGui::BeginCombo("##masks", shown.c_str());
    items.note("export masks");
    tip("Pictures of the mesh's shape, such as occlusion, each in a .png of its own.");
    if (!open) return;
    for (const std::string_view name : mask_picture_names()) {
        const std::string mask(name);
        bool wanted = masks.contains(mask);
        if (!check_box(items, mask.c_str(), "export mask:" + mask, wanted)) continue;
        if (wanted)
            masks.insert(mask);
        else
            masks.erase(mask);
    }
    ImGui::EndCombo();
}

}  // namespace

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
    extensions.push_back(".mtlx");
    FileDialog::Wish wish{.title = "Open a mesh or recipe", .extensions = std::move(extensions)};
    wish.places = places();
    ask(std::move(wish), [this](const std::string& path) { loader_.files().open(path); });
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
        ask({.title = "Open a pose: a mesh with the same faces",
             .extensions = mesh_extensions(),
             .places = places()},
            open_pose);
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
    ask({.title = "Save the recipe",
         .extensions = {".json"},
         .saves = true,
         .name = session_.recipe().name + ".burl.json",
         .places = places()},
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

/// Returns the `burl bake` command of a recipe that was made from the present one, at a time on the
/// clock.
std::string FileCommands::command(const Recipe& recipe, std::vector<std::string> output,
                                  double time) const {
    const EditHistory& history = session_.history();
    const EditOpenFiles& files = loader_.files();
    const bool saved = !history.changed();
    const std::string line =
        bake_command(files.mesh(), saved ? session_.recipe_path() : history.opened_path(),
                     saved ? session_.recipe() : history.opened(), recipe, std::move(output),
                     loader_.posed() ? files.pose() : "");
    return time > 0.0 ? fmt::format("{} --time {}", line, time) : line;
}

std::string FileCommands::command_line() const {
    return command(session_.recipe(), {}, seen_time());
}

/// Returns the folders of files opened lately, for dialogs.
std::vector<std::string> FileCommands::places() const {
    constexpr std::size_t most = 5;
    std::vector<std::string> folders;
    for (const std::string& path : loader_.files().recent().paths()) {
        const std::string folder = std::filesystem::path(path).parent_path().string();
        if (folders.size() < most && std::ranges::count(folders, folder) == 0)
            folders.push_back(folder);
    }
    return folders;
}

/// Returns the export that was chosen: the recipe's own atlas, even while a quad atlas is shown.
ExportRequest FileCommands::export_request(const std::string& path) {
    ExportRequest request{loader_.files().mesh(), session_.still(), path, choice_.levels};
    if (choice_.size > 0) request.recipe.atlas.size = choice_.size;
    request.masks.assign(choice_.masks.begin(), choice_.masks.end());
    if (loader_.posed()) request.pose = loader_.files().pose();
    request.recipe_path = session_.recipe_path();
    return request;
}

void FileCommands::export_dialog() {
    FileDialog::Wish wish{.title = "Export the textured mesh",
                          .extensions = {".glb", ".gltf", ".obj", ".mtlx", ".png", ".jpg", ".webp",
                                         ".ktx2", ".exr", ".frag", ".glsl"},
                          .saves = true,
                          .name = session_.recipe().name + ".glb"};
    wish.hint =
        ".glb .gltf .obj .mtlx: mesh and texture   .png .jpg .webp .ktx2 .exr: texture   "
        ".frag .glsl: shader";
    wish.places = places();
    wish.options = [this](EditItems& items, const std::string& path) {
        export_options(items, path);
    };
    wish.option_rows = export_option_rows;
    wish.files = [this](const std::string& path) { return export_files(export_request(path)); };
    wish.verb = "Export";
    ask(std::move(wish), [this](const std::string& path) { export_as(path); });
}

void FileCommands::export_options(EditItems& items, const std::string& path) {
    ImGui::BeginDisabled(is_shader_file(path));
    size_row(items, choice_.size, session_.recipe().atlas.size);
    mask_row(items, choice_.masks);
    check_box(items, "All MIP levels, too", "file choice", choice_.levels);
    tip("Writes each MIP level as a picture of its own, beside the texture.");
    ImGui::EndDisabled();
    std::vector<std::string> names;
    for (const std::string& file : export_files(export_request(path)))
        names.push_back(file_name(file));
    ImGui::TextDisabled("Writes %s", names_together(names).c_str());
}

void FileCommands::export_frames_dialog() {
    FileDialog::Wish wish{.title = "Export every frame as a texture, numbered from NAME.0001 on",
                          .extensions = {".png", ".exr"},
                          .saves = true,
                          .name = session_.recipe().name + ".png"};
    wish.places = places();
    wish.files = [this](const std::string& path) {
        return export_files({loader_.files().mesh(), session_.recipe(), path});
    };
    wish.verb = "Export";
    ask(std::move(wish), [this](const std::string& path) { export_frames_as(path); });
}

void FileCommands::export_as(const std::string& path) {
    ExportRequest request = export_request(path);
    session_.tell(fmt::format("exporting {}, as {}", path,
                              command(request.recipe, bake_options(request), seen_time())));
    export_.start(std::move(request));
}

void FileCommands::export_frames_as(const std::string& path) {
    ExportRequest request{loader_.files().mesh(), session_.recipe(), path};
    request.recipe_path = session_.recipe_path();
    session_.tell(fmt::format("exporting the frames of {}, as {}", path,
                              command(request.recipe, bake_options(request), 0.0)));
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
