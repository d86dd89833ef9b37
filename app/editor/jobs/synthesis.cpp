#include "app/editor/jobs/synthesis.h"

#include <thread>
#include <utility>

#include <fmt/format.h>

#include "app/editor/jobs/surface.h"
#include "app/pipeline/measure_synthesis.h"
#include "app/surface/tangents.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// The tangent frames that Pipeline::normal_map has.
FrameMaps frames_of(Pipeline& pipeline) {
    const MeshAtlas& atlas = pipeline.mesh_atlas();
    const NormalFrames frames = make_normal_frames(
        pipeline.mesh(), atlas, {pipeline.recipe().solid.space, edit_crease_degrees, true});
    return frame_maps(
        pipeline.solid(),
        {pipeline.atlas_mesh(), atlas.atlas(), frames.positions, frames.normals, frames.tangents},
        0);
}

}  // namespace

/// The makers in the context.
struct EditSynthesizer::Makers {
    explicit Makers(GlContext& context) : pictures(context), passes(context) {}
    GlPictureMaker pictures;
    GlPassMaker passes;
};

/// The objects are destroyed where their context is current: on a thread of its own, for the
/// calling one has the window's.
EditSynthesizer::~EditSynthesizer() {
    if (!makers_) return;
    std::thread([this] {
        const CurrentContext current(*context_);
        makers_.reset();
    }).join();
}

void EditSynthesizer::offer(std::unique_ptr<GlContext> context, bool software) {
    const std::scoped_lock lock(mutex_);
    if (context_) return;
    context_ = std::move(context);
    software_ = software;
}

bool EditSynthesizer::has_context() const {
    const std::scoped_lock lock(mutex_);
    return context_ != nullptr;
}

/// The makers, whose context is current; null without a context.
EditSynthesizer::Makers* EditSynthesizer::makers() {
    if (!makers_ && context_) makers_ = std::make_unique<Makers>(*context_);
    return makers_.get();
}

/// Times both ways once. Each of OpenGL's textures is of another scale, because a shader holds its
/// recipe's numbers, so that a drag compiles one for every texture.
void EditSynthesizer::measure(const Recipe& recipe, Makers& made) {
    Recipe changed = recipe;
    const SynthesisSeconds seconds = measure_synthesis(recipe, [&](const SolidAtlas& square) {
        changed.solid.scale *= 1.001;
        made.pictures.make(square, changed, {});
    });
    made.pictures.forget_atlas();
    faster_ = seconds.other < seconds.host;
    measured_ = fmt::format("OpenGL {:.2g} ms, host {:.2g} ms for 1024 x 1024", 1e3 * seconds.other,
                            1e3 * seconds.host);
}

/// Whether OpenGL is to make the recipe's texture; says who does, and why.
bool EditSynthesizer::chooses_gl(const Recipe& recipe, const SynthesisWish& wish, Makers& made) {
    const std::string why = wish.by == EditSynthesis::passes ? made.passes.problem(recipe)
                                                             : made.pictures.problem(recipe);
    words_ = why.empty() ? "OpenGL" : "the host: " + why;
    if (!why.empty() || wish.by != EditSynthesis::automatic) return why.empty();
    words_ = software_ ? "the host: OpenGL is software here" : "";
    if (software_) return false;
    if (!faster_) measure(recipe, made);
    words_ = fmt::format("{}: {}", *faster_ ? "OpenGL" : "the host", measured_);
    return *faster_;
}

ResidentPicture EditSynthesizer::pictures(Pipeline& pipeline, Makers& made,
                                          const std::vector<PicturePlan>& plans,
                                          std::vector<int> numbers, int normals) {
    const Recipe& recipe = pipeline.recipe();
    const bool bumps = normals >= 0 && made.pictures.makes_bumps(recipe);
    if (bumps && !made.pictures.has_frames()) made.pictures.set_frames(frames_of(pipeline));
    if (bumps) numbers.push_back(normals);
    return {made.pictures.make(pipeline.solid(), recipe, plans), std::move(numbers), {}};
}

std::optional<ResidentPicture> EditSynthesizer::make(Pipeline& pipeline, const SynthesisWish& wish,
                                                     const std::vector<PicturePlan>& plans,
                                                     const std::vector<int>& numbers, int normals) {
    words_ = "the host";
    if (wish.by == EditSynthesis::host || !has_context()) return {};
    const CurrentContext current(*context_);
    Makers& made = *makers();
    const Recipe& recipe = pipeline.recipe();
    if (!chooses_gl(recipe, wish, made)) return {};
    if (wish.by != EditSynthesis::passes) return pictures(pipeline, made, plans, numbers, normals);
    constexpr std::size_t all = std::size_t(-1);
    auto pictures = made.passes.make(pipeline.solid(), recipe, wish.pass > 0 ? wish.pass : all);
    return ResidentPicture{std::move(pictures), {numbers[0]}, made.passes.shown()};
}

Image<Rgb8> EditSynthesizer::read(const ResidentPicture& picture) {
    const CurrentContext current(*context_);
    return read_texels(context_->gl(), *picture.pictures);
}

void EditSynthesizer::forget_atlas() {
    if (!makers_) return;
    const CurrentContext current(*context_);
    makers_->pictures.forget_atlas();
    makers_->passes.forget_atlas();
}

}  // namespace burl
