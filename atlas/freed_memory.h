#pragma once
// Packing a million triangles leaves hundreds of megabytes of small freed pieces, which the C
// library keeps for itself; what comes next asks for large ones and would not find room in them.

namespace burl {

/// Gives memory that is free within the process back to the system. Takes some milliseconds a
/// gigabyte.
void return_freed_memory();

/// From now on blocks of a megabyte and more go back as soon as they are freed. Otherwise the C
/// library takes to keeping blocks of up to 32 MB once one of that size was freed. For a program's
/// start; costs half a second of system time for a mesh of a million triangles.
void return_large_blocks();

}  // namespace burl
