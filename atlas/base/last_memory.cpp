#include "atlas/base/last_memory.h"

#include <atomic>
#include <bit>
#include <cstdint>

namespace burl {
namespace {

constexpr std::size_t block_bytes = 32768, block_count = 32;
alignas(std::max_align_t) std::byte blocks[block_count][block_bytes];
std::atomic<std::uint32_t> taken{0};  ///< a bit for each block

/// Returns a block that nobody has, or null.
void* last_block() {
    for (std::uint32_t before = taken; ~before != 0;) {
        const int number = std::countr_one(before);
        if (taken.compare_exchange_weak(before, before | std::uint32_t(1) << number))
            return blocks[number];
    }
    return nullptr;
}

/// Whether the memory is a block, which then is free again.
bool gave_back(void* memory) {
    const auto place = reinterpret_cast<std::uintptr_t>(memory);
    const auto first = reinterpret_cast<std::uintptr_t>(blocks);
    if (place < first || place >= first + sizeof blocks) return false;
    taken &= ~(std::uint32_t(1) << (place - first) / block_bytes);
    return true;
}

}  // namespace

void* new_or_last_memory(std::size_t bytes) {
    try {
        return ::operator new(bytes);
    } catch (const std::bad_alloc&) {
        void* const block = bytes <= block_bytes ? last_block() : nullptr;
        if (block == nullptr) throw;
        return block;
    }
}

void give_back_memory(void* memory, std::size_t bytes) noexcept {
    if (gave_back(memory)) return;
#ifdef __cpp_sized_deallocation
    ::operator delete(memory, bytes);
#else
    static_cast<void>(bytes);
    ::operator delete(memory);
#endif
}

}  // namespace burl
