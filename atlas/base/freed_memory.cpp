#include "atlas/base/freed_memory.h"

#include <cstdlib>  // says whether the C library is GNU's

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace burl {

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
