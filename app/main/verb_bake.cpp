// `burl bake`: from a mesh without UVs to a textured scene, the whole pipeline without a window.
#include <chrono>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/bake/job.h"
#include "app/main/verbs.h"
#include "atlas/base/error.h"
#include "atlas/base/memory.h"

namespace burl {

namespace {

void run_bake(const BakeCommand& command, const Json& settings) {
    const BakeJob job(command, settings);
    if (const auto known = job.known_report()) return job.print(*known);
    const std::shared_ptr<TextureSynthesizer> synthesizer = job.synthesizer();
    const auto start = std::chrono::steady_clock::now();
    Pipeline pipeline(job.command().meshes.load(job.command().mesh));
    return_large_blocks(pipeline.mesh().triangles.size());
    const std::chrono::duration<double> reading = std::chrono::steady_clock::now() - start;
    job.print(job.run(pipeline, synthesizer, reading.count(), LaterBake::none));
}

}  // namespace

void add_bake(CLI::App& program) {
    auto* verb =
        program.add_subcommand("bake", "Texture a mesh and write .glb, .gltf, .obj, .png or .exr");
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
        run_bake(*command, bake_settings(*verb));
    });
}

}  // namespace burl
