#include "procedural/field/kept_start.h"

#include <algorithm>
#include <utility>

namespace burl {

FieldStart KeptStart::begin(FieldSum sum, double* values) {
    FieldStart start;
    if (values && last_ && last_->quadric == sum.quadric && last_->constant == sum.constant)
        start.groups =
            std::size_t(std::ranges::mismatch(sum.groups, last_->groups).in1 - sum.groups.begin());
    wanted_.reset();
    if (start.groups > 0) {
        const auto end = sum.groups.begin() + std::ptrdiff_t(start.groups);
        wanted_ = FieldSum{sum.quadric, sum.constant, {sum.groups.begin(), end}};
        start.values = values;
        start.known = known_ == wanted_;
        for (const FieldSum::Group& group : wanted_->groups) start.octaves += group.keys.size();
    }
    if (!start.known) known_.reset();
    last_ = std::move(sum);
    return start;
}

void KeptStart::end(bool complete) {
    if (complete) known_ = std::move(wanted_);
}

}  // namespace burl
