#pragma once
// An output written and committed in one step.
#include "app/export/export.h"

namespace burl {

inline void export_scene(const std::string& path, const Mesh& mesh, const Atlas& atlas,
                         const BakedImage& image, const ExportOptions& options = {}) {
    std::vector<AtomicFile> files = scene_files(path, mesh, atlas, image, options);
    commit_together(files);
}

}  // namespace burl
