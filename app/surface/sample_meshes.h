#pragma once
// The meshes embedded in the program, which are named like files: "sample:teapot". They equal the
// OBJ files in the build's folder of sample meshes.
#include <string>
#include <vector>

#include "atlas/file/file_buffer.h"
#include "atlas/read/read_mesh.h"

namespace burl {

/// Whether the argument names a sample mesh; a file of such a name is reached as "./sample:...".
bool is_sample_mesh(const std::string& argument);

/// The OBJ file of "sample:NAME". Throws Error(usage) listing the samples where there is none of
/// that name.
FileBuffer sample_file(const std::string& argument);

/// The mesh "sample:NAME". Throws Error(usage) listing the samples where there is none of that
/// name.
Mesh sample_mesh(const std::string& argument, const ReadOptions& options = {});

/// The names of the sample meshes, without "sample:", in alphabetical order.
std::vector<std::string> sample_mesh_names();

}  // namespace burl
