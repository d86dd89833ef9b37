// Calls are numbered, and the one whose number has come does what the environment says.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/faults/faults.h"

namespace faults {
namespace {

thread_local int bypassed = 0;
std::atomic<unsigned long> counted{0};
std::atomic<bool> armed{false};

/// The settings, which are read once, before the first call is counted.
struct Settings {
    const char* calls = nullptr;
    const char* action = nullptr;
    const char* count_file = nullptr;
    unsigned long at = 0;
    int error = ENOMEM;
    bool forks = false;
} settings;

const char* variable(const char* name) {
    return std::getenv(name);
}

void read_settings() {
    settings.calls = variable("BURL_FAULT_CALLS");
    settings.action = variable("BURL_FAULT_ACTION");
    settings.count_file = variable("BURL_FAULT_COUNT");
    if (const char* at = variable("BURL_FAULT_AT")) settings.at = std::strtoul(at, nullptr, 10);
    if (const char* error = variable("BURL_FAULT_ERRNO")) settings.error = std::atoi(error);
    settings.forks = variable("BURL_FAULT_FORK") != nullptr;
}

/// Whether the name is one of the words, which commas part.
bool is_one_of(const char* name, const char* words) {
    const std::size_t length = std::strlen(name);
    for (const char* at = words; (at = std::strstr(at, name)) != nullptr; at += length)
        if ((at == words || at[-1] == ',') && (at[length] == ',' || at[length] == '\0'))
            return true;
    return false;
}

bool is_counted(const char* name) {
    if (!armed || bypassed > 0 || settings.calls == nullptr) return false;
    const bool allocates = is_one_of(name, "memory,large");
    if (std::strcmp(settings.calls, "files") == 0) return !allocates;
    return is_one_of(name, settings.calls);
}

/// Runs a command by the shell, without this library, and waits for it.
void run_command(const char* command) {
    const Bypass bypass;
    char shell[] = "sh", option[] = "-c";
    char* const arguments[] = {shell, option, const_cast<char*>(command), nullptr};
    char path[] = "PATH=/usr/bin:/bin";
    char* const environment[] = {path, nullptr};
    pid_t child = 0;
    if (::posix_spawn(&child, "/bin/sh", nullptr, nullptr, arguments, environment) == 0)
        ::waitpid(child, nullptr, 0);
}

Verdict act(const char* action) {
    if (std::strcmp(action, "short") == 0) return Verdict::cut;
    if (std::strncmp(action, "fail", 4) == 0) {
        errno = settings.error;
        return Verdict::fail;
    }
    if (std::strcmp(action, "kill") == 0) ::kill(::getpid(), SIGKILL);
    if (std::strncmp(action, "signal:", 7) == 0)
        ::kill(::getpid(), std::atoi(action + 7));
    else
        run_command(action);
    return Verdict::pass;
}

void write_count() {
    if (settings.count_file == nullptr) return;
    const Bypass bypass;
    char text[32];
    const int length = std::snprintf(text, sizeof text, "%lu\n", counted.load());
    const int file = ::open(settings.count_file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file >= 0 && ::write(file, text, std::size_t(length)) == length) ::close(file);
}

int (*real_main)(int, char**, char**) = nullptr;

int armed_main(int count, char** words, char** environment) {
    if (const char* locale = variable("BURL_FAULT_LOCALE"))
        if (std::setlocale(LC_ALL, locale) == nullptr) std::_Exit(99);
    std::atexit(write_count);
    armed = true;
    return real_main(count, words, environment);
}

__attribute__((constructor)) void begin() {
    read_settings();
    if (variable("BURL_FAULT_START")) armed = true;
}

}  // namespace

Bypass::Bypass() {
    ++bypassed;
}
Bypass::~Bypass() {
    --bypassed;
}

void* original(const char* name) {
    const Bypass bypass;
    return ::dlsym(RTLD_NEXT, name);
}

unsigned long calls_counted() {
    return counted;
}

Verdict count(const char* name) {
    if (!is_counted(name)) return Verdict::pass;
    const unsigned long number = ++counted;
    const char* const action = settings.action != nullptr ? settings.action : "fail";
    if (settings.forks) {
        const int error = errno;
        if (tries_in_fork(number)) {
            settings.forks = false, settings.count_file = nullptr;
            settings.at = number;
            return act(action);
        }
        errno = error;
        return Verdict::pass;
    }
    if (settings.at == 0) return Verdict::pass;
    const bool goes_on = std::strcmp(action, "fail-on") == 0;
    if (number == settings.at || (goes_on && number > settings.at)) return act(action);
    return Verdict::pass;
}

}  // namespace faults

// The C library calls main() from here; calls before it are those of the libraries' static objects.
extern "C" __attribute__((visibility("default"))) int __libc_start_main(
    int (*main)(int, char**, char**), int count, char** words, void (*begin)(), void (*end)(),
    void (*loader_end)(), void* stack_end) {
    faults::real_main = main;
    using Start = int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(),
                          void (*)(), void*);
    const auto start = reinterpret_cast<Start>(faults::original("__libc_start_main"));
    return start(faults::armed_main, count, words, begin, end, loader_end, stack_end);
}
