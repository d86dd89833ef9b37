// Many numbers in one run: at each of them the program forks, the child's call fails, and the
// parent waits for the child's end, writes down what became of it, puts the output folder back as
// it was, and goes on. BURL_FAULT_FORK is FIRST:STEP:FOLDER:RESULTS. RESULTS/log gets a line
// "number, status of waitpid, whether the folder changed since the first, stderr", with tabs
// between; a folder that changed is copied to RESULTS/NUMBER. The program must run on one thread.
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/faults/faults.h"

namespace faults {
namespace {

namespace fs = std::filesystem;

/// A child that takes longer has hung, in seconds.
constexpr unsigned patience = 60;

struct Plan {
    unsigned long first = 1, step = 1;
    fs::path folder, results;

    Plan() {
        std::istringstream text(std::getenv("BURL_FAULT_FORK"));
        std::string word;
        std::getline(text, word, ':'), first = std::stoul(word);
        std::getline(text, word, ':'), step = std::stoul(word);
        std::getline(text, word, ':'), folder = word;
        std::getline(text, word), results = word;
    }
    bool has(unsigned long number) const { return number >= first && (number - first) % step == 0; }
};

/// The identity of a file, which another one of its name does not share.
struct Entry {
    std::string name;
    ino_t inode = 0;
    off_t bytes = 0;
    long seconds = 0, nanoseconds = 0;
    bool operator==(const Entry&) const = default;
};

std::vector<Entry> entries_of(const fs::path& folder) {
    std::vector<Entry> entries;
    for (const auto& one : fs::directory_iterator(folder)) {
        struct stat status {};
        ::lstat(one.path().c_str(), &status);
        entries.push_back({one.path().filename().string(), status.st_ino, status.st_size,
                           status.st_mtim.tv_sec, status.st_mtim.tv_nsec});
    }
    std::ranges::sort(entries, {}, &Entry::name);
    return entries;
}

/// Empties a folder, or makes it, and fills it with second names of another one's files.
void link_all(const fs::path& from, const fs::path& to) {
    fs::create_directories(to);
    for (const auto& old : fs::directory_iterator(to)) fs::remove(old.path());
    for (const auto& one : fs::directory_iterator(from))
        ::link(one.path().c_str(), (to / one.path().filename()).c_str());
}

/// The open files, but for the standard streams.
std::vector<int> open_files() {
    std::vector<int> files;
    for (const auto& one : fs::directory_iterator("/proc/self/fd"))
        if (const int file = std::stoi(one.path().filename()); file > 2) files.push_back(file);
    return files;
}

/// Gives this process a nameless file of its own in place of the one that it shares with its
/// parent.
void part_from_parent(int file) {
    struct stat status {};
    if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || status.st_nlink > 0) return;
    if ((::fcntl(file, F_GETFL) & O_ACCMODE) == O_RDONLY) return;
    const fs::path name = fs::read_symlink("/proc/self/fd/" + std::to_string(file));
    const int own = ::open(name.parent_path().c_str(), O_TMPFILE | O_RDWR, status.st_mode);
    std::string bytes(std::size_t(status.st_size), '\0');
    const bool copied = ::pread(file, bytes.data(), bytes.size(), 0) == ssize_t(bytes.size()) &&
                        ::pwrite(own, bytes.data(), bytes.size(), 0) == ssize_t(bytes.size());
    if (!copied) std::_Exit(98);
    ::lseek(own, ::lseek(file, 0, SEEK_CUR), SEEK_SET);
    ::dup3(own, file, O_CLOEXEC);
    ::close(own);
    ::flock(file, LOCK_EX);
}

void become_child(const fs::path& messages) {
    ::alarm(patience);
    const int err = ::open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
    const int null = ::open("/dev/null", O_WRONLY);
    ::dup2(err, 2);
    ::dup2(null, 1);
    ::close(err);
    ::close(null);
    for (const int file : open_files()) part_from_parent(file);
}

/// The file's text as one line without tabs.
std::string message_in(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    std::string line = text.str();
    std::ranges::replace(line, '\t', ' ');
    for (std::size_t at = 0; (at = line.find('\n', at)) != std::string::npos;)
        line.replace(at, 1, "\\n");
    return line;
}

/// Writes down how the child ended, and puts the folder back if it changed.
void conclude(const Plan& plan, unsigned long number, int status, const std::vector<Entry>& first,
              const std::vector<Entry>& before) {
    const std::vector<Entry> now = entries_of(plan.folder);
    const bool changed = now != first;
    if (changed) fs::copy(plan.folder, plan.results / std::to_string(number));
    if (now != before) link_all(plan.results / "snapshot", plan.folder);
    std::ofstream(plan.results / "log", std::ios::app)
        << number << '\t' << status << '\t' << changed << '\t'
        << message_in(plan.results / "messages") << '\n';
}

}  // namespace

bool tries_in_fork(unsigned long number) {
    const Bypass bypass;
    static const Plan plan;
    static std::vector<Entry> kept;
    static const std::vector<Entry> first = entries_of(plan.folder);
    static bool has_kept = false;
    if (!plan.has(number)) return false;
    const std::vector<Entry> before = entries_of(plan.folder);
    if (!has_kept || before != kept) link_all(plan.folder, plan.results / "snapshot");
    kept = before, has_kept = true;
    std::vector<std::pair<int, off_t>> places;
    for (const int file : open_files()) places.emplace_back(file, ::lseek(file, 0, SEEK_CUR));
    const pid_t child = ::fork();
    if (child == 0) {
        become_child(plan.results / "messages");
        return true;
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    for (const auto& [file, place] : places)
        if (place >= 0) ::lseek(file, place, SEEK_SET);
    conclude(plan, number, status, first, before);
    return false;
}

}  // namespace faults
