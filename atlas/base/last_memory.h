#pragma once
// Memory for destructors where the system has none left. Those of JSON values ask for some and may
// not throw: std::terminate would end the process, which may be that of a program that uses the
// library. So JSON values take blocks from here then (json.h).
#include <cstddef>
#include <new>

namespace burl {

/// Returns memory of that many bytes: operator new's, or where that has none, one of 32 blocks of
/// 32 KiB that are always there. Throws std::bad_alloc where these are taken or too small.
void* new_or_last_memory(std::size_t bytes);

/// Gives back what new_or_last_memory() returned.
void give_back_memory(void* memory, std::size_t bytes) noexcept;

/// An allocator that takes new_or_last_memory().
template <class T>
struct LastMemoryAllocator {
    using value_type = T;

    T* allocate(std::size_t count) {
        if (count > std::size_t(-1) / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(new_or_last_memory(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        give_back_memory(memory, count * sizeof(T));
    }
};

}  // namespace burl
