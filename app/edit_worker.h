#pragma once
// Textures made beside the user interface: the latest recipe wins, work on an older one is told to
// stop, and a texture comes coarse first and is refined (Hart et al. 1999 drew a low resolution
// while a slider moved).
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/recipe.h"

namespace burl {

/// What shall be shown: levels from `coarsest` down to `finest` of the recipe's texture, one after
/// the other.
struct WorkerRequest {
    Recipe recipe{};
    std::uint32_t coarsest = 0, finest = 0;
};

/// Runs `make` on a thread of its own. All functions may be called by one other thread.
class EditWorker {
  public:
    /// Makes a level and hands it over, to whom is its own affair; false when `stop` came first.
    /// What it throws is kept for problem().
    using Make = std::function<bool(const Recipe&, std::uint32_t level, const std::stop_token&)>;
    /// `wake` is called by the worker's thread after every level and at the end of a request.
    EditWorker(Make make, std::function<void()> wake);
    EditWorker(const EditWorker&) = delete;
    EditWorker& operator=(const EditWorker&) = delete;
    /// Stops what is under way and waits for it.
    ~EditWorker();

    /// From now on this counts; older requests are dropped or stopped.
    void request(WorkerRequest request);
    /// Nothing is under way or waits.
    bool idle() const;
    /// Waits until idle().
    void wait() const;
    /// Why the last request failed, once.
    std::optional<std::string> take_problem();

  private:
    void run(const std::stop_token& ending);
    void work(const WorkerRequest& request, const std::stop_token& stop);

    Make make_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::optional<WorkerRequest> waiting_;
    std::stop_source current_{std::nostopstate};
    bool busy_ = false;
    std::optional<std::string> problem_;
    std::jthread thread_;  ///< last: it sees all the others
};

}  // namespace burl
