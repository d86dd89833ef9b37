#include "procedural/maps/slope_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

#include "procedural/fill/pieces.h"
#include "procedural/model/band_limit.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

namespace {

/// The rows of the image that one thread fills.
class SlopeMapRows {
  public:
    SlopeMapRows(const Quadric& quadric, const TexelArea& area, Image<MapTexel>& image)
        : quadric_(quadric), area_(area), image_(image) {}

    void add(const SolidAtlas& solid, std::span<const TexelMap> maps, std::size_t y) {
        std::ranges::fill(image_.row(y - area_.y), MapTexel(0));
        for (const Span& span : solid.row(y)) {
            const TexelMap& texel = maps[span.map];
            const WholeSpan whole = solid.whole(span);
            const Vec3d start = texel(whole.x, std::int64_t(y));
            std::size_t done = std::max(span.x, area_.x) - whole.x;
            const std::size_t end = std::min(span.x + span.count, area_.x + area_.width);
            while (whole.x + done < end) {
                const std::size_t count =
                    std::min(end - whole.x - done, batch_capacity - batch_->count);
                add_piece(whole, texel, start, y, done, count, *batch_);
                owners_.push_back(span.map);
                done += count;
                if (batch_->count == batch_capacity) flush();
            }
        }
    }

    void flush() {
        fill_quadric_slopes(quadric_, batch_->pieces, batch_->slopes);
        std::size_t at = 0;
        for (std::size_t i = 0; i < batch_->pieces.size(); ++i) {
            const Piece& piece = batch_->pieces[i];
            MapTexel* texels = &image_(piece.x - area_.x, piece.y - area_.y);
            for (std::size_t j = 0; j < piece.solid.count; ++j, ++at)
                texels[j] = {std::bit_cast<std::uint32_t>(batch_->slopes.u[at]),
                             std::bit_cast<std::uint32_t>(batch_->slopes.v[at]), owners_[i], 0};
        }
        batch_->pieces.clear();
        batch_->count = 0;
        owners_.clear();
    }

  private:
    const Quadric& quadric_;
    const TexelArea& area_;
    Image<MapTexel>& image_;
    std::vector<std::uint32_t> owners_;  ///< map numbers of the pieces
    std::unique_ptr<FieldBatch> batch_ = std::make_unique_for_overwrite<FieldBatch>();
};

/// The side in the group's lattice, by the arithmetic of PieceSides::Map, whose bits it must have.
Vec4f side(const Mat3d& linear, double scale, const Vec3d& step) {
    Vec4f result(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const double along =
            linear[0][axis] * step.x + linear[1][axis] * step.y + linear[2][axis] * step.z;
        if (std::abs(along) < 0.5 * lattice_limit) result[axis] = float(scale * along);
    }
    return result;
}

}  // namespace

Image<MapTexel> fill_slope_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                               const Quadric& quadric, const TexelArea& area, int threads) {
    auto image = Image<MapTexel>::unset(area.width, area.height);
    for_row_ranges(area.height, 8 * batch_capacity, threads, [&](const RowRange& rows) {
        SlopeMapRows filler(quadric, area, image);
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            filler.add(solid, maps, area.y + y);
        filler.flush();
    });
    return image;
}

std::vector<Vec4f> lattice_sides(std::span<const TexelMap> maps,
                                 std::span<const OctaveGroup> groups) {
    std::vector<Vec4f> sides;
    sides.reserve(2 * maps.size() * groups.size());
    for (const TexelMap& map : maps)
        for (const OctaveGroup& group : groups) {
            const double scale = group.scale * stream_unit(group.kind);
            sides.push_back(side(group.lattice_from_solid.linear, scale, map.step_x));
            sides.push_back(side(group.lattice_from_solid.linear, scale, map.step_y));
        }
    return sides;
}

std::vector<float> octave_shares(std::span<const TexelMap> maps,
                                 std::span<const OctaveGroup> groups) {
    std::vector<float> shares;
    for (const TexelMap& map : maps)
        for (const OctaveGroup& group : groups) {
            const Mat3d& linear = group.lattice_from_solid.linear;
            const double longer = longer_squared(linear * map.step_x, linear * map.step_y);
            const double square = longer < lattice_limit ? longer : lattice_limit;
            for (const StreamOctave& octave : group.octaves)
                shares.push_back(
                    float(band_weight(std::ldexp(1.0, 2 * octave.doublings) * square)));
        }
    return shares;
}

std::vector<Vec2d> lone_terms(std::span<const TexelMap> maps, std::span<const Octave> octaves) {
    std::vector<double> means;
    for (const Octave& octave : octaves) means.push_back(octave_mean(octave));
    std::vector<Vec2d> terms;
    for (const TexelMap& map : maps)
        for (std::size_t i = 0; i < octaves.size(); ++i) {
            const Mat3d& linear = octaves[i].lattice_from_solid.linear;
            const double weight = band_weight(linear * map.step_x, linear * map.step_y);
            terms.emplace_back(weight * octaves[i].scale, (1.0 - weight) * means[i]);
        }
    return terms;
}

}  // namespace burl
