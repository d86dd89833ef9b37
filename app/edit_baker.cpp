#include "app/edit_baker.h"

#include <bit>
#include <chrono>
#include <utility>

#include "app/refinement.h"
#include "app/view_scene.h"

namespace burl {

namespace {

constexpr std::size_t cache_bytes = std::size_t(512) << 20;
constexpr double patience = 0.08;  // seconds until the next finer picture, at rest
constexpr std::uint32_t coarsest_side = 128;

std::uint32_t coarsest_level(std::uint32_t size) {
    return size > coarsest_side ? std::uint32_t(std::bit_width(size / coarsest_side)) - 1 : 0;
}

const char* kind_name(AtlasKind kind) {
    constexpr std::array names{"uniform", "area", "length", "quad", "patch"};
    return names[std::size_t(kind)];
}

/// Then the texture under the paint is there.
bool only_paint_differs(Recipe before, const Recipe& now) {
    before.paint = now.paint;
    return before == now;
}

}  // namespace

EditBaker::EditBaker(std::function<void()> wake, double budget)
    : wake_(wake),
      budget_(budget),
      worker_([this](const WorkerRequest& request,
                     const std::stop_token& stop) { work(request, stop); },
              std::move(wake)) {}

void EditBaker::set_mesh(Mesh mesh) {
    const std::scoped_lock lock(mutex_);
    next_mesh_ = std::move(mesh);
}

std::shared_ptr<const EditSurface> EditBaker::surface() const {
    const std::scoped_lock lock(mutex_);
    return surface_;
}

std::shared_ptr<const EditPicture> EditBaker::picture() const {
    const std::scoped_lock lock(mutex_);
    return picture_;
}

std::shared_ptr<const SurfacePick> EditBaker::pick() const {
    const std::scoped_lock lock(mutex_);
    return pick_;
}

bool EditBaker::want_sheet(bool wanted) {
    const std::scoped_lock lock(mutex_);
    const bool begins = wanted && !wants_sheet_;
    wants_sheet_ = wanted;
    if (!wanted) sheet_.reset();
    return begins;
}

std::shared_ptr<const AtlasSheet> EditBaker::sheet() const {
    const std::scoped_lock lock(mutex_);
    return surface_ && sheet_key_.surface == surface_->number ? sheet_ : nullptr;
}

StageRecords EditBaker::records() const {
    const std::scoped_lock lock(mutex_);
    return records_;
}

void EditBaker::take_mesh() {
    std::optional<Mesh> mesh;
    {
        const std::scoped_lock lock(mutex_);
        mesh = std::exchange(next_mesh_, std::nullopt);
    }
    if (!mesh) return;
    pipeline_ = std::make_unique<Pipeline>(std::move(*mesh));
    pipeline_->set_cache(cache_bytes);
    fresh_ = true;
    finest_.reset();
}

void EditBaker::publish_surface(Pipeline& pipeline) {
    auto surface = std::make_shared<EditSurface>();
    surface->scene = baked_scene(pipeline);
    const int normals = baked_material(surface->scene).normals;
    if (normals >= 0)  // flat until there is a map of them
        surface->scene.textures[std::size_t(normals)].image = Image<Rgb8>(1, 1, {128, 128, 255});
    surface->unit_from_mesh = solid_from_mesh(pipeline.mesh(), SolidSpace::unit);
    surface->sphere = bounding_sphere(surface->scene);
    surface->size = pipeline.recipe().atlas.size;
    surface->triangles = pipeline.mesh().triangles.size();
    surface->atlas = kind_name(pipeline.atlas().options.kind);
    surface->layout_seconds = pipeline.records()[Stage::layout].seconds;
    const std::scoped_lock lock(mutex_);
    surface->number = ++numbers_;
    surface_ = std::move(surface);
}

/// Once for every surface.
void EditBaker::publish_pick() {
    const std::shared_ptr<const EditSurface> surface = this->surface();
    if (!surface || (pick_ && &pick_->scene() == &surface->scene)) return;
    // The scene lives as long as its surface.
    auto pick =
        std::make_shared<const SurfacePick>(std::shared_ptr<const Scene>(surface, &surface->scene));
    {
        const std::scoped_lock lock(mutex_);
        pick_ = std::move(pick);
    }
    wake_();
}

/// Where somebody looks at it.
void EditBaker::publish_sheet() {
    SheetKey key{0, pipeline_->recipe().solid.space};
    {
        const std::scoped_lock lock(mutex_);
        key.surface = surface_->number;
        if (!wants_sheet_ || (sheet_ && sheet_key_ == key)) return;
    }
    auto sheet = std::make_shared<const AtlasSheet>(atlas_sheet(*pipeline_));
    {
        const std::scoped_lock lock(mutex_);
        sheet_ = std::move(sheet);
        sheet_key_ = key;
    }
    wake_();
}

void EditBaker::publish_picture(const WorkerRequest& request, std::uint32_t level,
                                const Image<Rgb8>& texels, double seconds) {
    auto picture = std::make_shared<EditPicture>();
    picture->request = request.number;
    picture->level = level;
    picture->texels = texels;
    picture->seconds = seconds;
    {
        const std::scoped_lock lock(mutex_);
        picture->number = ++numbers_;
        picture->surface = surface_->number;
        picture_ = std::move(picture);
        records_ = pipeline_->records();
    }
    wake_();
}

void EditBaker::work(const WorkerRequest& request, const std::stop_token& stop) {
    take_mesh();
    if (!pipeline_) return;
    pipeline_->set_recipe(request.recipe);
    if (fresh_ || shown_atlas_ != request.recipe.atlas) {
        publish_surface(*pipeline_);
        shown_atlas_ = request.recipe.atlas;
        choice_.emplace(budget_, coarsest_level(request.recipe.atlas.size));
        fresh_ = false;
    }
    auto start = std::chrono::steady_clock::now();
    const Drag drag = request.moving ? Drag::moving : Drag::released;
    // Paint over the finest picture is quicker than any other level's, and says nothing of them.
    LevelChoice finest(budget_, 0);
    const bool paints = finest_ && only_paint_differs(*finest_, request.recipe);
    refine<Rgb8>(*pipeline_, paints ? finest : *choice_, drag, patience, stop,
                 [&](std::uint32_t level, const Image<Rgb8>& texels) {
                     const auto now = std::chrono::steady_clock::now();
                     if (level == 0) finest_ = request.recipe;
                     publish_picture(request, level, texels,
                                     std::chrono::duration<double>(now - start).count());
                     start = std::chrono::steady_clock::now();
                 });
    publish_pick();
    publish_sheet();
}

}  // namespace burl
