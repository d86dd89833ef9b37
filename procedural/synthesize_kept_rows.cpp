#include "procedural/synthesize_kept_rows.h"

namespace burl {

KeptRows::KeptRows(const SolidAtlas& solid) {
    std::size_t kept = 0;
    for (std::size_t y = 0; y < solid.size; ++y) {
        begin_.push_back(kept);
        run_begin_.push_back(runs_.size());
        for (const Span& span : solid.row(y)) {
            const bool goes_on =
                runs_.size() > run_begin_.back() && runs_.back().x + runs_.back().count == span.x;
            if (!goes_on) runs_.push_back({span.x, 0});
            runs_.back().count += span.count;
            kept += span.count;
            texels_ += span.count;
        }
        kept = (kept + batch_padding - 1) / batch_padding * batch_padding;
    }
    begin_.push_back(kept);
    run_begin_.push_back(runs_.size());
}

}  // namespace burl
