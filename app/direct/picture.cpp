#include "app/direct/picture.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/light/chosen_environment.h"
#include "app/options/input_limits.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/lattice_check.h"
#include "app/scene/ground.h"
#include "app/surface/normals.h"
#include "app/surface/posed_corners.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

Error bad_plane(const std::string& text) {
    return Error(ExitCode::usage,
                 fmt::format("'{}' is not a plane; write [RECIPE:]NX,NY,NZ,D for the points whose "
                             "NX x + NY y + NZ z is D, for example clouds:0,1,0,4",
                             text));
}

constexpr int most_rays = 1 << 16;
constexpr std::size_t backdrop_rows = 1024;  ///< of a built-in environment that is seen
constexpr int ground_rays = 64;              ///< of the ground's shadow where surfaces take none

/// Parses four finite numbers, the first three not all 0, and normalises the plane. Throws
/// Error(usage).
Plane parse_numbers(const std::string& text, std::string_view rest) {
    std::array<double, 4> numbers{};
    const char* begin = rest.data();
    const char* const end = begin + rest.size();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [stop, error] = std::from_chars(begin, end, numbers[i]);
        const bool ends = i == 3 ? stop == end : stop != end && *stop == ',';
        if (error != std::errc() || !ends || !std::isfinite(numbers[i])) throw bad_plane(text);
        begin = stop + 1;
    }
    Vec3d normal(numbers[0], numbers[1], numbers[2]);
    const double longest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(longest > 0.0)) throw bad_plane(text);
    normal /= longest;
    const double length = longest * glm::length(normal);
    return {glm::normalize(normal), numbers[3] / length};
}

/// The filters that average over a footprint without further samples.
constexpr std::array footprint_filters{FilterKind::none,      FilterKind::table_mip,
                                       FilterKind::table_sat, FilterKind::table_sat3,
                                       FilterKind::exact,     FilterKind::trapezoid};

FilterKind parse_filter(const std::string& text) {
    std::vector<std::string_view> names;
    for (const FilterKind kind : footprint_filters) {
        names.push_back(to_string(kind));
        if (names.back() == text) return kind;
    }
    throw Error(ExitCode::usage, fmt::format("--filter {}: with --direct it must be one of {}",
                                             text, fmt::join(names, ", ")));
}

/// A function of points and footprints, of which both are first mapped by an affine map.
template <class Function>
Function mapped(Function function, const Affine3& map) {
    return [function = std::move(function), map](const Vec3d& p, const Footprint& steps) {
        return function(map(p), {map.linear * steps.u, map.linear * steps.v});
    };
}

/// The bounding sphere of the mesh at rest and posed together, so that the view does not change
/// with the pose's weight.
Sphere sphere_of(const Mesh& mesh, const Mesh& posed) {
    if (posed.triangles.empty()) return bounding_sphere(mesh);
    return sphere_around([&](auto visit) {
        for (const Mesh* one : {&mesh, &posed})
            for (const Part& part : one->parts)
                for (const Mat4d& placement : part.instances)
                    for (std::uint32_t t = 0; t < part.triangle_count; ++t)
                        for (const std::uint32_t p : one->triangles[part.first_triangle + t])
                            visit(Vec3d(placement * Vec4d(one->positions[p], 1.0)));
    });
}

/// A step along a triangle of the posed mesh, mapped to the same triangle at rest.
Vec3d step_at_rest(const Mesh& posed, const Mesh& rest, std::uint32_t triangle, const Vec3d& step) {
    const Triangle &p = posed.triangles[triangle], &r = rest.triangles[triangle];
    const Vec3d e = posed.positions[p[1]] - posed.positions[p[0]],
                f = posed.positions[p[2]] - posed.positions[p[0]];
    const double ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
    const double area = ee * ff - ef * ef;
    if (!(area > 0.0)) return Vec3d(0.0);
    const double a = glm::dot(e, step), b = glm::dot(f, step);
    return (ff * a - ef * b) / area * (rest.positions[r[1]] - rest.positions[r[0]]) +
           (ee * b - ef * a) / area * (rest.positions[r[2]] - rest.positions[r[0]]);
}

}  // namespace

PlaneArgument parse_plane(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    const std::string_view numbers = colon == std::string::npos
                                         ? std::string_view(text)
                                         : std::string_view(text).substr(colon + 1);
    if (colon == 0) throw bad_plane(text);
    return {parse_numbers(text, numbers), colon == std::string::npos ? "" : text.substr(0, colon)};
}

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
    light.add(verb);
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
    verb.add_option("--rays", rays,
                    "With --direct: directions that a sample's light is summed over; 0: smooth "
                    "light without shadows, as without --direct")
        ->check(CLI::Range(0, most_rays))
        ->capture_default_str();
    meshes.add(verb);
    add_pose(verb, pose);
    add_input_limits(verb, meshes, recipe);
}

View DirectOptions::parsed_view() const {
    return view ? parse_view(*view) : View{};
}

PictureOptions DirectOptions::picture_options() const {
    PictureOptions options = picture;
    if (size) options.size = parse_picture_size(*size);
    options.lit = !unlit;
    options.background = light.background_asked();
    options.ground = light.ground;
    if (const std::string given = light.given(); unlit && !given.empty())
        throw Error(ExitCode::usage,
                    fmt::format("{} is about light, and --unlit draws without; leave one of them "
                                "out",
                                given));
    if (!unlit) options.light = light.light_options();
    return options;
}

DirectPicture::DirectPicture(const DirectOptions& options,
                             std::shared_ptr<const PrefilteredLight> smooth)
    : picture_(options.picture_options()),
      widths_(options.widths),
      rays_(options.rays),
      smooth_(std::move(smooth)) {
    if (options.filter) filter_ = parse_filter(*options.filter);
    if (options.scene.empty() && options.planes.empty())
        throw Error(ExitCode::usage,
                    "there is nothing to draw: name a mesh or at least one --plane");
    for (const std::string& text : options.planes) planes_.push_back(parse_plane(text).plane);
    const View view = options.parsed_view();
    if (picture_.lit && !picture_.light.is_headlight()) make_light();
    if (!options.scene.empty()) mesh_ = options.meshes.load(options.scene);
    normals_ = corner_normals(mesh_, options.crease);
    Mesh posed;
    if (!options.pose.empty()) {
        if (options.scene.empty())
            throw Error(ExitCode::usage, "--pose: there is no mesh that it could be of");
        pose_ = options.meshes.pose(options.scene, options.pose);
        posed_normals_ = posed_corners(mesh_, *pose_, normals_).normals;
        posed = posed_mesh(mesh_, *pose_, 1.0);
    }
    sphere_ = sphere_of(mesh_, posed);
    look(view);
}

void DirectPicture::make_light() {
    if (!smooth_ || picture_.ground) environment_ = environment_of(picture_.light);
    if (!smooth_ && rays_ == 0)
        smooth_ = std::make_shared<const PrefilteredLight>(prefilter(*environment_));
    if (picture_.background.kind == Background::Kind::light)
        backdrop_ = environment_of(picture_.light, backdrop_rows);
}

DirectPicture::Shown DirectPicture::shown(const Recipe& recipe, FilterKind otherwise,
                                          const Affine3& map) const {
    const FilterKind kind = filter_.value_or(otherwise);
    const FilteredColor color = widths_ ? filter_width_grey(recipe) : shown_color(recipe, kind);
    Shown result{mapped(color, map), {}};
    if (environment_ || smooth_)
        result.material = mapped(point_material(recipe, kind, color, widths_), map);
    return result;
}

std::vector<PlaneLayer> DirectPicture::layers(const PictureRecipes& recipes) const {
    std::vector<PlaneLayer> result;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        const bool named = i < recipes.planes.size() && recipes.planes[i];
        const Recipe& recipe = named ? *recipes.planes[i] : recipes.main;
        const Shown made = shown(recipe, FilterKind::trapezoid, texture_from_solid(recipe));
        result.push_back({planes_[i], made.color, made.material});
    }
    return result;
}

/// Draws a scene in its surroundings.
Image<Rgba8> DirectPicture::draw(DirectScene scene) const {
    std::optional<Blockers> blockers;
    std::optional<TracedLight> light, on_ground;
    if (picture_.ground || (environment_ && !smooth_)) blockers.emplace(scene.mesh, planes_);
    const Blockers* const solid = blockers ? &*blockers : nullptr;
    if (smooth_)
        light.emplace(smooth_);
    else if (environment_)
        light.emplace(*environment_, rays_, solid);
    if (picture_.ground && (smooth_ || !environment_))
        on_ground.emplace(environment_ ? *environment_ : white_environment(),
                          rays_ > 0 ? rays_ : ground_rays, solid);
    scene.around = {light ? &*light : nullptr, backdrop_ ? &*backdrop_ : nullptr, solid, nullptr};
    if (picture_.ground) scene.around.on_ground = on_ground ? &*on_ground : scene.around.light;
    return render_samples(scene, camera_, picture_);
}

/// Draws the posed surface with the colours of the surface at rest.
Image<Rgba8> DirectPicture::draw_posed(const Recipe& recipe,
                                       const std::vector<PlaneLayer>& planes) const {
    if (!recipe.bump.empty())
        throw Error(ExitCode::unsupported,
                    "--direct draws no bumps of a mesh in a pose; use --lazy, or a recipe without "
                    "\"bump\"");
    check_lattice(recipe, mesh_);
    const double weight = recipe.pose.weight;
    const Mesh posed = posed_mesh(mesh_, *pose_, weight);
    const Shown made = shown(recipe, FilterKind::none, texture_from_mesh(recipe, mesh_));
    const auto at_rest = [&](const auto& function) {
        return [this, &posed, &function](const SurfacePoint& point, const Footprint& steps) {
            const auto rest = [&](const Vec3d& step) {
                return step_at_rest(posed, mesh_, point.triangle, step);
            };
            return function(position(mesh_, point), {rest(steps.u), rest(steps.v)});
        };
    };
    const std::vector<Vec3f> normals = blended_normals(normals_, posed_normals_, weight);
    DirectScene scene{posed, normals, at_rest(made.color), {}, planes};
    if (made.material) scene.material = at_rest(made.material);
    return draw(scene);
}

Image<Rgba8> DirectPicture::with_alpha(const PictureRecipes& recipes) const {
    const Recipe& recipe = recipes.main;
    const std::vector<PlaneLayer> planes = layers(recipes);
    if (pose_) return draw_posed(recipe, planes);
    Shown made;
    SurfaceNormal bumped;
    if (!mesh_.triangles.empty()) {
        check_lattice(recipe, mesh_);
        made = shown(recipe, FilterKind::none, texture_from_mesh(recipe, mesh_));
        bumped = bumped_normals(recipe, mesh_);
    }
    const auto at_point = [&](const auto& function) {
        return [this, &function](const SurfacePoint& point, const Footprint& steps) {
            return function(position(mesh_, point), steps);
        };
    };
    DirectScene scene{mesh_, normals_, at_point(made.color), bumped, planes};
    if (made.material) scene.material = at_point(made.material);
    return draw(scene);
}

Image<Rgb8> DirectPicture::operator()(const PictureRecipes& recipes) const {
    return opaque(with_alpha(recipes));
}

}  // namespace burl
