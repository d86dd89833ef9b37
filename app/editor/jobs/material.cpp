#include "app/editor/jobs/material.h"

#include <utility>

#include "app/gl/draw/view_material.h"
#include "app/pipeline/material.h"

namespace burl {

MaterialPlans material_plans(const Recipe& recipe) {
    const SceneMaterial numbers = scene_material(recipe);
    MaterialPlans made;
    const auto add = [&](int number, const PicturePlan& plan) {
        made.numbers.push_back(number);
        made.plans.push_back(plan);
    };
    if (is_transparent(recipe)) add(numbers.texture, base_color_plan(recipe));
    for (const MaterialPicture& picture : material_pictures(recipe, Packing::gltf))
        add(texture_number(numbers, picture), picture.plan);
    return made;
}

std::shared_ptr<const EditMaterial> edit_material(Pipeline& pipeline, std::uint32_t level,
                                                  const EditLevels& make_levels,
                                                  const std::stop_token& stop) {
    auto material = std::make_shared<EditMaterial>();
    material->numbers = scene_material(pipeline.recipe());
    const auto [plans, numbers] = material_plans(pipeline.recipe());
    if (plans.empty()) return material;
    std::vector<Image<Rgba8>> images = pipeline.pictures<Rgba8>(plans, level, stop);
    if (images.empty()) return nullptr;
    for (std::size_t i = 0; i < images.size(); ++i)
        material->pictures[numbers[i]] = make_levels(std::move(images[i]), plans[i].is_color);
    return material;
}

}  // namespace burl
