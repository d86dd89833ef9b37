#include "app/surface/load_pose.h"

#include <algorithm>

#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

namespace {

FileBuffer bytes_of(const std::string& path) {
    return is_sample_mesh(path) ? sample_file(path) : read_file(path);
}

}  // namespace

bool is_pose_file(const std::string& pose) {
    const std::vector<std::string> extensions = mesh_extensions();
    return is_sample_mesh(pose) ||
           std::ranges::find(extensions, lower_extension(pose)) != extensions.end();
}

MeshPose load_pose(const std::string& mesh, const std::string& pose, const ReadOptions& options) {
    return is_pose_file(pose) ? read_pose(bytes_of(mesh), bytes_of(pose), options)
                              : read_own_pose(bytes_of(mesh), pose, options);
}

std::vector<std::string> poses_of(const std::string& mesh) {
    if (is_sample_mesh(mesh)) return {};
    try {
        return pose_names(read_file(mesh));
    } catch (const Error&) {
        return {};
    }
}

}  // namespace burl
