#include "app/bench/gl/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "app/base/stopwatch.h"
#include "app/bench/meshes.h"
#include "app/gl/draw/lazy_picture.h"
#include "app/gl/draw/view_scene.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"
#include "atlas/solid/texel_set.h"

namespace burl {

namespace {

void append(Mesh& mesh, const Mesh& more, double scale, const Vec3d& move) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const Vec3d& p : more.positions) mesh.positions.push_back(scale * p + move);
    for (const Triangle& t : more.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// The teapot behind six balls a third of its size.
Mesh teapot_behind_balls() {
    Mesh mesh = sample_mesh("sample:teapot");
    const Sphere sphere = bounding_sphere(mesh);
    mesh.corners = {};
    const Mesh ball = bumpy_sphere(1200);
    for (int k = 0; k < 6; ++k) {
        const double turn = std::numbers::pi / 3.0 * k;
        const Vec3d direction(std::sin(turn), 0.1, std::cos(turn));
        append(mesh, ball, sphere.radius / 3.0, sphere.centre + 1.2 * sphere.radius * direction);
    }
    mesh.parts = {{mesh.name, 0, std::uint32_t(mesh.triangles.size())}};
    mesh.source_faces.clear();  // the balls have no source faces
    return mesh;
}

struct ViewSubject {
    std::string name;
    Mesh mesh;
    double distance;  ///< distance of the eye, in radii of the scene's bounding sphere
};

std::vector<ViewSubject> scenes(const ViewBenchSubjects& subjects) {
    std::vector<ViewSubject> result{{"teapot", sample_mesh("sample:teapot"), 2.5},
                                    {"teapot behind balls", teapot_behind_balls(), 1.7}};
    for (const std::string& name : subjects.samples)
        result.push_back({name, sample_mesh("sample:" + name), 2.5});
    return result;
}

std::vector<View> sweep(int count, double distance) {
    std::vector<View> views;
    for (int k = 0; k < count; ++k)
        views.push_back(
            {360.0 / count * k, std::array{20.0, -15.0, 50.0}[std::size_t(k % 3)], distance});
    return views;
}

/// A scene drawn before its texture is made.
struct ViewedScene {
    GlContext& context;
    Pipeline& pipeline;
    Scene scene;
    GlScene drawn;
    TextureLookup lookup;

    ViewedScene(GlContext& c, Pipeline& p)
        : context(c),
          pipeline(p),
          scene(baked_scene(p)),
          drawn(c.gl(), scene),
          lookup(lookup_of(scene, baked_material(scene).texture, {}, p.solid().size)) {}

    ViewTexels find(const PictureSize& picture, const View& view, const LookupSlack& slack) const {
        const PictureOptions options{picture, false, 2};
        const Camera camera = orbit_camera(view, bounding_sphere(scene), options.size);
        return view_texels(context, drawn, camera, options, baked_material(scene).texture, lookup,
                           slack);
    }
    ViewSource source() const {
        return {pipeline.mesh_atlas(), pipeline.solid(), pipeline.recipe(), {.direct = true}};
    }
    void make(const std::vector<TexelSet>& part, const ViewTexels& view, double& seconds) const {
        timed(seconds, [&] { return view_texture(source(), part, view, lookup.filter, {}); });
    }
};

void add_view(const ViewedScene& viewed, const PictureSize& picture, const View& view,
              std::vector<ViewBench>& rows) {
    const ViewSource source = viewed.source();
    const ViewTexels exact = viewed.find(picture, view, no_slack);
    const std::uint64_t visible = count_texels(source, view_part(source, exact, 1));
    double finding = 0.0;
    const ViewTexels read = timed(finding, [&] { return viewed.find(picture, view, most_slack); });
    for (ViewBench& row : rows) {
        row.seconds_find += finding;
        const std::vector<TexelSet> part =
            timed(row.seconds_find, [&] { return view_part(source, read, row.cell); });
        viewed.make(part, read, row.seconds_make);
        const std::uint64_t made = count_texels(source, part);
        row.views += 1;
        row.visible += visible;
        row.made += made;
        row.whole += texel_count(source.solid);
        row.tiles += read.count_tiles();
        for (const TexelSet& level : exact.levels) row.read += level.count();
        row.worst = std::max(row.worst, double(made) / double(visible));
    }
}

Recipe recipe_of(AtlasKind kind, std::uint32_t size) {
    Recipe recipe = load_recipe("marble");
    recipe.atlas.kind = kind;
    recipe.atlas.size = size;
    return recipe;
}

void add_rows(GlContext& context, const ViewSubject& subject, AtlasKind kind,
              const ViewBenchSubjects& subjects, std::vector<ViewBench>& all) {
    Pipeline pipeline(subject.mesh);
    pipeline.set_recipe(recipe_of(kind, subjects.size));
    const ViewedScene viewed(context, pipeline);
    std::vector<ViewBench> rows;
    for (const std::uint32_t cell : {1u, 8u, tile_side}) {
        ViewBench& row = rows.emplace_back();
        row.scene = subject.name, row.atlas = to_string(kind), row.size = subjects.size,
        row.cell = cell;
    }
    const std::vector<View> views = sweep(subjects.views, subject.distance);
    for (const View& view : views) add_view(viewed, subjects.picture, view, rows);
    ViewTexels everything(subjects.size);
    for (TexelSet& level : everything.levels)
        for (std::uint32_t y = 0; y < level.size(); ++y) level.insert({0, level.size()}, y);
    double whole = 0.0;
    viewed.make(whole_part(viewed.source()), everything, whole);
    for (ViewBench& row : rows) row.seconds_whole = whole;
    all.insert(all.end(), rows.begin(), rows.end());
}

}  // namespace

std::vector<ViewBench> bench_views(const std::string& platform, const ViewBenchSubjects& subjects) {
    const std::unique_ptr<GlContext> context = create_gl_context(platform);
    context->make_current();
    std::vector<ViewBench> rows;
    for (const ViewSubject& scene : scenes(subjects))
        for (const AtlasKind kind : {AtlasKind::area, AtlasKind::quad, AtlasKind::patch})
            add_rows(*context, scene, kind, subjects, rows);
    return rows;
}

std::vector<std::uint32_t> bench_levels_seen(const std::string& platform, std::uint32_t size) {
    const std::unique_ptr<GlContext> context = create_gl_context(platform);
    context->make_current();
    Pipeline pipeline(sample_mesh("sample:teapot"));
    pipeline.set_recipe(recipe_of(AtlasKind::patch, size));
    const ViewedScene viewed(*context, pipeline);
    std::vector<std::uint32_t> levels;
    for (const double distance : economy_distances) {
        const ViewTexels view = viewed.find({1024, 768}, {30.0, 20.0, distance}, no_slack);
        const auto most = std::ranges::max_element(view.levels, {}, &TexelSet::count);
        levels.push_back(std::uint32_t(most - view.levels.begin()));
    }
    return levels;
}

}  // namespace burl
