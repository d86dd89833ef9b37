#include "atlas/base/memory.h"

#include <cstdlib>  // also says whether the C library is GNU's
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace burl {

namespace {

constexpr std::size_t cache_line = 64, huge_page = std::size_t(2) << 20;

}  // namespace

void* allocate_pixels(std::size_t bytes) {
    const std::size_t alignment = bytes < 2 * huge_page ? cache_line : huge_page;
    constexpr std::size_t most = std::numeric_limits<std::ptrdiff_t>::max();
    if (bytes > most - alignment) throw std::bad_alloc();
    const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
    void* pixels = std::aligned_alloc(alignment, whole > 0 ? whole : alignment);
    if (!pixels) throw std::bad_alloc();
#ifdef __linux__
    if (alignment == huge_page) (void)madvise(pixels, whole, MADV_HUGEPAGE);  // may be refused
#endif
    return pixels;
}

void free_pixels(void* pixels) noexcept {
    std::free(pixels);
}

void return_freed_memory() {
#if defined(__GLIBC__)
    ::malloc_trim(0);
#endif
}

void return_large_blocks([[maybe_unused]] std::size_t triangles) {
#if defined(__GLIBC__)
    if (triangles > many_triangles) ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

}  // namespace burl
