#include "app/library/bake.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/bake/bake.h"
#include "app/bake/expected_tasks.h"
#include "app/bake/shared_pictures.h"
#include "app/bake/tiles.h"
#include "app/export/command_files.h"
#include "app/library/guard.h"
#include "app/library/reported.h"
#include "app/library/states.h"
#include "app/pipeline/mask_picture.h"
#include "app/pipeline/tasks.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/stop.h"
#include "atlas/build/alpha_levels.h"
#include "atlas/build/block_levels.h"
#include "atlas/build/capacity.h"

namespace burl::library {

namespace {

[[noreturn]] void refuse(const std::string& sentence) {
    throw burl::Error(ExitCode::usage, sentence);
}

/// The value of a word of an option. Throws burl::Error(usage) listing the words.
template <class Enum>
Enum word_of(const char* option, const std::string& word) {
    const auto value = enum_named<Enum>(word);
    if (!value)
        refuse(fmt::format("{} '{}': must be one of {}", option, word,
                           fmt::join(enum_names<Enum>, ", ")));
    return *value;
}

void check_options(const BakeOptions& options) {
    if (options.depth != 8 && options.depth != 16 && options.depth != 32)
        refuse(fmt::format("depth {}: must be 8, 16 or 32", options.depth));
    if (options.depth == 32 && !options.masks.empty())
        refuse("masks are codes of 8 or 16 bits; bake them with that depth");
    if (options.levels < -1) refuse(fmt::format("levels {}: must be -1 or more", options.levels));
    if (options.threads < 0) refuse(fmt::format("threads {}: must be 0 or more", options.threads));
    if (!(options.crease >= 0.0 && options.crease <= 180.0))
        refuse(fmt::format("crease {}: must be from 0 to 180 degrees", options.crease));
    const auto known = mask_picture_names();
    for (const std::string& mask : options.masks)
        if (std::ranges::find(known, mask) == known.end())
            refuse(
                fmt::format("there is no mask '{}'; there are {}", mask, fmt::join(known, ", ")));
}

/// The recipe at 0 s with the options' atlas.
burl::Recipe asked_recipe(const Recipe& recipe, const BakeOptions& options) {
    burl::Recipe asked = recipe_at(recipe.state().recipe, 0.0);
    if (options.size != 0)
        asked.atlas.size = options.size, asked.atlas.width = asked.atlas.height = 0;
    if (!options.atlas.empty()) asked.atlas.kind = word_of<AtlasKind>("atlas", options.atlas);
    check_size(asked.atlas);
    return asked;
}

/// One bake of a pipeline that holds the mesh and the recipe.
class Baking {
  public:
    Baking(Pipeline& pipeline, const BakeOptions& options, Baked::State& result)
        : pipeline_(pipeline), options_(options), result_(result) {}

    void run(const std::stop_token& stop, Course* course) {
        pipeline_.context().stop = stop;
        if (course) {
            pipeline_.context().meter = &course->meter();
            course->expect(expected_tasks(plan(), pipeline_.recipe(), pipeline_));
        }
        go_on(tasks::layout);
        pipeline_.lay_out(stop);
        go_on(tasks::points);
        note_atlas();
        pipeline_.solid();
        const MaterialAsked asked = material_asked();
        const burl::Recipe& recipe = pipeline_.recipe();
        check_material(recipe, asked, fixed() ? "precision fixed" : "");
        go_on(tasks::texture);
        std::vector<Image<RgbF>> normal_levels;
        if (options_.depth == 32)
            bake_floats(asked);
        else
            normal_levels = bake_codes(asked);
        if (has_normals()) {
            go_on(tasks::normals);
            result_.options.normals = bake_normals(pipeline_, NormalSpace::tangent,
                                                   std::min(options_.depth, 16), options_.crease);
            add_levels(*result_.options.normals, normal_levels);
        }
        for (const std::string& mask : options_.masks) {
            go_on(tasks::masks);
            add_mask(mask);
        }
        check_stop(stop);
        finish(asked);
    }

  private:
    bool has_normals() const { return options_.normals && !pipeline_.recipe().bump.empty(); }
    void go_on(const char* task) {
        check_stop(pipeline_.context().stop);
        pipeline_.context().begin(task);
    }
    /// The plan of a bake that does the same but writes nothing.
    BakePlan plan() const {
        BakePlan plan;
        plan.kind = options_.depth == 32   ? ImageKind::rgb_float
                    : options_.depth == 16 ? ImageKind::rgb16
                                           : ImageKind::rgb8;
        plan.depth = std::min(options_.depth, 16);
        plan.levels.count = std::uint32_t(std::abs(options_.levels));
        plan.normals = has_normals() ? NormalSpace::tangent : NormalSpace::none;
        plan.packing = result_.packing;
        plan.crease_degrees = options_.crease;
        plan.threads = options_.threads;
        return plan;
    }
    bool fixed() const { return pipeline_.recipe().precision.kind == PrecisionKind::fixed; }

    /// The number of levels asked for, as far as the atlas has them.
    std::uint32_t level_count() {
        const AtlasOptions& atlas = pipeline_.recipe().atlas;
        const auto all = std::uint32_t(std::bit_width(std::min(atlas.columns(), atlas.rows()))) - 1;
        if (options_.levels == 0) return 0;
        if (options_.depth == 32) return all;
        const std::uint32_t last = last_level(pipeline_.mesh_atlas());
        const std::uint32_t asked =
            options_.levels < 0 ? all : std::min(std::uint32_t(options_.levels), all);
        if (asked > last)
            result_.notes.push_back(
                fmt::format("MIP levels above {} of the {} atlas mix unrelated triangles and are "
                            "left out; quad and patch have more",
                            last, to_string(pipeline_.atlas().options.kind)));
        return std::min(asked, last);
    }

    MaterialAsked material_asked() {
        MaterialAsked asked{result_.packing, options_.depth, level_count(),
                            has_normals() && options_.depth != 32, options_.crease};
        return asked;
    }

    void note_atlas() {
        const AtlasOptions& asked = pipeline_.recipe().atlas;
        for (const std::string& note :
             {pipeline_.atlas().notes.fallback,
              shortage(capacity(pipeline_.mesh().triangles.size(), asked))})
            if (!note.empty()) result_.notes.push_back(note);
        for (std::string& note : uv_losses(pipeline_.mesh(), pipeline_.atlas().notes))
            result_.notes.push_back(std::move(note));
    }

    /// Makes pictures of 8 or 16 bits; returns the levels of the normal map.
    std::vector<Image<RgbF>> bake_codes(const MaterialAsked& asked) {
        if (!has_pictures(pipeline_.recipe(), asked.packing, asked.rough_levels())) {
            BakedTexture texture =
                bake_texture(pipeline_, options_.depth == 16 ? ImageKind::rgb16 : ImageKind::rgb8,
                             {asked.levels, {}});
            result_.color = std::move(texture.image);
            result_.options.levels = std::move(texture.levels);
            return {};
        }
        BakedMaterial material = bake_material(pipeline_, asked);
        result_.color = std::move(material.color);
        result_.options.levels = std::move(material.color_levels);
        result_.options.pictures = std::move(material.pictures);
        return std::move(material.normal_levels);
    }

    /// A picture with its levels, of as many components as it has.
    void add_floats(const std::string& name, Image<RgbaF> image, std::size_t components,
                    std::uint32_t count, bool masked) {
        const auto cutoff = float(pipeline_.recipe().material.alpha_cutoff);
        std::vector<Image<RgbaF>> levels =
            masked ? masked_levels(pipeline_.mesh_atlas(), image, cutoff, count)
                   : block_levels(pipeline_.mesh_atlas(), image, count);
        levels.insert(levels.begin(), std::move(image));
        FloatLevels& floats = result_.floats.emplace_back(FloatLevels{name, {}});
        for (Image<RgbaF>& level : levels) {
            if (components == 4)
                floats.levels.emplace_back(std::move(level));
            else if (components == 3)
                floats.levels.emplace_back(converted<RgbF>(level, [](const RgbaF& p) {
                    return RgbF{p.r, p.g, p.b};
                }));
            else
                floats.levels.emplace_back(
                    converted<float>(level, [](const RgbaF& p) { return p.r; }));
        }
    }

    /// Makes pictures of floats.
    void bake_floats(const MaterialAsked& asked) {
        const burl::Recipe& recipe = pipeline_.recipe();
        if (!has_pictures(recipe, asked.packing)) {
            Image<RgbF> texture = pipeline_.synthesize<RgbF>();
            std::vector<Image<RgbF>> levels;
            if (asked.levels > 0) levels = pipeline_.levels(texture, asked.levels);
            FloatLevels& floats = result_.floats.emplace_back(FloatLevels{"color", {}});
            floats.levels.emplace_back(std::move(texture));
            for (Image<RgbF>& level : levels) floats.levels.emplace_back(std::move(level));
            return;
        }
        const std::vector<MaterialPicture> wanted = material_pictures(recipe, asked.packing);
        std::vector<Image<RgbaF>> images =
            shared_pictures<RgbaF>(pipeline_, {&recipe, 1}, wanted, asked.packing, false);
        const bool clear = is_transparent(recipe);
        add_floats("color", std::move(images[0]), clear ? 4 : 3, asked.levels,
                   clear && recipe.material.alpha == AlphaMode::mask);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            add_floats(wanted[i].name, std::move(images[i + 1]), wanted[i].components, asked.levels,
                       false);
    }

    void add_mask(const std::string& name) {
        const auto add = [&](PictureImage image) {
            result_.masks.emplace_back(name, std::move(image));
        };
        const bool deep = options_.depth == 16;
        if (name == light_picture_name)
            deep ? add(light_picture<Rgb16>(pipeline_)) : add(light_picture<Rgb8>(pipeline_));
        else
            deep ? add(mask_picture<Grey16>(pipeline_, name))
                 : add(mask_picture<Grey8>(pipeline_, name));
    }

    void finish(const MaterialAsked& asked) {
        const burl::Recipe& recipe = pipeline_.recipe();
        result_.options.crease_degrees = options_.crease;
        result_.options.recipe_json = to_json(recipe);
        result_.options.recipe_name = recipe.name;
        result_.options.material = material_factors(recipe, asked.rough_levels());
        if (options_.depth != 32) cut_to_extent(recipe.atlas, result_.color, result_.options);
        result_.mesh = pipeline_.atlas_mesh();
        result_.atlas = pipeline_.atlas();
        const Vec2d extent = result_.atlas.extent();
        result_.uvs.reserve(6 * result_.atlas.corners.size());
        for (const auto& triangle : result_.atlas.corners)
            for (const Vec2d& corner : triangle)
                result_.uvs.push_back(corner.x / extent.x),
                    result_.uvs.push_back(corner.y / extent.y);
        for (const std::string_view name : enum_names<Channel>) {
            const Channel channel = *enum_named<Channel>(name);
            if (!is_color(channel))
                result_.factors.emplace_back(name,
                                             channel_number(result_.options.material, channel));
        }
        add_views(result_);
    }

    Pipeline& pipeline_;
    const BakeOptions& options_;
    Baked::State& result_;
};

}  // namespace

Baked bake(const Mesh& mesh, const Recipe& recipe, const BakeOptions& options) {
    auto result = std::make_shared<Baked::State>();
    const auto work = [&](const std::stop_token& stop, Course* course) {
        guarded([&] {
            Pipeline pipeline(mesh.state().mesh);
            pipeline.set_threads(options.threads);
            pipeline.set_recipe(asked_recipe(recipe, options));
            check_lattice(pipeline.recipe(), pipeline.mesh());
            Baking(pipeline, options, *result).run(stop, course);
            result->mesh_path = mesh.state().path;
            result->mesh_losses = mesh.state().losses;
            result->recipe_files = files_of_recipe(recipe.state().origin, pipeline.recipe());
            result->recipe = pipeline.recipe();
        });
    };
    guarded([&] {
        check_options(options);
        result->depth = options.depth;
        result->packing = word_of<Packing>("packing", options.packing);
    });
    run_reported(options.progress, work);
    return Baked(std::move(result));
}

}  // namespace burl::library
