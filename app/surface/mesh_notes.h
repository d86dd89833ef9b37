#pragma once
// What reading a mesh had to repair or leave out, as sentences for people.
#include <string>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Without the file's name; none where there is nothing to say.
std::vector<std::string> sentences_of(const MeshNotes& notes);

}  // namespace burl
