// Allocations: each is a call of the name "memory", or "large" from 64 KiB on, and null where it
// fails. C++'s operator new comes here, too.
#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "tests/faults/faults.h"

#define CALLER __builtin_return_address(0)
#define EXPORTED extern "C" __attribute__((visibility("default")))

extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* block, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
}

namespace {

/// Whether one of the names, with commas between, is a part of the name of the library that has the
/// code at the address. Code of no library was made by one of them.
bool is_of_one(const char* names, void* address) {
    const faults::Bypass bypass;
    Dl_info place{};
    if (::dladdr(address, &place) == 0 || place.dli_fname == nullptr) return true;
    char name[256];
    for (const char* at = names; *at != '\0';) {
        const std::size_t length = std::strcspn(at, ",");
        if (length >= sizeof name) return false;
        std::memcpy(name, at, length);
        name[length] = '\0';
        if (std::strstr(place.dli_fname, name) != nullptr) return true;
        at += length + (at[length] == ',' ? 1 : 0);
    }
    return false;
}

/// Whether BURL_FAULT_SPARED spares allocations by the code at the address. Answers are kept, with
/// the address doubled to leave a bit for them.
bool spared(void* address) {
    static const char* const names = std::getenv("BURL_FAULT_SPARED");
    static std::array<std::atomic<std::uintptr_t>, 65536> known{};
    if (names == nullptr) return false;
    const auto doubled = 2 * reinterpret_cast<std::uintptr_t>(address);
    std::atomic<std::uintptr_t>& kept = known[doubled / 2 % known.size()];
    const std::uintptr_t before = kept;
    if ((before & ~std::uintptr_t(1)) == doubled) return (before & 1) != 0;
    const bool answer = is_of_one(names, address);
    kept = doubled | std::uintptr_t(answer);
    return answer;
}

bool fails(std::size_t bytes, void* caller) {
    return !spared(caller) && faults::fails(bytes < 65536 ? "memory" : "large");
}

}  // namespace

EXPORTED void* malloc(std::size_t bytes) {
    return fails(bytes, CALLER) ? nullptr : __libc_malloc(bytes);
}

EXPORTED void* calloc(std::size_t count, std::size_t bytes) {
    return fails(count * bytes, CALLER) ? nullptr : __libc_calloc(count, bytes);
}

EXPORTED void* realloc(void* block, std::size_t bytes) {
    return fails(bytes, CALLER) ? nullptr : __libc_realloc(block, bytes);
}

EXPORTED void* memalign(std::size_t alignment, std::size_t bytes) {
    return fails(bytes, CALLER) ? nullptr : __libc_memalign(alignment, bytes);
}

EXPORTED void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
    return fails(bytes, CALLER) ? nullptr : __libc_memalign(alignment, bytes);
}

EXPORTED int posix_memalign(void** block, std::size_t alignment, std::size_t bytes) {
    const int before = errno;
    *block = fails(bytes, CALLER) ? nullptr : __libc_memalign(alignment, bytes);
    errno = before;
    return *block != nullptr ? 0 : ENOMEM;
}
