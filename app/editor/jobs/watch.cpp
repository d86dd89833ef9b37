#include "app/editor/jobs/watch.h"

#include <algorithm>
#include <utility>

#include <sys/stat.h>

namespace burl {

namespace {

std::optional<FileStamp> stamp_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return FileStamp{status.st_mtim.tv_sec, status.st_mtim.tv_nsec, std::uint64_t(status.st_size),
                     std::uint64_t(status.st_ino)};
}

}  // namespace

WatchedFiles look_at(std::vector<std::string> paths) {
    WatchedFiles files{std::move(paths)};
    for (const std::string& path : files.paths) files.stamps.push_back(stamp_of(path));
    return files;
}

bool FileChange::look(WatchedFiles now) {
    const bool rests = now == last_;
    last_ = std::move(now);
    const auto is_there = [](const auto& stamp) { return stamp.has_value(); };
    if (!rests || last_ == known_ || !std::ranges::all_of(last_.stamps, is_there)) return false;
    known_ = last_;
    return true;
}

void FileWatch::watch(FileKind kind, WatchedFiles files) {
    const std::scoped_lock lock(mutex_);
    changes_[std::size_t(kind)] = FileChange(std::move(files));
    changed_[std::size_t(kind)] = false;
    ++versions_[std::size_t(kind)];
}

/// Looks at the files of one kind; the mutex is not held while the disk answers.
bool FileWatch::look(FileKind kind) {
    const auto k = std::size_t(kind);
    std::unique_lock lock(mutex_);
    const std::uint64_t version = versions_[k];
    std::vector<std::string> paths = changes_[k].paths();
    lock.unlock();
    WatchedFiles now = look_at(std::move(paths));
    lock.lock();
    if (version != versions_[k] || !changes_[k].look(std::move(now))) return false;
    changed_[k] = true;
    return true;
}

bool FileWatch::look() {
    bool news = false;
    for (std::size_t kind = 0; kind < file_kinds; ++kind) news |= look(FileKind(kind));
    return news;
}

void FileWatch::start(std::function<void()> wake, std::chrono::milliseconds period) {
    thread_ = std::jthread([this, wake = std::move(wake), period](const std::stop_token& ending) {
        run(ending, wake, period);
    });
}

void FileWatch::run(const std::stop_token& ending, const std::function<void()>& wake,
                    std::chrono::milliseconds period) {
    while (!ending.stop_requested()) {
        if (look()) wake();
        std::unique_lock lock(mutex_);
        ending_.wait_for(lock, ending, period, [] { return false; });
    }
}

bool FileWatch::take(FileKind kind) {
    const std::scoped_lock lock(mutex_);
    return std::exchange(changed_[std::size_t(kind)], false);
}

}  // namespace burl
