#pragma once
// Writes a made mesh in each format Burl reads, by hand and by the format's book, so that the
// readers are tested against files that no library of ours has written.
#include <string>

#include "assets/make_meshes/model.h"

namespace burl {

/// Each returns the whole file's bytes.
std::string obj_text(const Model& model);
std::string off_text(const Model& model);
std::string ply_text(const Model& model);
std::string ply_bytes(const Model& model, bool big_endian);
std::string stl_text(const Model& model);
std::string stl_bytes(const Model& model);
std::string glb_bytes(const Model& model);

}  // namespace burl
