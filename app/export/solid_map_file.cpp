#include "app/export/solid_map_file.h"

#include <exception>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfVecAttribute.h>

#include "app/base/atomic_file.h"
#include "app/image/exr_stream.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr const char* axes[] = {"X", "Y", "Z", "A"};
constexpr const char* owner = "owner";

Imf::Header header_of(const SolidMap& map, const Vec3d& base) {
    Imf::Header header(int(map.owners.width()), int(map.owners.height()));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* axis : axes) header.channels().insert(axis, Imf::Channel(Imf::FLOAT));
    header.channels().insert(owner, Imf::Channel(Imf::UINT));
    header.insert("base", Imf::V3dAttribute(Imath::V3d(base.x, base.y, base.z)));
    return header;
}

/// A slice over one component of the pixels, which OpenEXR only reads although it takes char*.
template <class Pixel>
Imf::Slice slice_of(Imf::PixelType type, const Image<Pixel>& image, std::size_t component) {
    auto* base = const_cast<char*>(reinterpret_cast<const char*>(image.pixels().data()));
    return {type, base + 4 * component, sizeof(Pixel), sizeof(Pixel) * image.width()};
}

void encode_into(std::vector<std::uint8_t>& bytes, const SolidMap& map, const Vec3d& base) {
    ExrStream stream(bytes);
    Imf::OutputFile file(stream, header_of(map, base));
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < std::size(axes); ++c)
        frame.insert(axes[c], slice_of(Imf::FLOAT, map.local, c));
    frame.insert(owner, slice_of(Imf::UINT, map.owners, 0));
    file.setFrameBuffer(frame);
    file.writePixels(int(map.owners.height()));
}

}  // namespace

std::vector<std::uint8_t> encode_solid_map(const SolidMap& map, const Vec3d& base) {
    std::vector<std::uint8_t> bytes;
    try {
        encode_into(bytes, map, base);
    } catch (const std::exception& e) {
        throw Error(ExitCode::runtime,
                    fmt::format("the solid map of {} x {} could not be encoded: {}",
                                map.owners.width(), map.owners.height(), e.what()));
    }
    return bytes;
}

WrittenSolidMap write_solid_map(const std::string& path, Pipeline& pipeline, int threads) {
    const SolidAtlas& solid = pipeline.solid();
    const Affine3 map = texture_from_solid(pipeline.recipe());
    const Vec3d base = solid_base(solid, map);
    const SolidMap content =
        fill_solid_map(solid, map, base, {0, 0, solid.size, solid.size}, threads);
    WrittenSolidMap written{base, AtomicFile(path)};
    written.file.write(encode_solid_map(content, base));
    return written;
}

}  // namespace burl
