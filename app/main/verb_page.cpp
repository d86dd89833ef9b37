// `burl page`: baked objects as a web page.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/atomic_file.h"
#include "app/base/messages.h"
#include "app/export/command_files.h"
#include "app/gl/device/context.h"
#include "app/gl/draw/render.h"
#include "app/gl/draw/scene.h"
#include "app/gl/draw/surroundings.h"
#include "app/main/verbs.h"
#include "app/page/page.h"
#include "app/scene/scene.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

struct PageCommand {
    std::vector<std::string> paths;
    std::string folder, title = "Carved by Burl";
};

/// An object as the page shows it at first, on nothing. `light` is kept for the next one.
Image<Rgba8> small_picture(GlContext& context, const std::string& path,
                           std::shared_ptr<const GlLight>& light) {
    PictureOptions options;
    options.size = {256, 256};
    options.light.light = "studio";
    options.background.kind = Background::Kind::transparent;
    const Scene scene = load_scene(path);
    const GlSurroundings around(context.gl(), scene, options, light);
    light = around.light();
    const GlScene uploaded(context.gl(), scene);
    const Camera camera = orbit_camera(View{}, bounding_sphere(scene), options.size);
    return render_picture(context, uploaded, around, camera, options);
}

/// Draws the pictures that several objects are chosen by; without OpenGL there are none.
void draw_pictures(std::vector<PageObject>& objects) {
    if (objects.size() < 2) return;
    try {
        const std::unique_ptr<GlContext> context = create_gl_context(gl_platforms()[0]);
        context->make_current();
        std::shared_ptr<const GlLight> light;
        for (PageObject& object : objects) {
            object.picture = small_picture(*context, object.path, light);
            print_line(fmt::format("{}: its picture is drawn", object.path));
        }
    } catch (const Error& error) {
        for (PageObject& object : objects) object.picture.reset();
        warn(fmt::format("burl: the page has names without pictures: {}", error.what()));
    }
}

void run_page(const PageCommand& command) {
    if (command.folder.empty()) throw Error(ExitCode::usage, "page: -o names no folder");
    std::vector<PageObject> objects = page_objects(command.paths);
    check_page_folder(command.folder, objects);
    for (const PageObject& object : objects) check_page_object(object.path);
    draw_pictures(objects);
    CommandFiles files;
    files.allow_new_folders();
    files.read(command.paths);
    for (const std::string& path : page_files(command.folder, objects)) files.write(path);
    for (const char* part : {"lights", "objects"})
        make_folder((std::filesystem::path(command.folder) / part).string());
    write_page(command.folder, command.title, objects);
    print_line(fmt::format("{}: {} object{}",
                           (std::filesystem::path(command.folder) / "index.html").string(),
                           objects.size(), objects.size() == 1 ? "" : "s"));
    const std::vector<std::string> left = left_of_older_page(command.folder, objects);
    if (!left.empty())
        warn(fmt::format("{}: not of this page: {}", command.folder, names_together(left)));
}

}  // namespace

void add_page(CLI::App& program) {
    auto* verb = program.add_subcommand("page", "Web page of baked objects, for any browser");
    auto command = std::make_shared<PageCommand>();
    verb->add_option("objects", command->paths, "Files that bakes wrote, .glb")->required();
    verb->add_option("-o,--output", command->folder, "Folder to write the page to: index.html")
        ->required();
    verb->add_option("--title", command->title, "Title of the page")->capture_default_str();
    verb->callback([command] { run_page(*command); });
}

}  // namespace burl
