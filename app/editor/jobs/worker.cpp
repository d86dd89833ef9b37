#include "app/editor/jobs/worker.h"

#include <exception>
#include <utility>

#include "app/base/out_of_memory.h"

namespace burl {

JobQueue::JobQueue() : thread_([this](const std::stop_token& ending) { run(ending); }) {}

void JobQueue::end() {
    {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
    }
    cancel();
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void JobQueue::add(Job job) {
    {
        const std::scoped_lock lock(mutex_);
        if (ended_) return;
        waiting_.push_back(std::move(job));
    }
    changed_.notify_all();
}

void JobQueue::cancel() {
    const std::scoped_lock lock(mutex_);
    waiting_.clear();
    current_.request_stop();
}

void JobQueue::hold(bool held) {
    {
        const std::scoped_lock lock(mutex_);
        if (std::exchange(held_, held) == held) return;
    }
    changed_.notify_all();
}

bool JobQueue::idle() const {
    const std::scoped_lock lock(mutex_);
    return !busy_ && waiting_.empty();
}

void JobQueue::wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !busy_ && waiting_.empty(); });
}

void JobQueue::run(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, ending, [&] { return !held_ && !waiting_.empty(); })) {
        const Job job = std::move(waiting_.front());
        waiting_.pop_front();
        current_ = std::stop_source();
        busy_ = true;
        const std::stop_token stop = current_.get_token();
        lock.unlock();
        job(stop);
        lock.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

EditWorker::EditWorker(Work work, std::function<void()> wake)
    : work_(std::move(work)),
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
        if (!moving_) current_.request_stop();
    }
    changed_.notify_all();
}

void EditWorker::again() {
    {
        const std::scoped_lock lock(mutex_);
        if (waiting_ || !last_) return;
        waiting_ = last_;
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
        last_ = request;
        current_ = std::stop_source();
        busy_ = true;
        moving_ = request.moving;
        const std::stop_token stop = current_.get_token();
        lock.unlock();
        attempt(request, stop);
        lock.lock();
        busy_ = false;
        lock.unlock();
        changed_.notify_all();
        wake_();
        lock.lock();
    }
}

void EditWorker::attempt(const WorkerRequest& request, const std::stop_token& stop) {
    try {
        work_(request, stop);
    } catch (const std::exception& problem) {
        const std::scoped_lock lock(mutex_);
        problem_ = words_of(problem);
    }
}

}  // namespace burl
