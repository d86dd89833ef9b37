#include "app/editor/jobs/material.h"

#include <utility>

#include "app/gl/draw/view_material.h"
#include "app/pipeline/material.h"

namespace burl {

std::shared_ptr<const EditMaterial> edit_material(Pipeline& pipeline, std::uint32_t level,
                                                  const EditLevels& make_levels,
                                                  const std::stop_token& stop) {
    const Recipe& recipe = pipeline.recipe();
    auto material = std::make_shared<EditMaterial>();
    material->numbers = scene_material(recipe);
    std::vector<PicturePlan> plans;
    std::vector<int> numbers;
    std::vector<bool> is_color;
    const auto add = [&](int number, const PicturePlan& plan) {
        numbers.push_back(number);
        is_color.push_back(plan.is_color);
        plans.push_back(plan);
    };
    if (is_transparent(recipe)) add(material->numbers.texture, base_color_plan(recipe));
    for (const MaterialPicture& picture : material_pictures(recipe, Packing::gltf))
        add(texture_number(material->numbers, picture), picture.plan);
    if (plans.empty()) return material;
    std::vector<Image<Rgba8>> images = pipeline.pictures<Rgba8>(plans, level, stop);
    if (images.empty()) return nullptr;
    for (std::size_t i = 0; i < images.size(); ++i)
        material->pictures[numbers[i]] = make_levels(std::move(images[i]), is_color[i]);
    return material;
}

}  // namespace burl
