#include "procedural/cache/texel_layout.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace burl {

void* allot_cache(std::size_t bytes) {
    constexpr std::size_t cache_line = 64, large_page = std::size_t(1) << 21;
    const std::size_t step = bytes < 2 * large_page ? cache_line : large_page;
    void* const memory = std::aligned_alloc(step, (bytes / step + 1) * step);
    if (!memory) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
    // Advice for whole large pages only, so that no memory is taken that is not used; the system
    // may refuse it.
    if (step == large_page) ::madvise(memory, bytes / large_page * large_page, MADV_HUGEPAGE);
#endif
    return memory;
}

TexelLayout::TexelLayout(const SolidAtlas& solid) {
    std::size_t numbers = 0;
    for (std::size_t y = 0; y < solid.size; ++y) {
        begin_.push_back(numbers);
        run_begin_.push_back(runs_.size());
        for (const Span& span : solid.row(y)) {
            const bool goes_on =
                runs_.size() > run_begin_.back() && runs_.back().x + runs_.back().count == span.x;
            if (!goes_on) runs_.push_back({span.x, 0});
            runs_.back().count += span.count;
            numbers += span.count;
            texels_ += span.count;
        }
        numbers = (numbers + batch_padding - 1) / batch_padding * batch_padding;
    }
    begin_.push_back(numbers);
    run_begin_.push_back(runs_.size());
}

}  // namespace burl
