#pragma once
// Memory that goes back to the system. Packing an atlas of a million triangles leaves hundreds of
// megabytes of small free blocks, which the C library keeps for itself; the large blocks of later
// stages do not fit into them.
#include <cstddef>

namespace burl {

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
