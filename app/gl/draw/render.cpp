// Everything is drawn into float32 linear light, tile by tile, and averaged and sRGB-encoded on the
// host, so that the result depends neither on the machine's blending nor on its encoder.
#include "app/gl/draw/render.h"

#include <algorithm>

namespace burl {

namespace {

constexpr int tile_samples = 2048;  // the largest side of the float target: 64 MiB of colour

/// Calls visit(tile) for the tiles of the picture, whose sides are multiples of n samples except at
/// the edges, with a float target for the largest one bound.
template <class Visit>
void for_each_tile(const GladGLContext& gl, const PictureSize& samples, int n, const Visit& visit) {
    const int side = tile_samples / n * n;
    const GlFramebuffer target(gl, std::min(side, samples.width), std::min(side, samples.height));
    for (int y = 0; y < samples.height; y += side)
        for (int x = 0; x < samples.width; x += side)
            visit(SampleTile{x, y, std::min(side, samples.width - x),
                             std::min(side, samples.height - y)});
}

/// Reads the pixels drawn for a tile back from the bound framebuffer.
template <class Pixel>
Image<Pixel> read_tile(const GladGLContext& gl, const SampleTile& tile, GLenum format) {
    auto drawn = Image<Pixel>::unset(std::size_t(tile.width), std::size_t(tile.height));
    gl.ReadPixels(0, 0, tile.width, tile.height, format, GL_FLOAT, drawn.row(0).data());
    check_gl(gl, "reading the picture back");
    return drawn;
}

PictureSize samples_of(const PictureOptions& options) {
    return {options.size.width * options.supersample, options.size.height * options.supersample};
}

}  // namespace

Image<Rgb8> render_scene(GlContext& context, const Scene& scene, const Camera& camera,
                         const PictureOptions& options, std::optional<TextureFilter> filter) {
    context.make_current();
    return render_scene(context, GlScene(context.gl(), scene, filter), camera, options);
}

Image<Rgb8> render_scene(GlContext& context, const GlScene& scene, const Camera& camera,
                         const PictureOptions& options) {
    context.make_current();
    const GladGLContext& gl = context.gl();
    const int n = options.supersample;
    const PictureSize samples = samples_of(options);
    const SrgbEncoder<std::uint8_t> encode;
    Image<Rgb8> picture(std::size_t(options.size.width), std::size_t(options.size.height));
    for_each_tile(gl, samples, n, [&](const SampleTile& tile) {
        scene.draw(camera, samples, tile, options.lit);
        resolve_samples(read_tile<RgbF>(gl, tile, GL_RGB), n, encode, picture,
                        std::size_t(tile.x / n), std::size_t(tile.y / n));
    });
    return picture;
}

ViewTexels view_texels(GlContext& context, const GlScene& scene, const Camera& camera,
                       const PictureOptions& options, int number, const TextureLookup& lookup,
                       const LookupSlack& slack) {
    context.make_current();
    const GladGLContext& gl = context.gl();
    const PictureSize samples = samples_of(options);
    ViewTexels texels(lookup.size);
    for_each_tile(gl, samples, options.supersample, [&](const SampleTile& tile) {
        scene.draw_lookups(camera, samples, tile, number, lookup.size);
        add_lookups(read_tile<LookupSample>(gl, tile, GL_RGBA), lookup, texels, slack);
    });
    return texels;
}

}  // namespace burl
