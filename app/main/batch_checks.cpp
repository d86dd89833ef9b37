// Checks of all bakes of a batch, before any of them begins.
#include "app/main/batch_checks.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/export/command_files.h"
#include "app/options/input_limits.h"
#include "app/recipe/presets.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"

namespace burl {

std::vector<std::string> BatchCommand::options() const {
    std::vector<std::string> all;
    for (const std::string& recipe : recipes) all.push_back("recipe=" + recipe);
    for (const std::string& size : sizes) all.push_back("size=" + size);
    std::ranges::copy(others, std::back_inserter(all));
    if (!output.empty()) all.push_back("output=" + output);
    return all;
}

namespace {

/// A counter of wrong entries of a manifest, which prints each on stderr.
class Problems {
  public:
    explicit Problems(std::string manifest) : manifest_(std::move(manifest)) {}
    /// Throws Error where there are too many to look for more.
    void add(ExitCode code, const std::string& where, const std::string& what) {
        warn(fmt::format("{}: {}", where, what));
        if (count_++ == 0) code_ = code;
        if (count_ == most_wrong_bakes)
            throw Error(code_,
                        fmt::format("{}: {} bakes are wrong, the most that are told; nothing "
                                    "was baked",
                                    manifest_, count_));
    }
    void throw_if_any(std::size_t entries) const {
        if (count_ == 0) return;
        throw Error(code_, fmt::format("{}: {} of {} bakes are wrong; nothing was baked", manifest_,
                                       count_, entries));
    }

  private:
    std::string manifest_;
    std::size_t count_ = 0;
    ExitCode code_ = ExitCode::ok;
};

/// The reason why the bake may not write its outputs; empty where it may. Adds the outputs to those
/// of the bakes before it.
std::string clash(const BatchBake& bake, const FileNames& readers, FileNames& writers) {
    for (const std::string& file : bake.files()) {
        if (const auto* writer = writers.find_path(file))
            return fmt::format("{} is written by another bake, too: {}", file, writer->note);
        if (const auto* reader = readers.find(file))
            return fmt::format("{} is what {}", file, reader->note);
        writers.add(file, bake.where);
    }
    return {};
}

/// The sentence about a file of the bake, however it is named after the output, that the manifest
/// may not name; empty where there is none.
std::string outside(const BatchCommand& command, const BatchBake& bake) {
    if (!command.is_manifest() || command.what[0] == "-") return {};
    for (const std::string& file : bake.files())
        if (!may_name(command.run.meshes.read.named, command.what[0],
                      std::filesystem::absolute(file).string()))
            return fmt::format("{} {}", file, outside_rule);
    return {};
}

/// Reports bakes that write the same file as another bake, a file that a bake or the batch reads,
/// or one outside the manifest's folder. Returns all files read and written.
CommandFiles check_outputs(const BatchCommand& command, const std::vector<BatchBake>& bakes,
                           Problems& problems) {
    FileNames readers, writers;
    if (command.is_manifest()) readers.add(command.what.front(), "lists the bakes");
    for (const BatchBake& bake : bakes)
        for (const std::string& file : bake.job.inputs())
            readers.add(file, fmt::format("another bake reads: {}", bake.where));
    for (const BatchBake& bake : bakes) {
        const std::string problem = clash(bake, readers, writers);
        if (!problem.empty()) problems.add(ExitCode::usage, bake.where, problem);
        const std::string lies_out = outside(command, bake);
        if (!lies_out.empty()) problems.add(ExitCode::invalid_file, bake.where, lies_out);
    }
    return {std::move(readers), std::move(writers)};
}

/// Throws Error for a mesh of the command line that is no file, before dozens of bakes say so.
void check_meshes(const std::vector<std::string>& meshes) {
    for (const std::string& mesh : meshes) {
        const bool is_pattern = mesh.find_first_of("*?") != std::string::npos;
        if (mesh.ends_with(".json"))
            throw Error(
                ExitCode::usage,
                fmt::format("batch: {} is a manifest, which stands alone on a command line", mesh));
        if (is_pattern || is_sample_mesh(mesh) || std::filesystem::exists(mesh)) continue;
        const auto known = [&](const auto& names) {
            return std::ranges::find(names, mesh) != names.end();
        };
        if (known(preset_names()) || known(material_names()))
            throw Error(ExitCode::usage,
                        fmt::format("batch: {} is a recipe, where a mesh should stand; give each "
                                    "recipe a -r of its own",
                                    mesh));
        throw Error(ExitCode::io, fmt::format("batch: there is no mesh {}", mesh));
    }
}

/// Throws Error for a command line that names no outputs, before each bake says so.
void check_output(const BatchCommand& command) {
    const auto is_output = [](const std::string& option) { return option.starts_with("output="); };
    if (std::ranges::none_of(command.options(), is_output))
        throw Error(ExitCode::usage, "batch: --output is required, as -o '{mesh}_{recipe}.glb'");
}

/// Throws Error(usage) where a manifest is given options that are of meshes on the command line.
void check_no_options(const BatchCommand& command) {
    const std::vector<std::string> options = command.options();
    if (options.empty()) return;
    const std::string key = options.front().substr(0, options.front().find('='));
    const bool has_option = key == "recipe" || key == "size" || key == "output";
    throw Error(ExitCode::usage,
                fmt::format("{}: {} is for meshes on the command line, and a manifest says all of "
                            "its bakes itself; write \"{}\" in one of them or in \"defaults\"",
                            command.name(), (has_option ? "--" : "--with ") + key, key));
}

/// The bakes that the command lists, in its shard.
std::vector<BatchEntry> entries_of(const BatchCommand& command) {
    const BatchShard shard = batch_shard(command.shard);
    if (command.is_manifest()) {
        check_no_options(command);
        return read_manifest(command.what.front(), shard, command.run.meshes.read.named);
    }
    check_meshes(command.what);
    check_output(command);
    try {
        return matrix_of_options(command.what, command.options(), shard);
    } catch (const Error& error) {  // that no file is to blame for
        const bool of_file = error.code() == ExitCode::invalid_file;
        throw Error(of_file ? ExitCode::usage : error.code(), error.what());
    }
}

/// The bake of an entry. Throws Error where it is wrong, as far as its files' formats and being
/// there tell without reading its mesh.
BatchBake checked_bake(const BatchEntry& entry, bool of_manifest) {
    const BakeCommand& asked = entry.command;
    if (!entry.wrong.empty())
        throw Error(of_manifest ? ExitCode::invalid_file : ExitCode::usage, entry.wrong);
    check_mesh_argument(asked.mesh);
    if (is_pose_file(asked.pose)) check_mesh_argument(asked.pose);
    BatchBake bake{entry.where, BakeJob(asked, entry.settings)};
    bake.job.command().meshes.check(asked.mesh);
    return bake;
}

}  // namespace

std::vector<BatchBake> checked_bakes(const BatchCommand& command) {
    std::vector<BatchEntry> entries = entries_of(command);
    if (entries.empty() && !command.shard.empty())
        warn(fmt::format("{}: part {} has no bake: there are fewer bakes than parts",
                         command.name(), command.shard));
    std::vector<BatchBake> bakes;
    Problems problems(command.name());
    const auto images = std::make_shared<RecipeImages>();
    for (BatchEntry& entry : entries) {
        entry.command.recipe.images = images;
        copy_input_limits(command.run.meshes, command.run.recipe, entry.command.meshes,
                          entry.command.recipe);
        entry.command.threads = command.run.threads;
        entry.command.economy = command.run.economy;
        entry.command.force = command.run.force;
        entry.command.makes_folders = true;
        try {
            bakes.push_back(checked_bake(entry, command.is_manifest()));
        } catch (const Error& error) {
            problems.add(error.code(), entry.where, error.what());
        }
    }
    const auto files = std::make_shared<CommandFiles>(check_outputs(command, bakes, problems));
    problems.throw_if_any(entries.size());
    const std::string& report = command.run.report;
    if (!report.empty() && report != "-") files->write(report);
    for (BatchBake& bake : bakes) bake.job.compare_with(files);
    return bakes;
}

}  // namespace burl
