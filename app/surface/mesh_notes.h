#pragma once
// Sentences for people about what reading a mesh repaired or left out.
#include <string>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// One sentence per kind of note, without the file's name; empty where there is nothing to report.
std::vector<std::string> sentences_of(const MeshNotes& notes);

}  // namespace burl
