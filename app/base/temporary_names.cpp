#include "app/base/temporary_names.h"

#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <system_error>
#include <thread>

#include "app/base/atomic_file.h"

namespace burl {
namespace {

struct List {
    std::mutex mutex;
    std::set<std::string> names;
};

/// The process's only list; never destroyed, since a signal may arrive during exit, and made
/// without memory of the heap.
List& list() {
    alignas(List) static std::byte place[sizeof(List)];
    static auto* const all = new (place) List;
    return *all;
}

thread_local bool holds_list = false;

/// Ends the program by the signal's default action once all temporary files are removed.
[[noreturn]] void end_by_signal(int signal, const sigset_t& signals) {
    remove_temporary_files_for_good();
    std::signal(signal, SIG_DFL);
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    std::raise(signal);
    std::_Exit(128 + signal);  // the first process of a container ignores what it does not handle
}

}  // namespace

TemporaryNames::TemporaryNames() : lock_(list().mutex) {
    holds_list = true;
}

TemporaryNames::~TemporaryNames() {
    holds_list = false;
}

void TemporaryNames::add(const std::string& name) {
    list().names.insert(name);
}

void TemporaryNames::remove(const std::string& name) {
    list().names.erase(name);
}

void remove_temporary_files_for_good() {
    if (!holds_list) list().mutex.lock();
    for (const std::string& name : list().names) ::unlink(name.c_str());
}

void clean_up_on_signals() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler == SIG_DFL) ::sigaddset(&signals, signal);
    }
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    try {
        std::thread([signals] {
            int signal = 0;
            while (::sigwait(&signals, &signal) != 0) {
            }
            end_by_signal(signal, signals);
        }).detach();
    } catch (const std::system_error&) {  // without a thread signals end the program at once
        ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    }
}

}  // namespace burl
