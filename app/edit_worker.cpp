#include "app/edit_worker.h"

#include <exception>
#include <utility>

namespace burl {

EditWorker::EditWorker(Make make, std::function<void()> wake)
    : make_(std::move(make)),
      wake_(std::move(wake)),
      thread_([this](const std::stop_token& ending) { run(ending); }) {}

EditWorker::~EditWorker() {
    {
        const std::scoped_lock lock(mutex_);
        waiting_.reset();
        current_.request_stop();
    }
    thread_.request_stop();
}

void EditWorker::request(WorkerRequest request) {
    {
        const std::scoped_lock lock(mutex_);
        waiting_ = std::move(request);
        current_.request_stop();
    }
    changed_.notify_all();
}

bool EditWorker::idle() const {
    const std::scoped_lock lock(mutex_);
    return !busy_ && !waiting_;
}

void EditWorker::wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !busy_ && !waiting_; });
}

std::optional<std::string> EditWorker::take_problem() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(problem_, std::nullopt);
}

void EditWorker::run(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, ending, [&] { return waiting_.has_value(); })) {
        const WorkerRequest request = *std::exchange(waiting_, std::nullopt);
        current_ = std::stop_source();
        busy_ = true;
        const std::stop_token stop = current_.get_token();
        lock.unlock();
        work(request, stop);
        lock.lock();
        busy_ = false;
        lock.unlock();
        changed_.notify_all();
        wake_();
        lock.lock();
    }
}

void EditWorker::work(const WorkerRequest& request, const std::stop_token& stop) {
    try {
        for (std::uint32_t level = request.coarsest + 1; level-- > request.finest;) {
            if (stop.stop_requested() || !make_(request.recipe, level, stop)) return;
            if (level > request.finest) wake_();
        }
    } catch (const std::exception& problem) {
        const std::scoped_lock lock(mutex_);
        problem_ = problem.what();
    }
}

}  // namespace burl
