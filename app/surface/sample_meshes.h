#pragma once
// The meshes the program brings with it, named like a file: "sample:teapot". They are the same
// OBJ files a build leaves in its folder of sample meshes.
#include <string>
#include <vector>

#include "atlas/file/file_buffer.h"
#include "atlas/read/read_mesh.h"

namespace burl {

/// Whether a mesh argument names a sample; a file of such a name is reached as "./sample:...".
bool is_sample_mesh(const std::string& argument);

/// Its file. Throws Error(usage), with the names there are, when it is none of them.
FileBuffer sample_file(const std::string& argument);

/// The mesh "sample:NAME". Throws Error(usage), with the names there are, when it is none of them.
Mesh sample_mesh(const std::string& argument, const ReadOptions& options = {});

/// Without "sample:", in alphabetical order.
std::vector<std::string> sample_mesh_names();

}  // namespace burl
