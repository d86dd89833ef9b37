// `burl batch`: many bakes from one manifest. Bakes of one mesh run one after another on one
// pipeline, so that the mesh is read once and atlas and solid points are computed once for all
// bakes that agree in them. Bakes whose outputs are up to date cost only the hashes of their
// inputs.
#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/bake/batch_manifest.h"
#include "app/bake/job.h"
#include "app/bake/up_to_date.h"
#include "app/base/messages.h"
#include "app/base/progress.h"
#include "app/base/real_path.h"
#include "app/export/command_files.h"
#include "app/main/verbs.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/error.h"
#include "atlas/base/memory.h"

namespace burl {

namespace {

struct BatchCommand {
    std::string manifest;
    BakeCommand run;  ///< options of add_run_options and add_report_options only
};

/// An entry of the manifest, with its state.
struct Bake {
    std::string where;
    BakeJob job;
    std::string status{};  ///< "written", "up to date" or "failed"
    std::string problem{};
    ExitCode code = ExitCode::ok;
    double seconds = 0.0;
    std::vector<std::string> shared{};  ///< the stages that earlier entries had computed

    /// The outputs, and the record of how they were made.
    std::vector<std::string> files() const {
        std::vector<std::string> files = job.outputs();
        files.push_back(record_path(job.command().out));
        return files;
    }
    void fail(ExitCode why, const std::string& sentence) {
        status = "failed", code = why, problem = sentence;
        warn(fmt::format("{}: {}", where, sentence));
    }
};

/// A counter of wrong entries, which prints each on stderr.
class Problems {
  public:
    void add(ExitCode code, const std::string& where, const std::string& what) {
        warn(fmt::format("{}: {}", where, what));
        if (count_++ == 0) code_ = code;
    }
    void throw_if_any(const std::string& manifest, std::size_t entries) const {
        if (count_ == 0) return;
        throw Error(code_, fmt::format("{}: {} of {} bakes are wrong; nothing was baked", manifest,
                                       count_, entries));
    }

  private:
    std::size_t count_ = 0;
    ExitCode code_ = ExitCode::ok;
};

/// The reason why the bake may not write its outputs; empty where it may. Adds the outputs to those
/// of the bakes before it.
std::string clash(const Bake& bake, const FileNames& readers, FileNames& writers) {
    for (const std::string& file : bake.files()) {
        if (const auto* writer = writers.find_path(file))
            return fmt::format("{} is written by another bake, too: {}", file, writer->note);
        if (const auto* reader = readers.find(file))
            return fmt::format("{} is what {}", file, reader->note);
        writers.add(file, bake.where);
    }
    return {};
}

/// Reports bakes that write the same file as another bake, or a file that a bake or the batch
/// reads. Returns all files read and written.
CommandFiles check_outputs(const BatchCommand& command, const std::vector<Bake>& bakes,
                           Problems& problems) {
    FileNames readers, writers;
    readers.add(command.manifest, "lists the bakes");
    for (const Bake& bake : bakes)
        for (const std::string& file : bake.job.inputs())
            readers.add(file, fmt::format("another bake reads: {}", bake.where));
    for (const Bake& bake : bakes) {
        const std::string problem = clash(bake, readers, writers);
        if (!problem.empty()) problems.add(ExitCode::usage, bake.where, problem);
    }
    return {std::move(readers), std::move(writers)};
}

/// All entries of the manifest. Throws Error where any is wrong, after a line on stderr for each of
/// them.
std::vector<Bake> check_manifest(const BatchCommand& command) {
    std::vector<BatchEntry> entries = read_manifest(command.manifest);
    std::vector<Bake> bakes;
    Problems problems;
    const auto images = std::make_shared<RecipeImages>();
    for (BatchEntry& entry : entries) {
        entry.command.recipe.images = images;
        entry.command.threads = command.run.threads;
        entry.command.economy = command.run.economy;
        entry.command.force = command.run.force;
        entry.command.told = command.run.told;
        try {
            if (!entry.wrong.empty()) throw Error(ExitCode::invalid_file, entry.wrong);
            bakes.push_back({entry.where, BakeJob(entry.command, entry.settings)});
        } catch (const Error& error) {
            problems.add(error.code(), entry.where, error.what());
        }
    }
    CommandFiles files = check_outputs(command, bakes, problems);
    problems.throw_if_any(command.manifest, entries.size());
    const std::string& report = command.run.report;
    if (!report.empty() && report != "-") files.write(report);
    return bakes;
}

/// A key that is equal for bakes that can use one pipeline.
std::string mesh_key(const Bake& bake) {
    const BakeCommand& command = bake.job.command();
    const MeshFrame& frame = command.meshes.frame;
    const Vec3d& turn = frame.rotate;
    const GltfChoice& choice = command.meshes.read.choice;
    std::string only;
    for (const auto& [mesh, primitive] : choice.only)
        only += fmt::format("{}.{},", mesh, primitive);
    return fmt::format("{} {} {} {} {} {},{},{} {} {} {}\n{}\n{} {} {}", command.meshes.read.weld,
                       command.meshes.read.uv_set, command.meshes.read.unshare_instances,
                       command.displace.value_or(0), frame.up, turn.x, turn.y, turn.z, frame.scale,
                       frame.units ? to_string(*frame.units) : "", fmt::join(choice.meshes, "\n"),
                       fmt::join(choice.nodes, "\n"), fmt::join(choice.materials, "\n"), only,
                       real_path(command.mesh));
}

using Group = std::vector<Bake*>;

/// Sorts bakes of a mesh so that those with the same atlas, and then the same space, are adjacent,
/// in the order of their first occurrence.
void put_in_order(Group& group) {
    const auto rank = [group](const auto& same) {
        return [group, same](const Bake* bake) {
            return std::ranges::find_if(group,
                                        [&](const Bake* other) {
                                            return same(bake->job.recipe(), other->job.recipe());
                                        }) -
                   group.begin();
        };
    };
    const auto atlas = [](const Recipe& a, const Recipe& b) { return a.atlas == b.atlas; };
    const auto space = [](const Recipe& a, const Recipe& b) {
        return a.solid.space == b.solid.space;
    };
    std::ranges::stable_sort(group, {}, rank(space));
    std::ranges::stable_sort(group, {}, rank(atlas));
}

std::vector<Group> groups_of(std::vector<Bake>& bakes) {
    std::vector<Group> groups;
    std::map<std::string, std::size_t> known;
    for (Bake& bake : bakes) {
        const auto [place, fresh] = known.emplace(mesh_key(bake), groups.size());
        if (fresh) groups.emplace_back();
        groups[place->second].push_back(&bake);
    }
    std::ranges::for_each(groups, put_in_order);
    return groups;
}

/// A mesh that is read when the first bake needs it; a failure is kept for the others.
class SharedMesh {
  public:
    /// Reads the mesh unless it has been read; returns whether it had been. Throws Error as reading
    /// does.
    bool read(const BakeJob& job) {
        if (pipeline_) return true;
        if (problem_) throw *problem_;
        const auto start = std::chrono::steady_clock::now();
        try {
            pipeline_.emplace(job.command().load_mesh());
            return_large_blocks(pipeline_->mesh().triangles.size());
        } catch (const Error& error) {
            problem_ = error;
            throw;
        }
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return false;
    }
    Pipeline& pipeline() { return *pipeline_; }
    double seconds() const { return seconds_; }

  private:
    std::optional<Pipeline> pipeline_;
    std::optional<Error> problem_;
    double seconds_ = 0.0;
};

/// The stages that have run before and not again.
std::vector<std::string> kept_stages(const StageRecords& before, const StageRecords& after) {
    std::vector<std::string> names;
    for (const Stage stage : {Stage::connectivity, Stage::layout, Stage::spans})
        if (after[stage].runs > 0 && after[stage].runs == before[stage].runs)
            names.emplace_back(stage_names[unsigned(stage)]);
    return names;
}

void run(Bake& bake, SharedMesh& mesh, LaterBake later) {
    if (bake.job.known_report()) {
        bake.status = "up to date";
        return;
    }
    const auto synthesizer = bake.job.synthesizer();
    const bool had_mesh = mesh.read(bake.job);
    const StageRecords before = mesh.pipeline().records();
    bake.job.run(mesh.pipeline(), synthesizer, had_mesh ? 0.0 : mesh.seconds(), later);
    if (had_mesh) {
        bake.shared = kept_stages(before, mesh.pipeline().records());
        bake.shared.insert(bake.shared.begin(), "mesh");
    }
    bake.status = "written";
}

/// Runs a bake; its errors do not end the batch.
void run_alone(Bake& bake, SharedMesh& mesh, LaterBake later) {
    const auto start = std::chrono::steady_clock::now();
    try {
        run(bake, mesh, later);
    } catch (const Error& error) {
        bake.fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        bake.fail(ExitCode::runtime, "out of memory; try a smaller size or mesh");
    }
    bake.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string line_of(const Bake& bake) {
    const std::string& out = bake.job.command().out;
    if (bake.status != "written") return fmt::format("{}: {}", out, bake.status);
    const std::string shared =
        bake.shared.empty() ? "" : fmt::format(", shared {}", fmt::join(bake.shared, ", "));
    return fmt::format("{}: written, {:.2f} s{}", out, bake.seconds, shared);
}

Json batch_json(const std::vector<Bake>& bakes) {
    Json list = Json::array();
    std::map<std::string, std::size_t> counts{{"written", 0}, {"up to date", 0}, {"failed", 0}};
    std::map<std::string, std::size_t> shared{
        {"mesh", 0}, {"connectivity", 0}, {"layout", 0}, {"spans", 0}};
    for (const Bake& bake : bakes) {
        ++counts[bake.status];
        for (const std::string& stage : bake.shared) ++shared[stage];
        list.push_back({{"where", bake.where},
                        {"input", bake.job.command().mesh},
                        {"outputs", bake.job.outputs()},
                        {"status", bake.status},
                        {"seconds", bake.seconds},
                        {"shared", bake.shared}});
        if (!bake.problem.empty()) list.back()["problem"] = bake.problem;
    }
    return {{"bakes", std::move(list)}, {"counts", counts}, {"shared", shared}};
}

LaterBake later_of(const Group& group, std::size_t i) {
    if (i + 1 == group.size()) return LaterBake::none;
    const bool same = group[i]->job.recipe().atlas == group[i + 1]->job.recipe().atlas;
    return same ? LaterBake::atlas : LaterBake::mesh;
}

/// Whether a bake of the group can reuse synthesis results of the one before or of an earlier
/// frame.
bool has_several_textures(const Group& group) {
    for (std::size_t i = 0; i < group.size(); ++i)
        if (group[i]->job.command().animation.asked() || later_of(group, i) == LaterBake::atlas)
            return true;
    return false;
}

void check_cache(const BakeCommand& run, const std::vector<Group>& groups) {
    if (run.economy.cache_megabytes && std::ranges::none_of(groups, has_several_textures))
        throw Error(ExitCode::usage,
                    "--cache does nothing: no bake has frames, and no two have one mesh and atlas; "
                    "leave it out");
}

/// Runs all bakes and prints a line for each where `speaks` is set. A line that cannot be written
/// does not stop the bakes: no more lines are printed, and the exception is returned.
std::exception_ptr run_all(const std::vector<Group>& groups, bool speaks, Progress& progress) {
    std::exception_ptr silenced;
    std::size_t count = 0, next = 0;
    for (const Group& group : groups) count += group.size();
    for (const Group& group : groups) {
        SharedMesh mesh;
        for (std::size_t i = 0; i < group.size(); ++i) {
            progress.begin_item(group[i]->job.command().out, next++, count, tasks::read);
            run_alone(*group[i], mesh, later_of(group, i));
            if (!speaks || silenced) continue;
            try {
                print_line(line_of(*group[i]));
            } catch (const std::system_error&) {
                silenced = std::current_exception();
            }
        }
    }
    return silenced;
}

void run_batch(BatchCommand command) {
    BakeCommand& run = command.run;
    check_report_options(run.json, run.report, run.quiet);
    Progress progress(progress_mode(run.progress, run.quiet));
    run.told = &progress;
    std::vector<Bake> bakes = check_manifest(command);
    const std::vector<Group> groups = groups_of(bakes);
    check_cache(run, groups);
    const std::exception_ptr silenced =
        run_all(groups, !run.json && !run.quiet && run.report != "-", progress);
    progress.finish();
    const Json report = batch_json(bakes);
    if (!run.report.empty()) write_json(run.report, report);
    if (run.json) write_json("-", report);
    const auto failed = std::ranges::count(bakes, "failed", &Bake::status);
    const auto first = std::ranges::find(bakes, "failed", &Bake::status);
    if (failed > 0)
        throw Error(first->code, fmt::format("{}: {} of {} bakes failed; the others are written",
                                             command.manifest, failed, bakes.size()));
    if (silenced) std::rethrow_exception(silenced);
}

}  // namespace

void add_batch(CLI::App& program) {
    auto* verb = program.add_subcommand(
        "batch", "Bake all that a manifest lists, sharing what several have in common");
    auto command = std::make_shared<BatchCommand>();
    verb->add_option("manifest", command->manifest,
                     "JSON file with the bakes: objects of `burl bake`'s options")
        ->required();
    add_run_options(*verb, command->run);
    add_report_options(*verb, command->run);
    verb->callback([command] { run_batch(*command); });
}

}  // namespace burl
