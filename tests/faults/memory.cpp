// Allocations: each is a call of the name "memory", or "large" from 64 KiB on, and null where it
// fails. C++'s operator new comes here, too.
#include <sys/mman.h>

#include <cerrno>
#include <cstddef>

#include "tests/faults/faults.h"

#define EXPORTED extern "C" __attribute__((visibility("default")))

extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* block, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
}

namespace {

bool fails(std::size_t bytes) {
    return faults::fails(bytes < 65536 ? "memory" : "large");
}

}  // namespace

EXPORTED void* malloc(std::size_t bytes) {
    return fails(bytes) ? nullptr : __libc_malloc(bytes);
}

EXPORTED void* calloc(std::size_t count, std::size_t bytes) {
    return fails(count * bytes) ? nullptr : __libc_calloc(count, bytes);
}

EXPORTED void* realloc(void* block, std::size_t bytes) {
    return fails(bytes) ? nullptr : __libc_realloc(block, bytes);
}

EXPORTED void* memalign(std::size_t alignment, std::size_t bytes) {
    return fails(bytes) ? nullptr : __libc_memalign(alignment, bytes);
}

EXPORTED void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
    return fails(bytes) ? nullptr : __libc_memalign(alignment, bytes);
}

EXPORTED int posix_memalign(void** block, std::size_t alignment, std::size_t bytes) {
    const int before = errno;
    *block = fails(bytes) ? nullptr : __libc_memalign(alignment, bytes);
    errno = before;
    return *block != nullptr ? 0 : ENOMEM;
}
