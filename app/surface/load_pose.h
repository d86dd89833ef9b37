#pragma once
// The argument of `--pose`: another file with the mesh's faces, or a pose in the mesh's own file.
#include <string>

#include "atlas/read/pose.h"

namespace burl {

/// Whether the argument names a file (by its extension) or a sample mesh; otherwise it names a pose
/// in the mesh's own file.
bool is_pose_file(const std::string& pose);

/// The pose of the mesh that is read from `mesh`, a file or "sample:NAME", with these options.
/// Throws Error as read_pose and read_own_pose do.
MeshPose load_pose(const std::string& mesh, const std::string& pose,
                   const ReadOptions& options = {});

/// The names of the poses in a mesh file; empty for samples and for files that cannot be read.
std::vector<std::string> poses_of(const std::string& mesh);

}  // namespace burl
