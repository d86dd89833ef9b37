#pragma once
// The pictures of a recipe's material a band of rows at a time, for callers that make those of
// several recipes side by side.
#include <utility>
#include <vector>

#include "app/pipeline/stages.h"
#include "procedural/batch/row_window.h"
#include "procedural/fill/pictures.h"

namespace burl {

/// Makes bands of the pictures of TextureStage::run_pictures(). Pixel is Rgba8, Rgba16 or RgbaF.
template <class Pixel>
class PictureBands {
  public:
    /// `masks` are those that the material reads.
    PictureBands(const Recipe& recipe, MaskImages masks, std::vector<PicturePlan> plans)
        : recipe_(recipe), masks_(std::move(masks)), plans_(std::move(plans)) {}

    const Recipe& recipe() const { return recipe_; }
    /// The rows of the pictures, an image per plan; not whole where the context is stopped. `solid`
    /// is the same in every call.
    std::vector<Image<Pixel>> rows(const StageContext& context, const SolidAtlas& solid,
                                   const RowWindow& window);
    /// Adds all rows so far to the records as one run.
    void record(StageContext& context) const {
        context.records.add(Stage::synthesis, seconds_, cost_);
    }

  private:
    Recipe recipe_;
    MaskImages masks_;
    std::vector<PicturePlan> plans_;
    StageCost cost_{};
    double seconds_ = 0.0;
};

/// The atlas with the maps alone that its spans show, for synthesis: several parts of an atlas
/// (cut_to() in atlas/solid/texel_set.h) then take as much memory as the whole.
SolidAtlas with_own_maps(SolidAtlas solid);

}  // namespace burl
