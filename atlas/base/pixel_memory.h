#pragma once
// Memory of images. A texture of 4096 x 4096 pixels comes in twelve thousand small pages, and to
// clear them one by one takes a tenth of the time that it takes to fill them with marble; so big
// images ask for huge pages, and none is set to values that are overwritten at once.
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace burl {

/// Memory aligned to at least 64 bytes, its contents undefined. Throws std::bad_alloc.
void* allocate_pixels(std::size_t bytes);
void free_pixels(void* pixels) noexcept;

/// For containers: leaves elements unset that no value is given for.
template <class T>
struct PixelAllocator {
    using value_type = T;

    PixelAllocator() = default;
    template <class U>
    explicit PixelAllocator(const PixelAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocate_pixels(count * sizeof(T))); }
    void deallocate(T* pixels, std::size_t) noexcept { free_pixels(pixels); }

    template <class U>
    void construct(U*) noexcept {
        static_assert(std::is_trivially_copyable_v<U>);
    }
    template <class U, class... Args>
    void construct(U* at, Args&&... args) {
        std::construct_at(at, std::forward<Args>(args)...);
    }
    bool operator==(const PixelAllocator&) const = default;
};

}  // namespace burl
