#pragma once
// The pictures of a recipe's material besides its normals, for a picture of the editor.
#include <memory>
#include <stop_token>

#include "app/editor/jobs/front_buffer.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// The pictures that a recipe needs besides an opaque base colour, and the numbers of the scene's
/// textures that they are.
struct MaterialPlans {
    std::vector<PicturePlan> plans{};
    std::vector<int> numbers{};
};
MaterialPlans material_plans(const Recipe& recipe);

/// Makes level `level` of the pictures that the pipeline's recipe needs besides an opaque base
/// colour, which has paint and is made apart. Null if `stop` was requested first.
std::shared_ptr<const EditMaterial> edit_material(Pipeline& pipeline, std::uint32_t level,
                                                  const EditLevels& make_levels,
                                                  const std::stop_token& stop);

}  // namespace burl
