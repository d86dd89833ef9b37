#include "procedural/fill/sparse.h"

#include <algorithm>
#include <memory>

#include "procedural/fill/pieces.h"

namespace burl {

namespace {

/// The span that shows a texel; null where none does.
const Span* span_at(const SolidAtlas& solid, const glm::uvec2& texel) {
    const auto spans = solid.row(texel.y);
    const auto after = std::ranges::upper_bound(spans, texel.x, {}, &Span::x);
    if (after == spans.begin()) return nullptr;
    const Span& span = *std::prev(after);
    return texel.x < span.x + span.count ? &span : nullptr;
}

}  // namespace

void synthesize_sparse(const SolidAtlas& solid, std::span<const TexelMap> maps,
                       const Texture& texture, const ColorTable8& table,
                       std::span<const glm::uvec2> texels, Image<Rgb8>& image) {
    const FieldSampler sampler(texture, false, Kernel::direct);
    const auto batch = std::make_unique_for_overwrite<FieldBatch>();
    const auto flush = [&] {
        sampler.values(*batch);
        for (std::size_t j = 0; j < batch->count; ++j)
            image(batch->pieces[j].x, batch->pieces[j].y) = table(batch->field[j]);
        batch->pieces.clear();
        batch->count = 0;
    };
    for (const glm::uvec2& texel : texels) {
        const Span* const span = span_at(solid, texel);
        if (span == nullptr) {
            image(texel.x, texel.y) = table(0.0);
            continue;
        }
        const TexelMap& map = maps[span->map];
        const WholeSpan whole = solid.whole(*span);
        add_piece(whole, map, map(whole.x, std::int64_t(texel.y)), texel.y, texel.x - whole.x, 1,
                  *batch);
        if (batch->count == batch_capacity) flush();
    }
    if (batch->count > 0) flush();
}

}  // namespace burl
