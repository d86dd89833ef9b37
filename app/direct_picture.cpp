#include "app/direct_picture.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/lattice_check.h"
#include "app/normals.h"
#include "atlas/error.h"

namespace burl {

namespace {

struct NamedFilter {
    std::string_view name;
    FilterKind kind;
};

/// Those that average over a footprint without taking further samples.
constexpr std::array filters{NamedFilter{"none", FilterKind::none},
                             NamedFilter{"table-mip", FilterKind::table_mip},
                             NamedFilter{"table-sat", FilterKind::table_sat},
                             NamedFilter{"table-sat3", FilterKind::table_sat3},
                             NamedFilter{"exact", FilterKind::exact},
                             NamedFilter{"trapezoid", FilterKind::trapezoid}};

FilterKind parse_filter(const std::string& text) {
    std::vector<std::string_view> names;
    for (const NamedFilter& filter : filters) {
        if (filter.name == text) return filter.kind;
        names.push_back(filter.name);
    }
    throw Error(ExitCode::usage, fmt::format("--filter {}: with --direct it must be one of {}",
                                             text, fmt::join(names, ", ")));
}

/// A footprint and the texture's coordinates through an affine map.
FilteredColor mapped(FilteredColor color, const Affine3& map) {
    return [color = std::move(color), map](const Vec3d& p, const Footprint& steps) {
        return color(map(p), {map.linear * steps.u, map.linear * steps.v});
    };
}

}  // namespace

void DirectOptions::add(CLI::App& verb) {
    verb.add_option(
        "scene", scene,
        "Scene (.glb .gltf .obj); with --direct or --lazy any mesh, also sample:teapot and "
        "such");
    verb.add_option("--size", size, "Picture size in pixels, WxH (default 1024x768)");
    verb.add_option(
        "--view", view,
        "Azimuth and elevation in degrees, distance in radii: AZ,EL,DIST (default 30,20,3.5)");
    verb.add_option("--filter", filter,
                    "Texture lookup: nearest, linear or mip (default: as the scene says); with "
                    "--direct: none, table-mip, table-sat, table-sat3, exact or trapezoid "
                    "(default: none for the mesh, trapezoid for planes)");
    verb.add_flag("--unlit", unlit, "Show the texture's colours without light");
    verb.add_option("--supersample", picture.supersample, "n: n x n samples per pixel")
        ->check(CLI::Range(1, max_supersample))
        ->capture_default_str();
    verb.add_option("--plane", planes,
                    "With --direct: a plane to the horizon, [RECIPE:]NX,NY,NZ,D; may be repeated")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb.add_flag("--widths", widths,
                  "With --direct: show the filter's width in place of the colour");
    recipe.add_recipe(verb);
    recipe.add_precision(verb, "float64, with --lazy float32");
    verb.add_option("--crease", crease,
                    "Angle in degrees above which computed normals split (--direct, --lazy)")
        ->check(in_range(0.0, 180.0))
        ->capture_default_str();
    meshes.add(verb);
}

View DirectOptions::parsed_view() const {
    return view ? parse_view(*view) : View{};
}

PictureOptions DirectOptions::picture_options() const {
    PictureOptions options = picture;
    if (size) options.size = parse_picture_size(*size);
    options.lit = !unlit;
    return options;
}

DirectPicture::DirectPicture(const DirectOptions& options)
    : picture_(options.picture_options()), widths_(options.widths) {
    if (options.filter) filter_ = parse_filter(*options.filter);
    if (options.scene.empty() && options.planes.empty())
        throw Error(ExitCode::usage,
                    "there is nothing to draw: name a mesh or at least one --plane");
    for (const std::string& text : options.planes) {
        const PlaneArgument argument = parse_plane(text);
        planes_.push_back({argument.plane, {}});
        if (!argument.recipe.empty()) planes_.back().recipe = load_recipe(argument.recipe);
    }
    const View view = options.parsed_view();
    if (!options.scene.empty()) mesh_ = options.meshes.load(options.scene);
    normals_ = corner_normals(mesh_, options.crease);
    camera_ = orbit_camera(view, bounding_sphere(mesh_), picture_.size);
}

FilteredColor DirectPicture::color_of(const Recipe& recipe, FilterKind otherwise) const {
    return widths_ ? filter_width_grey(recipe)
                   : filtered_color(recipe, filter_.value_or(otherwise));
}

std::vector<PlaneLayer> DirectPicture::layers(const Recipe& recipe) const {
    std::vector<PlaneLayer> result;
    for (const PlacedPlane& placed : planes_) {
        const Recipe& shown = placed.recipe.value_or(recipe);
        result.push_back({placed.plane, mapped(color_of(shown, FilterKind::trapezoid),
                                               texture_from_solid(shown))});
    }
    return result;
}

Image<Rgb8> DirectPicture::operator()(const Recipe& recipe) const {
    const std::vector<PlaneLayer> planes = layers(recipe);
    FilteredColor color;
    SurfaceNormal bumped;
    if (!mesh_.triangles.empty()) {
        check_lattice(recipe, mesh_);
        color = mapped(color_of(recipe, FilterKind::none), texture_from_mesh(recipe, mesh_));
        bumped = bumped_normals(recipe, mesh_);
    }
    const SampleColor at = [&](const SurfacePoint& point, const Footprint& steps) {
        return Vec3d(color(position(mesh_, point), steps));
    };
    return render_samples({mesh_, normals_, at, bumped, planes}, camera_, picture_);
}

}  // namespace burl
