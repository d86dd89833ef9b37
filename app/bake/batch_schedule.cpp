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
    for (int i = 1; i < workers && std::size_t(i) < jobs.size(); ++i)
        others.emplace_back([&] { queue.work(); });
    queue.work();
}

std::uint64_t bytes_held(const BakeJob& job) {
    const AtlasOptions& atlas = job.recipe().atlas;
    const std::uint64_t texels = std::uint64_t(atlas.columns()) * atlas.rows();
    const std::uint64_t mesh =
        is_sample_mesh(job.command().mesh) ? 1U << 20U : file_bytes(job.command().mesh);
    const auto pictures = std::uint64_t(job.outputs().size()) + 2;
    const std::uint64_t per_texel = job.command().levels.empty() ? 8 : 24;
    return (std::uint64_t(48) << 20U) + 16 * mesh + per_texel * pictures * texels;
}

std::uint64_t memory_size(const std::string& text) {
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, number);
    const std::string unit(stop, end);
    const int shift = unit == "K" ? 10 : unit.empty() || unit == "M" ? 20 : unit == "G" ? 30 : 0;
    if (failure != std::errc() || shift == 0 || !(number > 0.0 && number < 1e9))
        throw Error(ExitCode::usage,
                    fmt::format("--memory {}: must be a size such as 512M or 4G", text));
    return std::uint64_t(number * double(std::uint64_t(1) << unsigned(shift)));
}

std::uint64_t default_budget() {
    return std::uint64_t(sysconf(_SC_PHYS_PAGES)) * std::uint64_t(sysconf(_SC_PAGE_SIZE)) / 2;
}

}  // namespace burl
