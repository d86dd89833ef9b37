// `burl figures`: redraws the papers' figures.
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/atomic_file.h"
#include "app/base/messages.h"
#include "app/base/progress.h"
#include "app/direct/figures.h"
#include "app/export/command_files.h"
#include "app/image/palette.h"
#include "app/main/verbs.h"
#include "app/options/command_options.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

struct FiguresCommand {
    std::string folder;
    std::vector<std::string> only;
    bool commands = false;
    std::string progress = "auto";
};

std::vector<Figure> chosen_figures(const FiguresCommand& command) {
    if (command.only.empty()) return figures();
    std::vector<Figure> chosen;
    for (const std::string& name : command.only) chosen.push_back(find_figure(name));
    return chosen;
}

void print_commands(const std::vector<Figure>& chosen) {
    for (const Figure& figure : chosen) {
        fmt::print("# {}: {}\n", figure.name, figure.shows);
        if (!figure.has_commands()) {
            fmt::print("burl figures -o . --only {}\n", figure.name);
            continue;
        }
        for (std::size_t i = 0; i < figure.parts.size(); ++i) {
            const std::string number = figure.parts.size() == 1 ? "" : fmt::format("-{}", i + 1);
            fmt::print("burl render --direct {} -o {}{}.png\n", figure.parts[i], figure.name,
                       number);
        }
    }
}

void run_figures(const FiguresCommand& command) {
    const std::vector<Figure> chosen = chosen_figures(command);
    if (command.commands) return print_commands(chosen);
    if (command.folder.empty())
        throw Error(ExitCode::usage, "where to? give a folder with -o, or ask for --commands");
    make_folder(command.folder);
    std::vector<std::string> paths;
    for (const Figure& figure : chosen) {
        paths.push_back((std::filesystem::path(command.folder) / (figure.name + ".png")).string());
        CommandFiles().write(paths.back(), ".png");
    }
    Progress progress(progress_mode(command.progress, false));
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        progress.begin_item(paths[i], i, chosen.size(), "drawing");
        const Image<Rgb8> picture = draw_figure(chosen[i]);
        const std::vector<std::uint8_t> bytes = encode_small_png(picture, figure_limit);
        write_file(paths[i], bytes);
        print_line(fmt::format("{}: {} x {} pixels, {} bytes", paths[i], picture.width(),
                               picture.height(), bytes.size()));
    }
    progress.finish();
}

}  // namespace

void add_figures(CLI::App& program) {
    auto* verb = program.add_subcommand("figures", "Our versions of the papers' figures");
    auto command = std::make_shared<FiguresCommand>();
    verb->add_option("-o,--output", command->folder, "Folder to write them to, as NAME.png");
    verb->add_option("--only", command->only, "One figure; may be repeated (burl list figures)")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb->add_flag("--commands", command->commands,
                   "Print the commands that draw the figures' parts instead")
        ->excludes("--output");
    add_progress(*verb, command->progress);
    verb->callback([command] { run_figures(*command); });
}

}  // namespace burl
