// burl-edit: the slider-driven texture editor.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>
#include <new>
#include <string_view>
#include <utility>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/base/messages.h"
#include "app/base/out_of_memory.h"
#include "app/base/version.h"
#include "app/editor/window/program.h"
#include "app/options/command_options.h"
#include "app/options/light.h"
#include "app/options/manual.h"
#include "app/recipe/presets.h"
#include "atlas/base/error.h"

namespace {

constexpr std::string_view out_of_memory =
    "burl-edit: out of memory; try a smaller mesh or texture\n";

struct Command {
    burl::EditorOptions editor;
    std::string script, screenshots, record, synthesis = "auto", gl = "osmesa";
    bool unseen = false, exit = false;
};

void run(Command command) {
    using namespace burl;
    if (command.script.empty()) {
        command.editor.autosave = state_file("autosave.json");
        command.editor.recent = state_file("recent");
        command.editor.preferences = state_file("preferences.json");
    }
    InputScript script;
    if (!command.script.empty()) {
        const auto bytes = read_file_bytes(command.script);
        script = parse_script(std::string(bytes.begin(), bytes.end()), command.script);
    }
    if (!command.screenshots.empty()) make_folder(command.screenshots);
    auto window = command.unseen ? create_unseen_window(create_gl_context(command.gl), script.size)
                                 : create_desktop_window(script.size, "Burl");
    EditorProgram editor(std::move(window), command.editor);
    if (!command.record.empty()) editor.record();
    if (!command.script.empty()) editor.play(script, command.screenshots);
    if (!command.exit && !command.unseen) editor.run();
    if (editor.recording()) write_file(command.record, script_text(*editor.recording()));
}

/// Adds the options of what is shown at first.
void add_editor_options(CLI::App& program, Command& command) {
    const std::vector<std::string> lights = burl::light_names();
    const auto& synths = burl::enum_names<burl::EditSynthesis>;
    program
        .add_option("mesh", command.editor.mesh,
                    "Mesh file, or sample:NAME; a recipe file is shown on the teapot")
        ->capture_default_str();
    program.add_option("-r,--recipe", command.editor.recipe, "Recipe file, preset or material")
        ->capture_default_str();
    program.add_option("--set", command.editor.settings,
                       "Edit of the recipe: path=value or control=value");
    program
        .add_option("--light", command.editor.light,
                    "Light of the object: a built-in environment, or headlight")
        ->check(burl::one_of(lights))
        ->capture_default_str();
    program
        .add_option(
            "--synth", command.synthesis,
            "Who makes the texture: host, gl, gl-multipass (the papers' passes, to be looked "
            "at one by one), or auto, which measures a graphics processor against the host")
        ->check(burl::one_of({synths.begin(), synths.end()}))
        ->capture_default_str();
    program.add_option("--ui-scale", command.editor.ui_scale, "Size of text and panels")
        ->check(CLI::Range(0.5, 4.0));
}

/// Adds the options of scripts.
void add_script_options(CLI::App& program, Command& command) {
    const auto platforms = burl::gl_platforms();
    auto* script = program.add_option("--script", command.script, "Input to replay");
    program.add_option("--screenshot-dir", command.screenshots, "Folder of the script's pictures")
        ->needs(script);
    program.add_option("--record", command.record, "Write the input as a script to this file");
    program.add_flag("--exit", command.exit, "Leave at the script's end")->needs(script);
    auto* unseen = program.add_flag("--unseen", command.unseen, "No window")->needs(script);
    program
        .add_option(
            "--gl", command.gl,
            "Where OpenGL comes from without a window: osmesa (software) or egl (a graphics "
            "processor)")
        ->check(burl::one_of({platforms.begin(), platforms.end()}))
        ->capture_default_str()
        ->needs(unseen);
}

/// Adds --manual, for those who package Burl: a page for man, or a shell's completion.
void add_manual(CLI::App& program, std::string& form) {
    program.add_option("--manual", form, "man, or a shell")->group("");
}

/// Prints the page or the completion; the exit code.
int print_manual(const CLI::App& program, const std::string& form) {
    const auto shell = burl::enum_named<burl::Shell>(form);
    if (form != "man" && !shell) {
        burl::warn(fmt::format("burl-edit: --manual {}: must be man, bash, zsh or fish", form));
        return int(burl::ExitCode::usage);
    }
    fmt::print("{}", shell ? burl::completion(program, *shell) : burl::program_page(program));
    return 0;
}

/// The sentence about a wrong option or argument, and a blank.
std::string wrong_argument(const CLI::App& program, const CLI::ParseError& wrong) {
    const std::vector<std::string> left = program.remaining();
    if (left.empty()) return fmt::format("{}; ", wrong.what());
    const std::string name = left[0].substr(0, left[0].find('='));
    if (!name.starts_with('-')) return fmt::format("nothing takes \"{}\"; ", left[0]);
    return fmt::format("there is no option {}; {}", name,
                       burl::did_you_mean(name, burl::option_names(program)));
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit is a write error, which is told
    burl::end_where_memory_ends(out_of_memory);
    burl::clean_up_on_signals();
    CLI::App program{"Texture editor: open a mesh, move sliders, save a .glb", "burl-edit"};
    Command command;
    command.editor.recipe = "malachite";  // what shows best, in the studio, what there is to edit
    program.set_version_flag("--version", std::string(burl::burl_version()));
    add_editor_options(program, command);
    add_script_options(program, command);
    std::string manual;
    add_manual(program, manual);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return program.exit(asked);
    } catch (const CLI::ParseError& wrong) {
        burl::warn(fmt::format("burl-edit: {}burl-edit --help lists the options",
                               wrong_argument(program, wrong)));
        return int(burl::ExitCode::usage);
    }
    if (!manual.empty()) return print_manual(program, manual);
    if (burl::names_recipe_file(command.editor.mesh) && program.count("--recipe") > 0) {
        burl::warn(
            fmt::format("burl-edit: {} is a recipe, and --recipe names another; give one of "
                        "them, or a mesh",
                        command.editor.mesh));
        return int(burl::ExitCode::usage);
    }
    if (burl::names_recipe_file(command.editor.mesh))
        command.editor.recipe = std::exchange(command.editor.mesh, burl::EditorOptions{}.mesh);
    command.editor.synthesis = *burl::enum_named<burl::EditSynthesis>(command.synthesis);
    try {
        run(command);
    } catch (const burl::Error& error) {
        burl::warn(fmt::format("burl-edit: {}", error.what()));
        return int(error.code());
    } catch (const std::bad_alloc&) {
        burl::warn(out_of_memory.substr(0, out_of_memory.size() - 1));
        return int(burl::ExitCode::runtime);
    } catch (const std::exception& error) {
        burl::warn(fmt::format("burl-edit: {}", error.what()));
        return int(burl::ExitCode::runtime);
    }
    return 0;
}
