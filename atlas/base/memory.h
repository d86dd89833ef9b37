#pragma once
// Memory of images, and memory that goes back to the system.
//
// A texture of 4096 x 4096 pixels of 3 bytes spans twelve thousand pages of 4 KiB, and clearing
// them one by one takes a tenth of the time that filling the texture with marble takes; so images
// of 4 MiB and more ask for huge pages, and no image is cleared that is overwritten at once.
//
// Packing an atlas of a million triangles leaves hundreds of megabytes of small free blocks, which
// the C library keeps for itself; the large blocks of later stages do not fit into them.
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace burl {

/// Memory aligned to at least 64 bytes, its contents undefined; aligned to 2 MiB from 4 MiB on.
/// Throws std::bad_alloc.
void* allocate_pixels(std::size_t bytes);
/// Frees memory of allocate_pixels(); null is allowed.
void free_pixels(void* pixels) noexcept;

/// Allocator for containers of pixels: elements for which no value is given stay uninitialised.
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

/// Returns the free memory of the process's heap to the system; does nothing where the C library is
/// not GNU's. Takes some milliseconds per gigabyte.
void return_freed_memory();

/// Number of triangles above which a mesh leaves enough free memory to be worth returning.
inline constexpr std::size_t many_triangles = 100000;

/// Makes the C library return blocks of 1 MiB and more as soon as they are freed, for the rest of
/// the process, if `triangles` exceeds many_triangles. By default it keeps blocks of up to 32 MB
/// once one of that size was freed, which suits textures that are filled again and again: fresh
/// pages cost a quarter of the time of a texture of 1024 x 1024.
void return_large_blocks(std::size_t triangles);

}  // namespace burl
