#pragma once
// A library that is loaded before the C library (LD_PRELOAD) and makes calls of it go wrong. What
// it does is told by environment variables:
//   BURL_FAULT_CALLS    the calls that are numbered from 1 on, with commas between: "memory,large"
//                       (malloc and its kin, of less than 64 KiB and more), or names such as
//                       "write,fsync"; "files" stands for all of calls.cpp
//   BURL_FAULT_AT       the number at which the action happens; 0: nothing happens, calls are only
//                       counted
//   BURL_FAULT_ACTION   "fail" (once), "fail-on" (from then on), "short" (half of a read or write),
//                       "kill" (SIGKILL to itself), "signal:N" (to itself), or a command for the
//                       shell, run before the call goes on
//   BURL_FAULT_ERRNO    the number of the error; 0 or left out: ENOMEM
//   BURL_FAULT_COUNT    a file that gets the number of calls when the program ends
//   BURL_FAULT_START    set: also calls before main() are numbered
//   BURL_FAULT_FORK     FIRST:STEP:FOLDER:RESULTS, in place of BURL_FAULT_AT, tries many numbers in
//                       one run (forks.cpp)
//   BURL_FAULT_SPARED   parts of libraries' names, with commas between, whose own allocations are
//                       not numbered
//   BURL_FAULT_CLOCK    "back": every look at the clock shows an hour less than the one before
//   BURL_FAULT_LOCALE   the locale that is set before main()
//   BURL_FAULT_LIBRARY  libraries with this in their name are not found by dlopen()
// A child that the program starts has none of these.
#include <cstddef>

namespace faults {

/// The fate of a call.
enum class Verdict { pass, fail, cut };

/// Counts a call of this name and says what it is to do; acts where its number has come. errno is
/// set where it is to fail.
Verdict count(const char* name);

/// Whether the call of this name, which has no short form, is to fail; errno is set then.
inline bool fails(const char* name) {
    return count(name) == Verdict::fail;
}

/// Number of the call that was counted last.
unsigned long calls_counted();

/// Tries the call `number` in a forked process, if it is one of BURL_FAULT_FORK. Returns true in
/// the process whose call is to fail.
bool tries_in_fork(unsigned long number);

/// Calls by this thread go straight to the C library while an object of this class lives.
struct Bypass {
    Bypass();
    ~Bypass();
    Bypass(const Bypass&) = delete;
    Bypass& operator=(const Bypass&) = delete;
};

/// The C library's own function of this name.
void* original(const char* name);

}  // namespace faults
