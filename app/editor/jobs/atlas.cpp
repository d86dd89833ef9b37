#include "app/editor/jobs/atlas.h"

#include <algorithm>
#include <bit>

#include <tbb/task_arena.h>

namespace burl {

AtlasOptions atlas_at_once(const AtlasOptions& wanted, std::size_t triangles) {
    AtlasOptions quick = wanted;
    if (wanted.kind != AtlasKind::patch || triangles <= many_faces || wanted.size == 0)
        return quick;
    quick.kind = AtlasKind::quad;
    quick.size = std::bit_floor(wanted.size);
    return quick;
}

bool lay_out_aside(Pipeline& pipeline, const std::stop_token& stop) {
    const int cores = tbb::this_task_arena::max_concurrency();
    tbb::task_arena aside(std::max(1, cores - 1), 1, tbb::task_arena::priority::low);
    return aside.execute([&] {
        if (!pipeline.lay_out(stop)) return false;
        pipeline.solid();
        return !stop.stop_requested();
    });
}

}  // namespace burl
