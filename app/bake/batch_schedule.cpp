#include "app/bake/batch_schedule.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

/// The queue: who has started, and what the running jobs hold.
class JobQueue {
  public:
    JobQueue(std::span<const QueuedJob> jobs, std::uint64_t budget)
        : jobs_(jobs), budget_(budget), started_(jobs.size(), false) {}

    /// Runs jobs until none is left to start.
    void work() {
        std::unique_lock lock(mutex_);
        while (waiting_ < jobs_.size()) {
            const std::size_t next = next_that_fits();
            if (next == jobs_.size()) {
                changed_.wait(lock);
                continue;
            }
            const QueuedJob& job = jobs_[next];
            started_[next] = true;
            while (waiting_ < jobs_.size() && started_[waiting_]) ++waiting_;
            held_ += job.bytes;
            ++running_;
            lock.unlock();
            job.run();
            lock.lock();
            held_ -= job.bytes;
            --running_;
            changed_.notify_all();
        }
        changed_.notify_all();
    }

  private:
    /// The first waiting job that fits beside the running ones; their number where none does.
    std::size_t next_that_fits() const {
        for (std::size_t i = waiting_; i < jobs_.size(); ++i)
            if (!started_[i] && (running_ == 0 || held_ + jobs_[i].bytes <= budget_)) return i;
        return jobs_.size();
    }

    std::span<const QueuedJob> jobs_;
    std::uint64_t budget_, held_ = 0;
    std::size_t running_ = 0;
    std::size_t waiting_ = 0;  ///< the first job that has not started
    std::vector<bool> started_;
    std::mutex mutex_;
    std::condition_variable changed_;
};

std::uint64_t file_bytes(const std::string& path) {
    std::error_code missing;
    const auto bytes = std::filesystem::file_size(path, missing);
    return missing ? 0 : bytes;
}

}  // namespace

void run_jobs(std::span<const QueuedJob> jobs, int workers, std::uint64_t budget) {
    JobQueue queue(jobs, budget);
    std::vector<std::jthread> others;
    try {
        for (int i = 1; i < workers && std::size_t(i) < jobs.size(); ++i)
            others.emplace_back([&] { queue.work(); });
    } catch (const std::system_error&) {  // fewer do the same
    }
    queue.work();
}

// The factors are those of docs/lab/batch.md, rounded up.
std::uint64_t bytes_held(const BakeJob& job) {
    const AtlasOptions& atlas = job.recipe().atlas;
    const std::string& mesh = job.command().mesh;
    const std::uint64_t texels = std::uint64_t(atlas.columns()) * atlas.rows();
    const bool in_text = mesh.ends_with(".obj") || mesh.ends_with(".off");
    const std::uint64_t shape = is_sample_mesh(mesh) ? 0 : (in_text ? 16 : 32) * file_bytes(mesh);
    const std::uint64_t pictures = job.pictures();
    const bool in_floats = !job.command().levels.empty() || job.command().out.ends_with(".exr");
    const std::uint64_t per_texel = !in_floats ? 7 * pictures : pictures == 1 ? 16 : 32 * pictures;
    return (std::uint64_t(40) << 20U) + shape + per_texel * texels;
}

std::uint64_t default_budget() {
    return std::uint64_t(sysconf(_SC_PHYS_PAGES)) * std::uint64_t(sysconf(_SC_PAGE_SIZE)) / 2;
}

}  // namespace burl
