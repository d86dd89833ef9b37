// `burl render`: a picture of a textured scene through OpenGL, of a recipe on a mesh as if it had
// been baked (--lazy), or of the texture itself in float64 (--direct).
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/export/command_files.h"
#include "app/main/render_command.h"
#include "app/main/render_frames.h"
#include "app/main/verbs.h"
#include "app/surface/sample_meshes.h"

namespace burl {

namespace {

void run_render(const RenderCommand& command) {
    CommandFiles files;
    const NamedFiles named = command.options.meshes.read.named;
    files.read(files_of_mesh(command.options.scene, MeshFiles::named, named));
    if (is_pose_file(command.options.pose))
        files.read(files_of_mesh(command.options.pose, MeshFiles::named, named));
    files.read(command.options.light.files());
    for (const std::string& path : command.paths()) files.write(path);
    if (!command.report.empty() && command.report != "-") files.write(command.report);
    write_frames(command, rendered_frames(command, files));
}

}  // namespace

void add_render(CLI::App& program) {
    auto* verb =
        program.add_subcommand("render", "Picture of a textured scene, or of the exact texture");
    auto command = std::make_shared<RenderCommand>();
    command->add(*verb);
    verb->callback([command, verb] {
        std::vector<std::string> given;
        for (const CLI::Option* option : verb->get_options())
            if (option->count() > 0) given.push_back("--" + option->get_single_name());
        command->check(given);
        command->complete();
        run_render(*command);
    });
}

}  // namespace burl
