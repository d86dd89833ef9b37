// Calls that touch files, clocks, threads and libraries, each under its own name. What the C
// library calls within itself (the writes of stdio) does not come here.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/faults/faults.h"

#define EXPORTED extern "C" __attribute__((visibility("default")))

namespace {

using faults::fails;
using faults::Verdict;

/// The C library's function of the name, looked up once for each place that asks.
template <class Function, int Place>
Function* next(const char* name) {
    static auto* const found = reinterpret_cast<Function*>(faults::original(name));
    return found;
}

/// The bytes that a read or write of this verdict moves.
std::size_t allowed(Verdict verdict, std::size_t bytes) {
    return verdict == Verdict::cut && bytes > 1 ? bytes / 2 : bytes;
}

/// An hour more for every look at the clock, in seconds.
long hours_back() {
    static std::atomic<long> looks{0};
    static const bool goes_back = std::getenv("BURL_FAULT_CLOCK") != nullptr;
    return goes_back ? 3600 * ++looks : 0;
}

}  // namespace

#define NEXT(name) next<decltype(::name), __COUNTER__>(#name)
#define CALL(result, name, parameters, arguments, failure) \
    EXPORTED result name parameters {                      \
        if (fails(#name)) return failure;                  \
        return NEXT(name) arguments;                       \
    }

CALL(int, fsync, (int file), (file), -1)
CALL(int, close, (int file), (file), -1)
CALL(int, flock, (int file, int operation), (file, operation), -1)
CALL(int, fchmod, (int file, mode_t mode), (file, mode), -1)
CALL(int, fstat, (int file, struct stat* status), (file, status), -1)
CALL(int, stat, (const char* path, struct stat* status), (path, status), -1)
CALL(int, lstat, (const char* path, struct stat* status), (path, status), -1)
CALL(int, access, (const char* path, int mode), (path, mode), -1)
CALL(int, mkdir, (const char* path, mode_t mode), (path, mode), -1)
CALL(int, rename, (const char* from, const char* to), (from, to), -1)
CALL(int, renameat2, (int folder, const char* from, int other, const char* to, unsigned flags),
     (folder, from, other, to, flags), -1)
CALL(int, linkat, (int folder, const char* from, int other, const char* to, int flags),
     (folder, from, other, to, flags), -1)
CALL(int, unlink, (const char* path), (path), -1)
CALL(char*, getcwd, (char* path, std::size_t bytes), (path, bytes), nullptr)
CALL(ssize_t, readlink, (const char* path, char* to, std::size_t bytes), (path, to, bytes), -1)
CALL(DIR*, opendir, (const char* path), (path), nullptr)
CALL(struct dirent*, readdir, (DIR * folder), (folder), nullptr)

EXPORTED ssize_t read(int file, void* to, std::size_t bytes) {
    const Verdict verdict = faults::count("read");
    return verdict == Verdict::fail ? -1 : NEXT(read)(file, to, allowed(verdict, bytes));
}

EXPORTED ssize_t write(int file, const void* from, std::size_t bytes) {
    const Verdict verdict = faults::count("write");
    return verdict == Verdict::fail ? -1 : NEXT(write)(file, from, allowed(verdict, bytes));
}

EXPORTED ssize_t pwrite(int file, const void* from, std::size_t bytes, off_t place) {
    const Verdict verdict = faults::count("pwrite");
    return verdict == Verdict::fail ? -1 : NEXT(pwrite)(file, from, allowed(verdict, bytes), place);
}

EXPORTED int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const auto mode = va_arg(rest, mode_t);  // whatever lies there where no mode was given
    va_end(rest);
    return fails("open") ? -1 : NEXT(open)(path, flags, mode);
}

EXPORTED int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const auto mode = va_arg(rest, mode_t);
    va_end(rest);
    return fails("openat") ? -1 : NEXT(openat)(folder, path, flags, mode);
}

EXPORTED FILE* fopen(const char* path, const char* mode) {
    return fails("fopen") ? nullptr : NEXT(fopen)(path, mode);
}

EXPORTED int pthread_create(pthread_t* thread, const pthread_attr_t* kind, void* (*run)(void*),
                            void* argument) {
    if (fails("pthread_create")) return errno;
    return NEXT(pthread_create)(thread, kind, run, argument);
}

EXPORTED int clock_gettime(clockid_t clock, timespec* now) {
    const int result = NEXT(clock_gettime)(clock, now);
    if (clock == CLOCK_REALTIME) now->tv_sec -= hours_back();
    return result;
}

EXPORTED time_t time(time_t* now) {
    const time_t seconds = NEXT(time)(nullptr) - hours_back();
    if (now != nullptr) *now = seconds;
    return seconds;
}

EXPORTED int gettimeofday(timeval* now, void* zone) {
    const int result = NEXT(gettimeofday)(now, zone);
    now->tv_sec -= hours_back();
    return result;
}

EXPORTED void* dlopen(const char* path, int flags) {
    const char* const absent = std::getenv("BURL_FAULT_LIBRARY");
    if (absent != nullptr && path != nullptr && std::strstr(path, absent) != nullptr)
        path = "/nonexistent/absent.so";
    return NEXT(dlopen)(path, flags);
}
