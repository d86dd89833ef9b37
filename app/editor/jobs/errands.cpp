#include "app/editor/jobs/errands.h"

#include <utility>

namespace burl {

EditErrands::EditErrands() : thread_([this](const std::stop_token& ending) { run(ending); }) {}

void EditErrands::end() {
    {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
    }
    cancel();
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void EditErrands::add(Errand errand) {
    {
        const std::scoped_lock lock(mutex_);
        if (ended_) return;
        waiting_.push_back(std::move(errand));
    }
    changed_.notify_all();
}

void EditErrands::cancel() {
    const std::scoped_lock lock(mutex_);
    waiting_.clear();
    current_.request_stop();
}

void EditErrands::hold(bool held) {
    {
        const std::scoped_lock lock(mutex_);
        if (std::exchange(held_, held) == held) return;
    }
    changed_.notify_all();
}

bool EditErrands::idle() const {
    const std::scoped_lock lock(mutex_);
    return !busy_ && waiting_.empty();
}

void EditErrands::wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !busy_ && waiting_.empty(); });
}

void EditErrands::run(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, ending, [&] { return !held_ && !waiting_.empty(); })) {
        const Errand errand = std::move(waiting_.front());
        waiting_.pop_front();
        current_ = std::stop_source();
        busy_ = true;
        const std::stop_token stop = current_.get_token();
        lock.unlock();
        errand(stop);
        lock.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

}  // namespace burl
