#include "app/bake/batch_run.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <optional>

#include <fmt/format.h>

#include "app/bake/up_to_date.h"
#include "app/base/stopwatch.h"
#include "atlas/base/memory.h"
#include "atlas/base/real_path.h"

namespace burl {
namespace {

/// A key that is equal for bakes that can use one pipeline.
std::string mesh_key(const BatchBake& bake) {
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

/// Sorts bakes of a mesh so that those with the same atlas, and then the same space, are adjacent,
/// in the order of their first occurrence.
void put_in_order(BatchGroup& group) {
    const auto rank = [group](const auto& same) {
        return [group, same](const BatchBake* bake) {
            return std::ranges::find_if(group,
                                        [&](const BatchBake* other) {
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

void fail(BatchBake& bake, ExitCode why, const std::string& sentence) {
    bake.status = "failed", bake.code = why, bake.problem = sentence;
}

/// Makes the folders of the outputs that are missing.
void make_folders(const BatchBake& bake) {
    for (const std::string& file : bake.files())
        if (const auto folder = std::filesystem::path(file).parent_path(); !folder.empty()) {
            std::error_code failed;
            std::filesystem::create_directories(folder, failed);
            if (failed)
                throw Error(ExitCode::io, fmt::format("cannot make the folder {}: {}",
                                                      folder.string(), failed.message()));
        }
}

void run(BatchBake& bake, SharedMesh& mesh, LaterBake later) {
    if (bake.job.known_report()) {
        bake.status = "up to date";
        return;
    }
    const auto synthesizer = bake.job.synthesizer();
    const bool had_mesh = mesh.read(bake.job);
    make_folders(bake);
    const StageRecords before = mesh.pipeline().records();
    bake.job.run(mesh.pipeline(), synthesizer, had_mesh ? 0.0 : mesh.seconds(), later);
    if (had_mesh) {
        bake.shared = kept_stages(before, mesh.pipeline().records());
        bake.shared.insert(bake.shared.begin(), "mesh");
    }
    bake.status = "written";
}

/// Runs a bake; its errors do not end the batch.
void run_alone(BatchBake& bake, SharedMesh& mesh, LaterBake later) {
    const auto start = std::chrono::steady_clock::now();
    try {
        run(bake, mesh, later);
    } catch (const Error& error) {
        fail(bake, error.code(), error.what());
    } catch (const std::bad_alloc&) {
        fail(bake, ExitCode::runtime, "out of memory; try a smaller size or mesh");
    } catch (const std::exception& error) {  // a library's, such as a thread that cannot begin
        fail(bake, ExitCode::runtime, error.what());
    }
    bake.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

LaterBake later_of(const BatchGroup& group, std::size_t i) {
    if (i + 1 == group.size()) return LaterBake::none;
    const bool same = group[i]->job.recipe().atlas == group[i + 1]->job.recipe().atlas;
    return same ? LaterBake::atlas : LaterBake::mesh;
}

}  // namespace

std::vector<std::string> BatchBake::files() const {
    std::vector<std::string> files = job.outputs();
    files.push_back(record_path(job.command().out));
    return files;
}

std::vector<BatchGroup> batch_groups(std::vector<BatchBake>& bakes) {
    std::vector<BatchGroup> groups;
    std::map<std::string, std::size_t> known;
    for (BatchBake& bake : bakes) {
        const auto [place, fresh] = known.emplace(mesh_key(bake), groups.size());
        if (fresh) groups.emplace_back();
        groups[place->second].push_back(&bake);
    }
    std::ranges::for_each(groups, put_in_order);
    return groups;
}

std::vector<BatchGroup> split_groups(const std::vector<BatchGroup>& groups, std::size_t most) {
    std::vector<BatchGroup> parts;
    for (const BatchGroup& group : groups)
        for (std::size_t i = 0; i < group.size(); i += most)
            parts.emplace_back(group.begin() + std::ptrdiff_t(i),
                               group.begin() + std::ptrdiff_t(std::min(group.size(), i + most)));
    return parts;
}

bool has_several_textures(const BatchGroup& group) {
    for (std::size_t i = 0; i < group.size(); ++i)
        if (group[i]->job.command().animation.asked() || later_of(group, i) == LaterBake::atlas)
            return true;
    return false;
}

void run_group(const BatchGroup& group, const std::function<void(const BatchBake&)>& begins,
               const std::function<void(const BatchBake&)>& done) {
    SharedMesh mesh;
    for (std::size_t i = 0; i < group.size(); ++i) {
        begins(*group[i]);
        run_alone(*group[i], mesh, later_of(group, i));
        done(*group[i]);
    }
}

}  // namespace burl
