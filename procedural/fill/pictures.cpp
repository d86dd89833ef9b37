#include "procedural/fill/pictures.h"

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>

#include "procedural/color/pixel_encoder.h"
#include "procedural/fill/graph_points.h"
#include "procedural/fill/pieces.h"
#include "procedural/graph/evaluator.h"

namespace burl {

namespace {

/// A batch's numbers of one component.
struct alignas(64) ComponentArray {
    double values[value_batch + batch_padding];
};

void multiply_by(const double* plane, std::size_t count, double* values) {
    for (std::size_t j = 0; j < count; ++j) values[j] *= plane[j];
}

/// Multiplies by the plane's numbers within 0 to 1.
void multiply_by_share(const double* plane, std::size_t count, double* values) {
    for (std::size_t j = 0; j < count; ++j) values[j] *= std::min(std::max(plane[j], 0.0), 1.0);
}

void clamp_to_shares(std::size_t count, double* values) {
    for (std::size_t j = 0; j < count; ++j) values[j] = std::min(std::max(values[j], 0.0), 1.0);
}

/// Divides by alpha where there is any.
void divide_by(const double* alpha, std::size_t count, double* values) {
    for (std::size_t j = 0; j < count; ++j)
        if (alpha[j] > 0.0) values[j] /= alpha[j];
}

/// The codes of components' numbers: sRGB for colours, linear for all others.
template <class Code>
class ComponentEncoder {
  public:
    void colors(const double* values, std::size_t count, Code* codes) const {
        if constexpr (sizeof(Code) == 1)
            encode_(values, count, codes);
        else
            for (std::size_t j = 0; j < count; ++j) codes[j] = encode_(values[j]);
    }
    static void numbers(const double* values, std::size_t count, Code* codes) {
        for (std::size_t j = 0; j < count; ++j) codes[j] = linear_code<Code>(values[j]);
    }

  private:
    std::conditional_t<sizeof(Code) == 1, SrgbStreamEncoder, SrgbEncoder<Code>> encode_;
};

template <>
class ComponentEncoder<float> {
  public:
    static void colors(const double* values, std::size_t count, float* codes) {
        std::copy_n(values, count, codes);
    }
    static void numbers(const double* values, std::size_t count, float* codes) {
        std::copy_n(values, count, codes);
    }
};

/// Stores batches of planes in bands of pictures that begin at a row.
template <class Code>
class PictureStore {
  public:
    using Pixel = Rgba<Code>;

    /// All must outlive this object.
    PictureStore(const std::vector<PicturePlan>& plans, const ComponentEncoder<Code>& encode,
                 std::vector<Image<Pixel>>& pictures, std::size_t first)
        : plans_(plans), encode_(encode), pictures_(pictures), first_(first) {}

    void operator()(PlaneArrays planes, std::size_t count, std::span<const Piece> pieces) {
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            encode(plans_[i], planes, count);
            const Pixel* from = pixels_;
            for (const Piece& piece : pieces) {
                std::copy_n(from, piece.solid.count, &pictures_[i](piece.x, piece.y - first_));
                from += piece.solid.count;
            }
        }
    }

    /// Encodes the pixels of a picture; they are valid until the next call.
    const Pixel* encode(const PicturePlan& plan, PlaneArrays planes, std::size_t count) {
        for (std::size_t c = 0; c < 4; ++c) {
            const bool color = plan.is_color && c < 3;
            find(plan.components[c], planes, count);
            if (color && std::is_same_v<Code, float>)
                multiply_by_opacity(plan.components[3], planes, count);
            else if (color && plan.alpha)
                divide_by(planes[*plan.alpha], count, numbers_.values);
            if (!color) clamp_to_shares(count, numbers_.values);
            if (color)
                encode_.colors(numbers_.values, count, codes_[c]);
            else
                encode_.numbers(numbers_.values, count, codes_[c]);
        }
        for (std::size_t j = 0; j < count; ++j)
            pixels_[j] = {codes_[0][j], codes_[1][j], codes_[2][j], codes_[3][j]};
        return pixels_;
    }

  private:
    void find(const PictureComponent& component, PlaneArrays planes, std::size_t count) {
        std::fill_n(numbers_.values, count, component.factor);
        if (component.plane) multiply_by(planes[*component.plane], count, numbers_.values);
        if (component.times) multiply_by_share(planes[*component.times], count, numbers_.values);
        if (component.offset != 0.0)
            for (std::size_t j = 0; j < count; ++j) numbers_.values[j] += component.offset;
    }

    /// Multiplies by what alpha has besides that of the colour.
    void multiply_by_opacity(const PictureComponent& alpha, PlaneArrays planes, std::size_t count) {
        if (alpha.factor != 1.0)
            for (std::size_t j = 0; j < count; ++j) numbers_.values[j] *= alpha.factor;
        if (alpha.times) multiply_by_share(planes[*alpha.times], count, numbers_.values);
    }

    const std::vector<PicturePlan>& plans_;
    const ComponentEncoder<Code>& encode_;
    std::vector<Image<Pixel>>& pictures_;
    std::size_t first_;
    ComponentArray numbers_;
    alignas(64) Code codes_[4][value_batch + batch_padding];
    Pixel pixels_[value_batch];
};

/// The batch of texels of one thread, evaluated with their footprints.
template <class Store>
class FootprintQueue {
  public:
    FootprintQueue(const GraphEvaluator& evaluate, std::size_t planes, const Filter& filter,
                   const MaskReader& masks, Store store)
        : evaluate_(evaluate),
          masks_(masks),
          kind_(filter.kind),
          pattern_(kind_ == FilterKind::supersample ? filter.samples : 1),
          store_(std::move(store)),
          scratch_(evaluate.make_scratch()),
          values_(planes),
          sums_(planes) {
        for (auto& array : values_) into_.push_back(array.values);
        for (auto& array : sums_) from_.push_back(array.values);
    }

    void add(const Piece& texel, const Footprint& steps) {
        pieces_.push_back(texel);
        steps_.push_back(steps);
        if (pieces_.size() == batch) flush();
    }

    /// Evaluates the batch and stores its texels.
    void flush() {
        if (pieces_.empty()) return;
        const std::size_t count = pieces_.size();
        weights_.assign(count, 0.0);
        for (auto& sum : sums_) std::fill_n(sum.values, count, 0.0);
        for (int i = 0; i < pattern_.samples(); ++i) add_sample(i);
        for (auto& sum : sums_)
            for (std::size_t j = 0; j < count; ++j) sum.values[j] /= weights_[j];
        store_(from_, count, pieces_);
        pieces_.clear();
        steps_.clear();
    }

  private:
    static constexpr std::size_t batch = std::min(value_batch, graph_batch_size);

    void add_sample(int sample) {
        const bool samples = kind_ == FilterKind::supersample;
        points_.clear();
        sample_weights_.clear();
        clear_masks(scratch_.masks);
        for (std::size_t j = 0; j < pieces_.size(); ++j) {
            const Piece& texel = pieces_[j];
            std::pair<float, float> offset{0.0f, 0.0f};
            if (samples) offset = pattern_(sample, std::uint32_t(texel.x), std::uint32_t(texel.y));
            const double u = double(offset.first), v = double(offset.second);
            points_.push_back(texel.solid.start + (texel.solid.first + u) * texel.solid.step +
                              v * texel.down);
            masks_.append(texel.x, texel.y, u * texel.solid.step + v * texel.down, scratch_.masks);
            sample_weights_.push_back(samples ? gaussian_weight(u, v) : 1.0);
        }
        const bool footprints = !samples && kind_ != FilterKind::none;
        evaluate_.planes(
            points_, footprints ? std::span<const Footprint>(steps_) : std::span<const Footprint>(),
            scratch_, into_);
        for (std::size_t j = 0; j < pieces_.size(); ++j) {
            for (std::size_t p = 0; p < sums_.size(); ++p)
                sums_[p].values[j] += sample_weights_[j] * values_[p].values[j];
            weights_[j] += sample_weights_[j];
        }
    }

    const GraphEvaluator& evaluate_;
    const MaskReader& masks_;
    FilterKind kind_;
    SamplePattern pattern_;
    Store store_;
    GraphEvaluator::Scratch scratch_;
    std::vector<ComponentArray> values_, sums_;
    std::vector<double*> into_;
    std::vector<const double*> from_;
    std::vector<Piece> pieces_;
    std::vector<Footprint> steps_;
    std::vector<Vec3d> points_;
    std::vector<double> weights_, sample_weights_;
};

template <class Store>
void fill_footprints(const SolidAtlas& solid, const Affine3& map, const GraphEvaluator& evaluate,
                     std::size_t planes, const Filter& filter, int threads, const Economy& economy,
                     const RowWindow& window, const MaskImages& masks, const Store& store) {
    const MaskReader reader(masks, map);
    const auto fill_rows = [&](const RowRange& range) {
        const auto queue =
            std::make_unique<FootprintQueue<Store>>(evaluate, planes, filter, reader, store);
        for (std::size_t y = window.first + range.begin(); y != window.first + range.end(); ++y) {
            for (const Span& span : solid.row(y)) {
                const TexelMap& texel = solid.maps[span.map];
                const Footprint steps{map.linear * texel.step_x, map.linear * texel.step_y};
                for (std::size_t x = span.x; x < span.x + span.count; ++x)
                    queue->add(
                        {x, y,
                         LatticeLine{map(texel(std::int64_t(x), std::int64_t(y))), steps.u, 0.0, 1},
                         steps.v, 1.0},
                        steps);
            }
            economy.count(1, texels_of(solid.row(y)));
        }
        queue->flush();
    };
    for_window_ranges(solid.size, window.count(), 16 * graph_batch_size, threads, fill_rows,
                      economy.stop);
}

}  // namespace

template <class Pixel>
std::vector<Image<Pixel>> synthesize_pictures(const SolidAtlas& solid, const TextureGraph& graph,
                                              const std::vector<PicturePlan>& plans,
                                              const Affine3& map, const Filter& filter, int threads,
                                              PrecisionKind precision, const Economy& economy,
                                              const MaskImages& masks, const RowWindow& rows) {
    check_masks(graph, GraphOutput::planes, masks, solid.size);
    using Code = decltype(Pixel::r);
    const ComponentEncoder<Code> encode{};
    const GraphValues values(graph, &economy.skips, GraphOutput::planes);
    GraphValues::Scratch scratch = values.make_scratch();
    values.program().run(1, scratch);  // at the origin
    std::vector<const double*> origin;
    for (const Register r : values.results()) origin.push_back(scratch[r]);
    const RowWindow window = rows.of(solid.size);
    std::vector<Image<Pixel>> pictures;
    const PictureStore<Code> store(plans, encode, pictures, window.first);
    for (const PicturePlan& plan : plans)
        pictures.emplace_back(solid.size, window.count(),
                              *PictureStore<Code>(store).encode(plan, origin, 1));
    const bool samples = filter.kind == FilterKind::none || filter.kind == FilterKind::supersample;
    if (samples && precision == PrecisionKind::float32) {
        fill_points(solid, map, values, filter, threads, economy, window, masks, store);
        return pictures;
    }
    const GraphEvaluator evaluate(graph, filter, precision, GraphOutput::planes);
    fill_footprints(solid, map, evaluate, origin.size(), filter, threads, economy, window, masks,
                    store);
    if (economy.work) *economy.work += work_of(solid, window, values.program(), filter);
    return pictures;
}

template std::vector<Image<Rgba8>> synthesize_pictures(const SolidAtlas&, const TextureGraph&,
                                                       const std::vector<PicturePlan>&,
                                                       const Affine3&, const Filter&, int,
                                                       PrecisionKind, const Economy&,
                                                       const MaskImages&, const RowWindow&);
template std::vector<Image<Rgba16>> synthesize_pictures(const SolidAtlas&, const TextureGraph&,
                                                        const std::vector<PicturePlan>&,
                                                        const Affine3&, const Filter&, int,
                                                        PrecisionKind, const Economy&,
                                                        const MaskImages&, const RowWindow&);
template std::vector<Image<RgbaF>> synthesize_pictures(const SolidAtlas&, const TextureGraph&,
                                                       const std::vector<PicturePlan>&,
                                                       const Affine3&, const Filter&, int,
                                                       PrecisionKind, const Economy&,
                                                       const MaskImages&, const RowWindow&);

}  // namespace burl
