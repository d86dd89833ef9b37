#include "app/base/out_of_memory.h"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "app/base/temporary_names.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

/// Memory that unwinding and a sentence need at most, in bytes.
constexpr std::size_t enough_to_go_on = 1u << 16;

std::string_view last_line;

[[noreturn]] void end_without_memory() {
    remove_temporary_files_for_good();
    [[maybe_unused]] const auto told = ::write(STDERR_FILENO, last_line.data(), last_line.size());
    std::_Exit(int(ExitCode::runtime));
}

/// Called where C++'s allocation fails: returns for another try, throws or ends the program.
void on_failed_allocation() {
    void* const probe = std::malloc(enough_to_go_on);
    std::free(probe);
    if (probe == nullptr) end_without_memory();
    // The block may be small, and another thread's memory come back: every second failure is told.
    thread_local bool tried = false;
    tried = !tried;
    if (!tried) throw std::bad_alloc();
}

/// Called where an exception has nowhere to go, as out of a destructor of a library.
[[noreturn]] void on_terminate() {
    if (const std::exception_ptr thrown = std::current_exception()) {
        try {
            std::rethrow_exception(thrown);
        } catch (const std::bad_alloc&) {
            end_without_memory();
        } catch (...) {
        }
    }
    std::abort();
}

}  // namespace

void end_where_memory_ends(std::string_view line) {
    last_line = line;
    std::set_new_handler(on_failed_allocation);
    std::set_terminate(on_terminate);
}

std::string words_of(const std::exception& problem) {
    const bool ended = dynamic_cast<const std::bad_alloc*>(&problem) != nullptr;
    return ended ? "out of memory" : problem.what();
}

}  // namespace burl
