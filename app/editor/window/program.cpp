#include "app/editor/window/program.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/base/stopwatch.h"
#include "app/editor/panels/keys.h"
#include "app/editor/panels/scale.h"
#include "app/editor/session/input.h"
#include "app/image/image_io.h"
#include "app/recipe/keyed_recipe.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// Evaluates a recipe's animation at a time; a recipe invalid at that time is returned unevaluated.
Recipe still_of(const Recipe& recipe, double seconds) {
    try {
        return recipe_at(recipe, seconds);
    } catch (const Error&) {
        return recipe;
    }
}

}  // namespace

EditorProgram::ImGuiOwner::ImGuiOwner() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    map_keys(io);
    ImGui::StyleColorsDark();
}

EditorProgram::ImGuiOwner::~ImGuiOwner() {
    ImGui::DestroyContext();
}

EditorProgram::EditorProgram(std::unique_ptr<GlWindow> window, const EditorOptions& options)
    : window_(std::move(window)),
      renderer_(window_->context().gl()),
      session_(load_recipe(options.recipe, options.settings), options.recipe),
      autosave_(options.autosave),
      export_([this] { window_->wake(); }),
      first_mesh_(options.mesh),
      files_([this] { window_->wake(); }, options.recent),
      baker_([this] { window_->wake(); }),
      posed_pick_([this] { window_->wake(); }),
      object_(window_->context().gl()),
      figures_([this] { window_->wake(); }),
      atlas_(window_->context().gl(), [this] { window_->wake(); }) {
    scale_ = normal_scale_ = options.ui_scale * window_->text_scale();
    if (options.gallery) gallery_.emplace(window_->context().gl(), [this] { window_->wake(); });
    files_.set_recipe(options.recipe);
    files_.open(options.mesh);
}

EditorProgram::~EditorProgram() {
    export_.wait();
}

void EditorProgram::take(const InputEvent& event) {
    feed(ImGui::GetIO(), event);
    if (event.kind == InputKind::drop)
        for (const std::string& file : event.files) open(file);
    if (event.kind == InputKind::close) ask_to_close();
}

/// Takes over the results of other threads and writes the autosave when it is due.
void EditorProgram::take_news() {
    take_files();
    if (const auto problem = baker_.take_problem()) session_.complain(*problem);
    if (const auto problem = atlas_.take_problem()) session_.complain(*problem);
    if (const auto outcome = export_.take_outcome()) {
        if (outcome->problem)
            session_.complain(outcome->text);
        else
            session_.tell(outcome->text);
        if (!outcome->problem) news(outcome->text, false);
    }
    if (const auto problem = session_.take_problem(); problem && !files_.asks())
        news(*problem, true);
    autosave_.keep(session_.history(), last_seconds_);
}

void EditorProgram::note(const std::vector<InputEvent>& events) {
    if (!recording_) return;
    recording_->size = window_->size();
    ScriptStep step;
    if (events.empty()) {
        step.kind = ScriptStep::Kind::settle;
        if (!recording_->steps.empty() && recording_->steps.back() == step) return;
    } else {
        step.kind = ScriptStep::Kind::events;
        step.events = events;
    }
    recording_->steps.push_back(std::move(step));
}

void EditorProgram::take_screenshot() {
    std::string path;
    try {
        path = claim_numbered("burl", ".png");
        write_png(path, screenshot());
        session_.tell(fmt::format("screenshot {}", path));
    } catch (const Error& error) {
        std::error_code unknown;
        // It is the empty file claimed above.
        if (!path.empty()) std::filesystem::remove(path, unknown);
        session_.complain(error.what());
    }
}

/// Returns the recipe on screen, which is the opened one while comparing.
Recipe EditorProgram::shown_recipe() {
    return comparing_ ? still_of(session_.history().opened(), session_.time()) : session_.still();
}

/// Requests the texture of the recipe on screen unless that was done. The pose's weight is left
/// out: it changes no texel.
void EditorProgram::request_texture() {
    if (baker_.want_sheet(atlas_.state.shown)) requested_.reset();
    if (comparing_ && compared_ != session_.recipe()) comparing_ = false;
    WorkerRequest wanted{shown_recipe(), is_moving()};
    wanted.recipe.pose = {};
    const bool same = requested_ && requested_->recipe == wanted.recipe &&
                      (requested_->moving == wanted.moving || !requested_->moving);
    if (same) return;
    requested_ = wanted;
    request_ = baker_.request(wanted.recipe, wanted.moving);
}

bool EditorProgram::settled() const {
    return files_.idle() && baker_.idle() && posed_pick_.idle() && atlas_.idle() &&
           !object_.uploading() && !is_moving();
}

void EditorProgram::frame(const std::vector<InputEvent>& events) {
    window_->context().make_current();
    times_ = {};
    const double began = thread_seconds();
    timed(times_.panels, [&] { panels(events); });
    times_.panels -= times_.object;
    times_.worked += thread_seconds() - began;
    timed(times_.screen, [&] { draw_screen(); });
    if (std::exchange(screenshot_due_, false)) take_screenshot();
}

/// Runs a frame except for drawing the screen.
void EditorProgram::panels(const std::vector<InputEvent>& events) {
    ImGuiIO& io = ImGui::GetIO();
    const glm::ivec2 size = window_->size(), pixels = window_->pixels();
    io.DisplaySize = {float(size.x), float(size.y)};
    if (size.x > 0 && size.y > 0)
        io.DisplayFramebufferScale = {float(pixels.x) / float(size.x),
                                      float(pixels.y) / float(size.y)};
    const double now = window_->seconds();
    io.DeltaTime = float(std::clamp(now - last_seconds_, 1e-4, 0.25));
    last_seconds_ = now;
    note(events);
    for (const InputEvent& event : events) take(event);
    take_news();
    advance(timeline_, session_, double(io.DeltaTime));
    items_.clear();
    if (std::exchange(shown_scale_, scale_) != scale_) {
        set_interface_scale(scale_);
        renderer_.upload_fonts();
    }
    object_image_ = {};
    const std::string new_title = title();
    if (std::exchange(shown_title_, new_title) != new_title) window_->set_title(new_title);
    share_ = pose_share();
    posed_pick_.follow(object_.surface(), share_, is_moving());
    forget_unseen_popups();
    ImGui::NewFrame();
    shortcuts();
    layout();
    ImGui::Render();
    request_texture();
    atlas_.follow(baker_, request_, requested_->recipe);
    follow_opening();
}

/// Holds background work that can wait while a mesh is being opened and needs the processors.
void EditorProgram::follow_opening() {
    const bool is_seen = !object_.uploading() && object_.picture() == baker_.picture().get();
    const bool opening =
        !files_.reading(FileKind::mesh).empty() || baker_.opening() || (opening_ && !is_seen);
    if (opening_ && !opening) frames_to_draw_ = std::max(frames_to_draw_, 2);
    opening_ = opening;
    baker_.hold_errands(opening_);
    if (gallery_) gallery_->hold(opening_);
}

std::string EditorProgram::title() const {
    const std::string mesh = std::filesystem::path(files_.mesh()).filename().string();
    return fmt::format("{}{} on {} - Burl", session_.recipe().name,
                       session_.history().unsaved() ? " *" : "", mesh);
}

void EditorProgram::draw_screen() {
    window_->bind_screen();
    renderer_.update(*ImGui::GetDrawData(), Vec3f(0.1f), object_image_);
}

Image<Rgb8> EditorProgram::screenshot() {
    window_->context().make_current();
    window_->bind_screen();
    return read_screen(*window_, window_->context().gl());
}

/// Returns the input until the next frame is due while a mesh is being opened, and goes on
/// uploading it. A wake from another thread or input other than passing pointer motion ends the
/// wait.
std::vector<InputEvent> EditorProgram::until_due() {
    std::vector<InputEvent> events;
    while (true) {
        const bool uploading = object_.uploading();
        window_->context().make_current();
        object_.upload();
        const std::vector<InputEvent> some =
            window_->poll(object_.uploading() ? 0.0 : pace_.seconds_left());
        events.insert(events.end(), some.begin(), some.end());
        const bool news = some.empty() && !object_.uploading();
        const bool ended = uploading && !object_.uploading();
        if (news || ended || !passes_by(some) || pace_.seconds_left() <= 0.0) return events;
    }
}

void EditorProgram::turn() {
    const bool busy = frames_to_draw_ > 0 || turntable_ || timeline_.playing || object_.uploading();
    const bool handled = ImGui::IsAnyMouseDown() || turntable_ || timeline_.playing;
    const std::vector<InputEvent> events =
        opening_ && !handled ? until_due() : window_->poll(busy ? 0.0 : 1.0);
    // Waking up without an event means that a background thread has news: a frame is due.
    frames_to_draw_ = events.empty() && !busy ? 1 : std::max(frames_to_draw_ - 1, 0);
    if (!events.empty()) frames_to_draw_ = 3;
    for (const std::vector<InputEvent>& some : in_frames(events)) {
        const auto began = EditPace::Clock::now();
        frame(some);
        if (opening_) window_->context().gl().Finish();
        pace_.drew(EditPace::Clock::now() - began);
        window_->present();
    }
}

void EditorProgram::run() {
    files_.watch();
    while (!closing_) turn();
    autosave_.clear();
}

void EditorProgram::settle() {
    while (files_.settle()) frame({});
    export_.wait();
    baker_.hold_errands(false);
    baker_.wait();
    do {
        frame({});
    } while (object_.uploading());
    frame({});
    posed_pick_.wait();
    if (gallery_) gallery_->wait();
    figures_.wait();
    atlas_.wait();
    window_->present();
}

void EditorProgram::play(InputScript script, const std::string& folder) {
    ScriptPlayer player(std::move(script));
    frame({});
    window_->present();
    while (!player.done() && !closing_) {
        ScriptPlayer::Frame next =
            player.next([this](const std::string& item) { return items_.find(item); });
        if (next.settle) settle();
        for (const InputEvent& event : next.events)
            if (event.kind == InputKind::resize) window_->resize(glm::ivec2(event.at));
        frame(next.events);
        if (!next.screenshot.empty() && !folder.empty())
            write_png((std::filesystem::path(folder) / (next.screenshot + ".png")).string(),
                      screenshot());
        window_->present();
    }
}

}  // namespace burl
