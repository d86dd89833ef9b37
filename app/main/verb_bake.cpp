// `burl bake`: from a mesh without UVs to a textured scene, the whole pipeline without a window.
#include <chrono>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/bake/job.h"
#include "app/base/progress.h"
#include "app/base/stopwatch.h"
#include "app/main/verbs.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/base/memory.h"

namespace burl {

void add_bake(CLI::App& program) {
    auto* verb = program.add_subcommand("bake",
                                        "Texture a mesh and write .glb, .gltf, .obj, .mtlx, .ply, "
                                        ".stl, .png, .jpg, .webp, .ktx2 or .exr");
    auto command = std::make_shared<BakeCommand>();
    add_bake_options(*verb, *command);
    add_run_options(*verb, *command);
    add_report_options(*verb, *command);
    verb->callback([command, verb] {
        check_report_options(command->json, command->report, command->quiet);
        if (command->economy.cache_megabytes && !command->animation.asked())
            throw Error(ExitCode::usage,
                        "--cache keeps what one frame leaves to the next; add --frames, or leave "
                        "it out");
        Progress progress(progress_mode(command->progress, command->quiet));
        BakeCommand told = *command;
        told.told = progress.course();
        const BakeJob job(told, bake_settings(*verb));
        if (const auto known = job.known_report()) return job.print(*known);
        const std::shared_ptr<TextureSynthesizer> synthesizer = job.synthesizer();
        const auto start = std::chrono::steady_clock::now();
        progress.begin_item("", 0, 1, tasks::read);
        Pipeline pipeline(job.command().load_mesh());
        return_large_blocks(pipeline.mesh().triangles.size());
        const Json report = job.run(pipeline, synthesizer, seconds_since(start), LaterBake::none);
        progress.finish();
        job.print(report);
    });
}

}  // namespace burl
