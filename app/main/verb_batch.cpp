// `burl batch`: many bakes from one manifest. Bakes of one mesh run one after another on one
// pipeline, so that the mesh is read once and atlas and solid points are computed once for all
// bakes that agree in them. Bakes whose outputs are up to date cost only the hashes of their
// inputs.
#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/bake/batch_run.h"
#include "app/bake/batch_schedule.h"
#include "app/base/messages.h"
#include "app/base/progress.h"
#include "app/main/batch_checks.h"
#include "app/main/verbs.h"
#include "app/options/input_limits.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

std::string line_of(const BatchBake& bake) {
    const std::string& out = bake.job.command().out;
    if (bake.status != "written") return fmt::format("{}: {}", out, bake.status);
    const std::string shared =
        bake.shared.empty() ? "" : fmt::format(", shared {}", fmt::join(bake.shared, ", "));
    return fmt::format("{}: written, {:.2f} s{}", out, bake.seconds, shared);
}

Json batch_json(const std::vector<BatchBake>& bakes) {
    Json list = Json::array();
    std::map<std::string, std::size_t> counts{{"written", 0}, {"up to date", 0}, {"failed", 0}};
    std::map<std::string, std::size_t> shared{
        {"mesh", 0}, {"connectivity", 0}, {"layout", 0}, {"spans", 0}};
    for (const BatchBake& bake : bakes) {
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

void check_cache(const BakeCommand& run, const std::vector<BatchGroup>& groups) {
    if (run.economy.cache_megabytes && std::ranges::none_of(groups, has_several_textures))
        throw Error(ExitCode::usage,
                    "--cache does nothing: no bake has frames, and no two have one mesh and atlas; "
                    "leave it out");
}

/// The number of bakes at a time: with OpenGL, whose context is one thread's, one.
int workers_of(const BatchCommand& command, const std::vector<BatchBake>& bakes) {
    const bool any_gl = std::ranges::any_of(
        bakes, [](const BatchBake& bake) { return bake.job.command().synth != "host"; });
    if (any_gl) return 1;
    return command.jobs > 0 ? command.jobs : int(std::thread::hardware_concurrency());
}

/// The lines of the bakes, printed as they are done. A line that cannot be written does not stop
/// the bakes: no more lines are printed, and the exception is kept.
class BatchLines {
  public:
    explicit BatchLines(bool speaks) : speaks_(speaks) {}
    void print(const BatchBake& bake) {
        const std::scoped_lock lock(mutex_);
        if (!speaks_ || silenced_) return;
        try {
            print_line(line_of(bake));
        } catch (const std::system_error&) {
            silenced_ = std::current_exception();
        }
    }
    void throw_if_silenced() const {
        if (silenced_) std::rethrow_exception(silenced_);
    }

  private:
    bool speaks_;
    std::exception_ptr silenced_;
    std::mutex mutex_;
};

/// The most bytes that a bake of the group holds.
std::uint64_t bytes_held(const BatchGroup& group) {
    std::uint64_t most = 0;
    for (const BatchBake* bake : group) most = std::max(most, bytes_held(bake->job));
    return most;
}

/// Tells the progress of bakes that workers make: of one worker task by task, of several bake by
/// bake.
class BatchProgress {
  public:
    BatchProgress(Progress& progress, std::size_t count, bool alone)
        : progress_(progress), count_(count), alone_(alone) {}
    void begins(const BatchBake& bake) {
        const std::scoped_lock lock(mutex_);
        progress_.begin_item(bake.job.command().out, done_, count_,
                             alone_ ? tasks::read : tasks::bakes);
    }
    void done() {
        const std::scoped_lock lock(mutex_);
        ++done_;
    }

  private:
    Progress& progress_;
    std::size_t done_ = 0, count_;
    bool alone_;
    std::mutex mutex_;
};

/// Bakes of one mesh are parted where that keeps all workers busy: each part reads the mesh anew.
constexpr std::size_t parts_per_worker = 4, fewest_in_a_part = 16;

void run_all(const BatchCommand& command, std::vector<BatchBake>& bakes, BatchLines& lines,
             Progress& progress, std::uint64_t budget) {
    std::vector<BatchGroup> groups = batch_groups(bakes);
    check_cache(command.run, groups);
    const int workers = workers_of(command, bakes);
    if (workers == 1)
        for (BatchBake& bake : bakes) bake.job.tell(progress.course());
    BatchProgress told(progress, bakes.size(), workers == 1);
    if (workers > 1)
        groups = split_groups(
            groups,
            std::max(fewest_in_a_part, bakes.size() / (std::size_t(workers) * parts_per_worker)));
    std::vector<QueuedJob> jobs;
    for (const BatchGroup& group : groups)
        jobs.push_back({bytes_held(group), [&group, &lines, &told] {
                            run_group(
                                group, [&](const BatchBake& bake) { told.begins(bake); },
                                [&](const BatchBake& bake) {
                                    lines.print(bake);
                                    told.done();
                                });
                        }});
    run_jobs(jobs, workers, budget);
}

/// Says of each bake whether it would be made.
void plan_all(std::vector<BatchBake>& bakes, BatchLines& lines) {
    for (BatchBake& bake : bakes) {
        bake.status = bake.job.known_report() ? "up to date" : "planned";
        lines.print(bake);
    }
}

/// Lists the failures, of which the first gives the exit code. Throws Error where there are any.
void throw_if_failed(const BatchCommand& command, const std::vector<BatchBake>& bakes) {
    const auto failed = std::ranges::count(bakes, "failed", &BatchBake::status);
    if (failed == 0) return;
    for (const BatchBake& bake : bakes)
        if (bake.status == "failed") warn(fmt::format("{}: {}", bake.where, bake.problem));
    throw Error(std::ranges::find(bakes, "failed", &BatchBake::status)->code,
                fmt::format("{}: {} of {} bakes failed; the others are written", command.name(),
                            failed, bakes.size()));
}

void run_batch(BatchCommand command) {
    BakeCommand& run = command.run;
    check_report_options(run.json, run.report, run.quiet);
    const std::uint64_t budget =
        command.memory.empty() ? default_budget() : memory_size("--memory", command.memory);
    Progress progress(progress_mode(run.progress, run.quiet));
    std::vector<BatchBake> bakes = checked_bakes(command);
    BatchLines lines(!run.json && !run.quiet && run.report != "-");
    if (command.dry_run)
        plan_all(bakes, lines);
    else
        run_all(command, bakes, lines, progress, budget);
    progress.finish();
    const Json report = batch_json(bakes);
    if (!run.report.empty()) write_json(run.report, report);
    if (run.json) write_json("-", report);
    throw_if_failed(command, bakes);
    lines.throw_if_silenced();
}

}  // namespace

void add_batch(CLI::App& program) {
    auto* verb = program.add_subcommand(
        "batch", "Bake all that a manifest or a matrix lists, sharing what several have in common");
    auto command = std::make_shared<BatchCommand>();
    verb->add_option("what", command->what,
                     "JSON file with the bakes, objects of `burl bake`'s options (- reads stdin); "
                     "or meshes and patterns of them, such as 'parts/*.obj'")
        ->required();
    const auto add_list = [&](const char* names, std::vector<std::string>& values,
                              const char* help) {
        verb->add_option(names, values, help)
            ->allow_extra_args(false)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    add_list("--recipe,-r", command->recipes, "Recipe for the meshes; may be repeated");
    add_list("--size,-s", command->sizes, "Side of the textures in texels; may be repeated");
    add_list("--with", command->others,
             "KEY=VALUE, or KEY for a flag: any other option of `burl bake`, without its dashes; "
             "several values of one KEY are a bake each");
    verb->add_option("--output,-o", command->output,
                     "Name of the meshes' outputs, as 'out/{mesh}_{recipe}_{size}.glb'; folders "
                     "are made");
    verb->add_option("--jobs", command->jobs, "Number of bakes at a time; 0 is one per core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    verb->add_option("--memory", command->memory,
                     "Memory for bakes at a time, such as 4G; left out: half of the machine's");
    verb->add_option("--shard", command->shard,
                     "I/N: bake part I of N only, for several machines or runs");
    verb->add_flag("--dry-run", command->dry_run, "Check all and say what would be baked");
    add_run_options(*verb, command->run);
    add_report_options(*verb, command->run);
    verb->callback([command] { run_batch(*command); });
}

}  // namespace burl
