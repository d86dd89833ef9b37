// Everything is drawn into float32 linear light, tile by tile, and averaged, developed and
// sRGB-encoded on the host, so that the result does not depend on the machine's encoder.
#include "app/gl/draw/render.h"

#include <algorithm>

#include "app/image/image_io.h"

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

constexpr int most_layers = 256;  // beyond which nothing is seen but specks

/// Adds a layer below the layers in `sum`, whose alpha is the share that they hide; returns whether
/// the layer has anything.
bool add_layer(const Image<RgbaF>& layer, Image<RgbaF>& sum) {
    bool any = false;
    for (std::size_t y = 0; y < sum.height(); ++y)
        for (std::size_t x = 0; x < sum.width(); ++x) {
            const RgbaF& c = layer(x, y);
            if (!(c.a > 0.0f)) continue;
            any = true;
            RgbaF& s = sum(x, y);
            const float shows = 1.0f - s.a;
            s = {s.r + shows * c.r, s.g + shows * c.g, s.b + shows * c.b, s.a + shows * c.a};
        }
    return any;
}

/// Puts the layers over a tile of what is opaque, which has been drawn into the bound framebuffer.
void blend_layers(const GladGLContext& gl, const GlScene& scene, const Camera& camera,
                  const PictureSize& samples, const SampleTile& tile, const GlShading& shading,
                  Image<RgbaF>& drawn) {
    GlLayerDepths depths(gl, tile.width, tile.height);
    Image<RgbaF> sum(drawn.width(), drawn.height());
    for (int layer = 0; layer < most_layers; ++layer) {
        scene.draw_layer(camera, samples, tile, shading, depths);
        if (!add_layer(read_tile<RgbaF>(gl, tile, GL_RGBA), sum)) break;
        depths.take_layer();
    }
    for (std::size_t y = 0; y < sum.height(); ++y)
        for (std::size_t x = 0; x < sum.width(); ++x) {
            const RgbaF& s = sum(x, y);
            RgbaF& below = drawn(x, y);
            const float shows = 1.0f - s.a;
            below = {s.r + shows * below.r, s.g + shows * below.g, s.b + shows * below.b,
                     s.a + shows * below.a};
        }
}

PictureSize samples_of(const PictureOptions& options) {
    return {options.size.width * options.supersample, options.size.height * options.supersample};
}

}  // namespace

Image<Rgb8> render_scene(GlContext& context, const Scene& scene, const Camera& camera,
                         const PictureOptions& options, std::optional<TextureFilter> filter) {
    context.make_current();
    const GlSurroundings around(context.gl(), scene, options);
    return colors_and_alpha(render_picture(context, GlScene(context.gl(), scene, filter), around,
                                           camera, options))
        .first;
}

Image<Rgba8> render_picture(GlContext& context, const GlScene& scene, const GlSurroundings& around,
                            const Camera& camera, const PictureOptions& options) {
    context.make_current();
    const GladGLContext& gl = context.gl();
    const int n = options.supersample;
    const PictureSize samples = samples_of(options);
    const SrgbEncoder<std::uint8_t> encode;
    Image<Rgba8> picture(std::size_t(options.size.width), std::size_t(options.size.height));
    for_each_tile(gl, samples, n, [&](const SampleTile& tile) {
        around.draw(camera, samples, tile);
        scene.draw(camera, samples, tile, around.shading());
        auto drawn = read_tile<RgbaF>(gl, tile, GL_RGBA);
        if (scene.has_layers())
            blend_layers(gl, scene, camera, samples, tile, around.shading(), drawn);
        resolve_samples(drawn, options, encode, picture, std::size_t(tile.x / n),
                        std::size_t(tile.y / n));
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
