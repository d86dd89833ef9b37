// Any polygons as a mesh, and the mesh in an atlas of every kind: soup -> mesh -> atlas -> solid
// points -> measures.
#include <bit>
#include <cmath>
#include <cstring>

#include "atlas/file/text_scanner.h"
#include "atlas/mesh/mesh_builder.h"
#include "tests/fuzz/sound_mesh.h"
#include "tests/fuzz/target.h"

namespace burl::fuzz {
namespace {

/// Takes numbers from the front of bytes; zeros beyond their end.
class Source {
  public:
    explicit Source(const std::string& bytes) : bytes_(bytes) {}

    template <class Value>
    Value take() {
        Value value{};
        const std::size_t count = std::min(sizeof(Value), bytes_.size() - at_);
        std::memcpy(&value, bytes_.data() + at_, count);
        at_ += count;
        return value;
    }
    bool done() const { return at_ >= bytes_.size(); }

  private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

/// The ways in which bytes become coordinates.
enum class Numbers { grid, sixteenths, float32, float64 };

double coordinate(Source& source, Numbers way) {
    double value = 0.0;
    if (way == Numbers::grid) value = double(source.take<std::int8_t>() % 4);
    if (way == Numbers::sixteenths) value = double(source.take<std::int8_t>()) / 16.0;
    if (way == Numbers::float32) value = double(source.take<float>());
    if (way == Numbers::float64) value = source.take<double>();
    return std::abs(value) <= largest_coordinate ? value : 0.0;
}

/// The head of an input: kind, size, options, way of numbers, count of points.
struct Head {
    AtlasOptions options{};
    Numbers way = Numbers::grid;
    std::size_t points = 3;
    bool polygons = false, uvs = false;
};

Head take_head(Source& source) {
    Head head;
    AtlasOptions& options = head.options;
    const auto kind = source.take<std::uint8_t>(), size = source.take<std::uint8_t>(),
               flags = source.take<std::uint8_t>(), points = source.take<std::uint8_t>();
    options.kind = AtlasKind(kind % 7);
    constexpr std::array<std::uint32_t, 8> sizes{1, 2, 4, 8, 16, 32, 64, 128};
    options.size = options.kind == AtlasKind::quad ? sizes[size % 8] : 1u + size % 128;
    head.way = Numbers(flags & 3);
    head.polygons = (flags & 4) != 0;
    options.overscan = (flags & 8) != 0 ? Overscan::nearest : Overscan::bilinear;
    options.overlap = UvOverlap::first;
    options.tries = 1 + (flags >> 4 & 1);
    options.partition = (flags & 32) != 0 ? AtlasPartition::graph : AtlasPartition::rcb;
    options.weight = AtlasWeight(flags >> 6);
    head.uvs = options.kind == AtlasKind::uv || kind > 127;
    head.points = 1u + points % 128;
    return head;
}

PolygonSoup take_soup(Source& source, const Head& head) {
    PolygonSoup soup;
    for (std::size_t i = 0; i < head.points; ++i) {
        const double x = coordinate(source, head.way), y = coordinate(source, head.way);
        soup.points.emplace_back(x, y, coordinate(source, head.way));
        if (head.uvs) soup.uvs.values.emplace_back(std::fmod(x, 1.0), std::fmod(y, 1.0));
    }
    while (!source.done()) {
        const std::size_t size = head.polygons ? 3u + source.take<std::uint8_t>() % 8 : 3;
        for (std::size_t k = 0; k < size; ++k)
            soup.corners.push_back(source.take<std::uint8_t>() % std::uint32_t(head.points));
        soup.end_face(size);
    }
    return soup;
}

void read_soup(const std::string& bytes) {
    Source source(bytes);
    const Head head = take_head(source);
    const Mesh mesh = build_mesh(take_soup(source, head), "soup");
    check_mesh(mesh);
    const Connectivity connectivity = build_connectivity(mesh);
    check_atlas(mesh, connectivity, build_atlas(mesh, connectivity, head.options));
}

}  // namespace

std::vector<Target> soup_targets() {
    return {{"soup", read_soup, Form::binary, {}, {}, 2048}};
}

}  // namespace burl::fuzz
