#include "app/recipe/parameters.h"

#include <algorithm>
#include <utility>

#include "app/recipe/recipe.h"
#include "app/recipe/schema_check.h"
#include "procedural/model/members.h"

namespace burl {

namespace {

template <class Owner, class Member>
RecipeParameter row(std::string_view path, Member Owner::*member, const NumberRange& range,
                    std::string_view tip, const ParameterLook& look = {},
                    const ParameterUse& use = {}) {
    return {member_row(path, member, range, tip, look), use};
}

std::string only_atlases(AtlasKind wanted, const Recipe& recipe) {
    if (recipe.atlas.kind == wanted) return "";
    return fmt::format(
        "only {0} atlases have it, and this one is {1}; add --atlas {0}, or leave it out",
        to_string(wanted), to_string(recipe.atlas.kind));
}

std::string only_quads(const Recipe& recipe) {
    return only_atlases(AtlasKind::quad, recipe);
}

std::string only_bilinear_quads(const Recipe& recipe) {
    std::string why = only_quads(recipe);
    if (!why.empty() || recipe.atlas.overscan == Overscan::bilinear) return why;
    return "with overscan nearest there is none of it; add --overscan bilinear, or leave it out";
}

std::string only_patches(const Recipe& recipe) {
    return only_atlases(AtlasKind::patch, recipe);
}

std::string only_uvs(const Recipe& recipe) {
    return only_atlases(AtlasKind::uv, recipe);
}

std::string only_supersample(const Recipe& recipe) {
    if (recipe.filter.kind == FilterKind::supersample) return "";
    return "only --filter supersample takes samples; add that, or leave it out";
}

std::string only_fixed(const Recipe& recipe) {
    if (recipe.precision.kind == PrecisionKind::fixed) return "";
    return "only fixed point has these bits; use --precision fixed:I.F, or leave it out";
}

std::string only_masks(const Recipe& recipe) {
    if (recipe.material.alpha == AlphaMode::mask) return "";
    return "only material.alpha mask has a cutoff; set that, or leave it out";
}

std::vector<RecipeParameter> rows_before_texture() {
    return {
        {{{"burl", ParameterType::integer, 1, 1, 1, 1, "", "1", "", "version of this format"}}, {}},
        row("name", &Recipe::name, {}, "what the texture is called"),
        row("about", &Recipe::about, {}, "a sentence about it", {.rare = true}),
        row("group", &Recipe::group, {}, "what kind of material it is, such as wood or stone",
            {.rare = true}),
        row("atlas.kind", &AtlasOptions::kind, {}, "how triangles are packed", {},
            {"-a,--atlas", "Atlas: {}"}),
        row("atlas.size", &AtlasOptions::size, {1, max_atlas_size, 256, "texels"},
            "width and height of the texture; quad: a power of two", {},
            {"-s,--size", "Side N of the N x N texture, in texels; of a uv atlas also WxH"}),
        row("atlas.width", &AtlasOptions::width, {0, max_atlas_size, 256, "texels"},
            "columns of a uv atlas's texture that is higher than wide, at most atlas.size; 0: "
            "atlas.size",
            {.rare = true}, {.idle = only_uvs}),
        row("atlas.height", &AtlasOptions::height, {0, max_atlas_size, 256, "texels"},
            "rows of a uv atlas's texture that is wider than high, at most atlas.size; 0: "
            "atlas.size",
            {.rare = true}, {.idle = only_uvs}),
        row("atlas.overscan", &AtlasOptions::overscan, {},
            "the look-up the texture is prepared for", {.label = "for lookups", .rare = true},
            {"--overscan", "Lookup the atlas is made for: {}"}),
        row("atlas.weight", &AtlasOptions::weight, {},
            "what a pair's share of a quad atlas follows; the other kinds ignore it",
            {.rare = true},
            {"--weight", "What a pair's share of a quad atlas follows: {}", only_quads}),
        row("atlas.partition", &AtlasOptions::partition, {},
            "how a quad atlas finds clusters: by bisecting coordinates, or the graph of "
            "neighbouring pairs",
            {.rare = true},
            {"--partition", "How a quad atlas finds clusters: rcb (coordinates) or graph",
             only_quads}),
        row("atlas.gutter", &AtlasOptions::gutter, {0, 64, 1, "texels"},
            "quad, bilinear: texels round every pair that go on with its triangles; fewer in small "
            "blocks",
            {.rare = true},
            {"--gutter", "Texels that a quad atlas leaves round every pair", only_bilinear_quads}),
        row("atlas.diagonals", &AtlasOptions::diagonals, {},
            "quad, bilinear: whether pairs meet on the diagonal, or lie apart where they would "
            "meet in a kink",
            {.label = "pairs meet", .rare = true},
            {"--diagonals", "Pairs of a quad atlas: shared, or with overscan for more than 8 bits",
             only_bilinear_quads}),
        row("atlas.tries", &AtlasOptions::tries, {1, 6, 1},
            "partitions a patch atlas is chosen from; the other kinds ignore it", {.rare = true},
            {"--tries", "Partitions a patch atlas is chosen from, 1 to 6", only_patches}),
        row("atlas.overlap", &AtlasOptions::overlap, {},
            "texels that several triangles of a uv atlas claim: refused, or the first one's",
            {.rare = true},
            {"--uv-overlap", "Texels that several triangles of a uv atlas claim: {}, one's",
             only_uvs}),
        row("solid.space", &SolidOptions::space, {},
            "unit: the mesh's box centred, longest side 1; object: the file's coordinates"),
        row("solid.scale", &SolidOptions::scale, {1e-6, 1e6, 0.1},
            "solid coordinates are multiplied by it"),
        row("solid.rotate", &SolidOptions::rotate, {-360, 360, 4.5, "degrees"},
            "turns solid coordinates about x, then y, then z, before the scale", {.label = "turn"}),
        row("solid.translate", &SolidOptions::translate, {-1e6, 1e6, 0.05},
            "added to solid coordinates after the scale", {.label = "move"})};
}

std::vector<RecipeParameter> material_rows() {
    return {row("material.opacity", &Material::opacity, {0, 1, 0.05},
                "factor of the base colour's alpha"),
            row("material.metallic", &Material::metallic, {0, 1, 0.05},
                "0: wood, stone, paint; 1: bare metal, whose colour its base colour is"),
            row("material.roughness", &Material::roughness, {0, 1, 0.05}, "0: a mirror; 1: chalk"),
            row("material.occlusion", &Material::occlusion, {0, 1, 0.05},
                "share of the sky that lights the surface"),
            row("material.emissive", &Material::emissive, {}, "sRGB colour of light that it gives"),
            row("material.emissive_strength", &Material::emissive_strength, {0, 1e6, 0.1},
                "factor of emissive"),
            row("material.ior", &Material::ior, {1, 5, 0.01},
                "refractive index: water 1.33, glass 1.5", {.rare = true}),
            row("material.specular", &Material::specular, {0, 1, 0.05},
                "factor of the reflection of what is no metal", {.rare = true}),
            row("material.clearcoat", &Material::clearcoat, {0, 1, 0.05},
                "weight of a layer of varnish"),
            row("material.clearcoat_roughness", &Material::clearcoat_roughness, {0, 1, 0.05},
                "roughness of the varnish"),
            row("material.sheen", &Material::sheen, {}, "sRGB colour of a fabric's sheen",
                {.rare = true}),
            row("material.sheen_roughness", &Material::sheen_roughness, {0, 1, 0.05},
                "roughness of the sheen", {.rare = true}),
            row("material.transmission", &Material::transmission, {0, 1, 0.05},
                "share of light that passes through", {.rare = true}),
            row("material.alpha", &Material::alpha, {},
                "blend: shows what is behind; mask: there or not; opaque: transparent is black"),
            row("material.alpha_cutoff", &Material::alpha_cutoff, {0, 1, 0.05},
                "mask: alpha from which a texel is there", {.rare = true}, {.idle = only_masks})};
}

std::vector<RecipeParameter> control_rows() {
    return {
        row("controls.*.name", &RecipeControl::name, {},
            "what the control is called, unlike any path: --set NAME=VALUE", {.required = true}),
        row("controls.*.about", &RecipeControl::about, {}, "what it changes, in a few words"),
        row("controls.*.range", &RecipeControl::range, {-1e9, 1e9, 0.1},
            "its least and its greatest value; colours have none"),
        row("controls.*.sets.*", &RecipeControl::sets, {},
            "a path that it sets, or another one with a formula of its value x",
            {.required = true})};
}

std::vector<RecipeParameter> rows_after_texture() {
    return {
        row("bump.height", &Bump::height, {-1e6, 1e6, 0.001, "solid units"},
            "rise of the surface where bump.input grows by 1; solid.scale does not change it"),
        row("filter.kind", &Filter::kind, {}, "how a texel's area is averaged"),
        row("filter.samples", &Filter::samples, {1, 1024, 1},
            "supersample: places per texel; squares are spread best", {},
            {.idle = only_supersample}),
        row("filter.octaves", &Filter::band_limit, {.words = "keep|fade"},
            "fade: octaves finer than a texel are left out, the last one in part"),
        row("precision.kind", &Precision::kind, {},
            "arithmetic of the texture; left out: float32 for bakes, float64 for render --direct"),
        row("precision.integer_bits", &FixedFormat::integer_bits, {1, 16, 1, "bits"},
            "fixed: bits before the point, the sign's among them", {}, {.idle = only_fixed}),
        row("precision.fraction_bits", &FixedFormat::fraction_bits, {2, 16, 1, "bits"},
            "fixed: bits after the point", {}, {.idle = only_fixed}),
        row("paint.*.mode", &PaintStroke::mode, {},
            "erase: takes away the paint of the strokes before it"),
        row("paint.*.layer", &PaintStroke::layer, {0, most_paint_layers, 1},
            "0: over the texture; another number: the mask of the nodes paint of that layer"),
        row("paint.*.color", &PaintStroke::color, {}, "sRGB colour"),
        row("paint.*.radius", &PaintStroke::radius, {1e-6, 1e6, 0.005, "solid units"},
            "of the ball that is moved along the points; solid.scale does not change it"),
        row("paint.*.hardness", &PaintStroke::hardness, {0, 1, 0.05},
            "share of the radius that is covered evenly; from there on less and less"),
        row("paint.*.opacity", &PaintStroke::opacity, {0, 1, 0.05},
            "share of the stroke's colour where it covers most"),
        row("paint.*.points.*", &PaintStroke::points, {-1e9, 1e9, 0.01, "solid units"},
            "a point of the stroke's line, before solid.scale", {.required = true}),
        row("pose.weight", &PoseOptions::weight, {0, 1, 0.05},
            "of a mesh with a pose, how far it has gone there; the texture sticks to it"),
        row("animation.seconds", &KeyedAnimation::seconds, {0.01, 3600, 0.1, "s"},
            "how long the animation is"),
        row("animation.rate", &KeyedAnimation::rate, {1, 240, 1, "frames/s"},
            "frames a second of the editor's clock and of frames that it exports"),
        row("animation.end", &KeyedAnimation::loop, {.words = "stop|loop"},
            "loop: the end is the beginning, and no frame is made of it"),
        row("animation.tracks.*.path", &KeyTrack::path, {},
            "the number that changes, as --set takes it; nothing of the atlas", {.required = true}),
        row("animation.tracks.*.ease", &KeyTrack::ease, {},
            "how it goes from key to key; smooth: at rest in every key"),
        row("animation.tracks.*.keys.*.0", &KeyPoint::seconds, {0, 3600, 0.1, "s"},
            "when a key is, later than the key before it", {.required = true}),
        row("animation.tracks.*.keys.*.1", &KeyPoint::value, {-1e9, 1e9, 0.1},
            "what the number is then, within its own range", {.required = true})};
}

std::vector<RecipeParameter> make_table() {
    std::vector<RecipeParameter> table = rows_before_texture();
    std::ranges::move(control_rows(), std::back_inserter(table));
    for (const MemberParameter& one : texture_parameters()) table.push_back({one, {}});
    std::ranges::move(material_rows(), std::back_inserter(table));
    std::ranges::move(rows_after_texture(), std::back_inserter(table));
    return table;
}

bool is_digits(std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::span<const RecipeParameter> parameters() {
    static const std::vector<RecipeParameter> table = make_table();
    return table;
}

const RecipeParameter* find_parameter(std::string_view path) {
    const auto parts = split_path(path);
    const auto all = parameters();
    const auto found = std::ranges::find_if(all, [&](const RecipeParameter& one) {
        return std::ranges::equal(split_path(one.path), parts, [](auto known, auto part) {
            return known == part || (known == "*" && is_digits(part));
        });
    });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace burl
