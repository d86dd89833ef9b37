// `burl diff`: the difference of two pictures, for people and for scripts that need a yes or no.
#include <array>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/export/command_files.h"
#include "app/image/image_diff.h"
#include "app/image/image_io.h"
#include "app/main/verbs.h"
#include "app/measure/report.h"
#include "app/options/command_options.h"
#include "app/scene/shading.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

struct DiffCommand {
    std::string a, b, out;
    DiffOptions options;
    bool surface = false, json = false;
};

Json diff_json(const DiffCommand& command, const ImageDiff& diff) {
    const bool finite = diff.rmse > 0.0;
    return {{"a", command.a},
            {"b", command.b},
            {"psnr_db", finite ? Json(diff.psnr_db) : Json(nullptr)},
            {"maximum", diff.maximum},
            {"rmse", diff.rmse},
            {"pixels", diff.pixels},
            {"ignored", diff.ignored},
            {"tolerance", command.options.tolerance},
            {"above_tolerance", diff.above_tolerance},
            {"within", diff.within(command.options.tolerance)}};
}

void run_diff(DiffCommand command) {
    if (!command.out.empty()) {
        CommandFiles files;
        files.read(std::array{command.a, command.b});
        files.write(command.out, ".png");
    }
    if (command.surface) command.options.ignore = background_srgb;
    const ImageDiff diff = diff_images(read_png(command.a), read_png(command.b), command.options);
    if (!command.out.empty()) write_png(command.out, diff.false_color);
    if (command.json) {
        write_json("-", diff_json(command, diff));
    } else {
        fmt::print("PSNR {:.2f} dB, maximum {:.4f}, RMSE {:.6f}, {} of {} pixels above {:g}\n",
                   diff.psnr_db, diff.maximum, diff.rmse, diff.above_tolerance, diff.pixels,
                   command.options.tolerance);
    }
    if (!diff.within(command.options.tolerance)) throw Error(ExitCode::difference, "");
}

}  // namespace

void add_diff(CLI::App& program) {
    auto* verb =
        program.add_subcommand("diff", "Compare two pictures; exit code 7 when they differ");
    auto command = std::make_shared<DiffCommand>();
    verb->add_option("a", command->a, "First picture (.png)")->required();
    verb->add_option("b", command->b, "Second picture (.png)")->required();
    verb->add_option("--tolerance", command->options.tolerance,
                     "Largest channel difference that still counts as equal, 0..1")
        ->check(in_range(0.0, 1.0))
        ->capture_default_str();
    verb->add_option("-o,--output", command->out, "Write the difference in false colour (.png)");
    verb->add_option("--scale", command->options.scale, "Difference at which the false colours end")
        ->check(in_range(1.0 / 255.0, 1.0))
        ->capture_default_str()
        ->needs("--output");
    verb->add_flag("--surface", command->surface,
                   "Leave out pixels that show the renderer's background in either picture");
    verb->add_flag("--json", command->json, "Print JSON");
    verb->callback([command] { run_diff(*command); });
}

}  // namespace burl
