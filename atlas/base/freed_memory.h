#pragma once
// Packing a million triangles leaves hundreds of megabytes of small freed pieces, which the C
// library keeps for itself; what comes next asks for large ones and would not find room in them.
#include <cstddef>

namespace burl {

/// Gives memory that is free within the process back to the system. Takes some milliseconds a
/// gigabyte.
void return_freed_memory();

/// Meshes of more triangles than this leave enough to be worth giving back.
inline constexpr std::size_t many_triangles = 100000;

/// For what will hold so many triangles: from now on blocks of a megabyte and more go back as soon
/// as they are freed, if they are many. Otherwise the C library takes to keeping blocks of up to 32
/// MB once one of that size was freed, which suits textures made again and again: fresh pages cost
/// a quarter of the time of a texture of 1024 x 1024.
void return_large_blocks(std::size_t triangles);

}  // namespace burl
