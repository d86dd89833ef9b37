#include "app/pipeline/stage_records.h"

#include <utility>

namespace burl {

namespace {

StageCost& operator+=(StageCost& sum, const StageCost& cost) {
    sum.triangles += cost.triangles;
    sum.bytes += cost.bytes;
    sum.work += cost.work;
    return sum;
}

}  // namespace

std::uint64_t texels_of(const SolidAtlas& solid) {
    std::uint64_t count = 0;
    for (const Span& span : solid.spans) count += span.count;
    return count;
}

bool StageRecords::keep(Stage stage) {
    if (!std::exchange(unasked_[unsigned(stage)], false)) return false;
    StageRecord& record = records_[unsigned(stage)];
    ++record.kept;
    record.spared += record.last;
    return true;
}

void StageRecords::add(Stage stage, double seconds, const StageCost& cost) {
    unasked_[unsigned(stage)] = false;
    StageRecord& record = records_[unsigned(stage)];
    ++record.runs;
    record.seconds += seconds;
    record.done += cost;
    record.last = cost;
}

void StageRecords::stop(Stage stage, double seconds) {
    StageRecord& record = records_[unsigned(stage)];
    ++record.stopped;
    record.seconds += seconds;
}

}  // namespace burl
