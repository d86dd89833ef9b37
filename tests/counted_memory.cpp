#include "counted_memory.h"

#include <atomic>
#include <cstdlib>  // says whether the C library is GNU's
#include <new>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BURL_COUNTS_BYTES 1
#include <malloc.h>
#endif

namespace burl {
namespace {

std::atomic<std::size_t> held{0}, most{0}, before{0};

}  // namespace

bool counts_bytes() {
#ifdef BURL_COUNTS_BYTES
    return true;
#else
    return false;
#endif
}

void begin_peak() {
    before = held.load();
    most = before.load();
}

std::size_t peak_bytes() {
    return most - before;
}

}  // namespace burl

#ifdef BURL_COUNTS_BYTES

void* operator new(std::size_t bytes) {
    void* block = std::malloc(bytes > 0 ? bytes : 1);
    if (!block) throw std::bad_alloc();
    const std::size_t size = ::malloc_usable_size(block);
    const std::size_t now = burl::held.fetch_add(size) + size;
    std::size_t known = burl::most.load();
    while (now > known && !burl::most.compare_exchange_weak(known, now)) {
    }
    return block;
}

void operator delete(void* block) noexcept {
    if (!block) return;
    burl::held -= ::malloc_usable_size(block);
    std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
    operator delete(block);
}

#endif
