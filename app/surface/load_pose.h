#pragma once
// What `--pose` names: another file with the faces of the mesh, or a pose of the mesh's own.
#include <string>

#include "atlas/read/pose.h"

namespace burl {

/// Whether it names a file or a sample mesh, by its ending; else a pose of the mesh's own.
bool is_pose_file(const std::string& pose);

/// The pose of the mesh that is read from `mesh`, a file or "sample:NAME", with these options.
/// Throws Error as read_pose and read_own_pose do.
MeshPose load_pose(const std::string& mesh, const std::string& pose,
                   const ReadOptions& options = {});

/// What poses a mesh file has itself; none of a sample, or of one that cannot be read.
std::vector<std::string> poses_of(const std::string& mesh);

}  // namespace burl
