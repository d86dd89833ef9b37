// Linked into every program that is built with the address sanitizer: waits for the threads of
// oneTBB before the leak check at a program's end. The library tells them to go and does not wait;
// one that goes while the check walks through its memory ends the check with a signal (about one
// run in two thousand on a busy machine).
#include <tbb/global_control.h>

#include <cstdlib>
#include <new>

namespace {

void end_workers() {
    tbb::task_scheduler_handle workers{tbb::attach{}};
    tbb::finalize(workers, std::nothrow);
}

const int registered = std::atexit(end_workers);

}  // namespace
