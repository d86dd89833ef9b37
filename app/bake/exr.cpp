#include "app/bake/exr.h"

#include <chrono>
#include <utility>

#include "app/base/atomic_file.h"
#include "app/image/image_io.h"

namespace burl {

namespace {

using Clock = std::chrono::steady_clock;

/// Seconds that the stages of synthesis, paint and levels have taken so far.
double stage_seconds(const Pipeline& pipeline) {
    double sum = 0.0;
    for (const Stage stage : {Stage::synthesis, Stage::paint, Stage::levels})
        sum += pipeline.records()[stage].seconds;
    return sum;
}

void write_normals(AtomicFile& file, const NormalMap& normals) {
    std::visit([&](const auto& image) { encode_png(image, sink_of(file), PngContent::data); },
               normals.image);
}

TakeRows rows_to(const RowSink& sink) {
    return [&sink](std::size_t, const Image<RgbF>& rows) { sink(rows); };
}

AtomicFile write_texture(Pipeline& pipeline, const std::string& path, const LevelsAsked& levels) {
    const std::size_t size = pipeline.recipe().atlas.size;
    if (levels.count == 0)
        return write_exr_rows(path, size, size, [&](const RowSink& sink) {
            pipeline.synthesize_in_bands(rows_to(sink));
        });
    return write_exr_levels(path, size, size, [&](const RowSink& sink) {
        return pipeline.levels_in_bands(levels.count, levels.rule, rows_to(sink));
    });
}

}  // namespace

BandsWritten write_exr_in_bands(Pipeline& pipeline, const std::string& path,
                                const LevelsAsked& asked, const NormalMap* normals) {
    LevelsAsked levels = asked;
    if (asked.count > 0) levels.count = levels_there_are(pipeline, asked, ImageKind::rgb_float);
    pipeline.solid();
    const auto start = Clock::now();
    const double before = stage_seconds(pipeline);
    std::vector<AtomicFile> files;
    if (normals) write_normals(files.emplace_back(normal_map_path(path)), *normals);
    files.push_back(write_texture(pipeline, path, levels));
    const std::chrono::duration<double> all = Clock::now() - start;
    return {levels.count, std::move(files), all.count() - (stage_seconds(pipeline) - before)};
}

}  // namespace burl
