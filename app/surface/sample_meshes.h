#pragma once
// Meshes and poses as arguments name them. Meshes embedded in the program are named like files:
// "sample:teapot"; they equal the OBJ files in the build's folder of sample meshes. A pose is
// another file with the mesh's faces, or a pose in the mesh's own file.
#include <string>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/read/pose.h"
#include "atlas/read/read_mesh.h"

namespace burl {

/// Whether the argument names a sample mesh; a file of such a name is reached as "./sample:...".
bool is_sample_mesh(const std::string& argument);

/// The mesh "sample:NAME". Throws Error(usage) listing the samples where there is none of that
/// name.
Mesh sample_mesh(const std::string& argument, const ReadOptions& options = {});

/// Throws Error as check_mesh_file() does for a file, and usage for a sample that there is not.
void check_mesh_argument(const std::string& argument);

/// The bytes of a mesh file, or of the OBJ of a sample. Throws Error as read_file and sample_mesh
/// do.
FileBuffer mesh_bytes(const std::string& path, NamedFiles named = NamedFiles::below);

/// The names of the sample meshes, without "sample:", in alphabetical order.
std::vector<std::string> sample_mesh_names();

/// Whether the argument names a file (by its extension) or a sample mesh; otherwise it names a pose
/// in the mesh's own file.
bool is_pose_file(const std::string& pose);

/// The pose of the mesh that is read from `mesh`, a file or "sample:NAME", with these options.
/// Throws Error as read_pose and read_own_pose do.
MeshPose load_pose(const std::string& mesh, const std::string& pose,
                   const ReadOptions& options = {});

/// The names of the poses in a mesh file; empty for samples and for files that cannot be read.
std::vector<std::string> poses_of(const std::string& mesh);

/// Sentences for people about what reading a mesh repaired or left out, one per kind of note,
/// without the file's name; empty where there is nothing to report.
std::vector<std::string> sentences_of(const MeshNotes& notes);

}  // namespace burl
