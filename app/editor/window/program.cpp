#include "app/editor/window/program.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "app/base/stopwatch.h"
#include "app/editor/panels/files.h"
#include "app/editor/session/input.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/theme.h"
#include "app/editor/widgets/widgets.h"
#include "app/editor/window/kept_view.h"
#include "app/image/image_io.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// The pointer's shape for a cursor of ImGui, whose "resize all" stands for a cross: nothing here
/// is resized in all directions.
PointerShape pointer_of(ImGuiMouseCursor cursor) {
    switch (cursor) {
        case ImGuiMouseCursor_TextInput:
            return PointerShape::text;
        case ImGuiMouseCursor_ResizeAll:
            return PointerShape::cross;
        case ImGuiMouseCursor_Hand:
            return PointerShape::hand;
        case ImGuiMouseCursor_ResizeEW:
            return PointerShape::resize_sideways;
        case ImGuiMouseCursor_ResizeNS:
            return PointerShape::resize_upright;
        case ImGuiMouseCursor_None:
            return PointerShape::none;
        default:
            return PointerShape::arrow;
    }
}

}  // namespace

EditorProgram::ImGuiOwner::ImGuiOwner() {
    IMGUI_CHECKVERSION();
    // Its own allocator does not look at what malloc returns.
    ImGui::SetAllocatorFunctions([](std::size_t bytes, void*) { return ::operator new(bytes); },
                                 [](void* memory, void*) { ::operator delete(memory); });
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
      fonts_(options.fonts),
      renderer_(window_->context().gl()),
      session_(load_recipe(options.recipe, options.settings), options.recipe),
      preference_file_(options.preferences),
      preferences_(preference_file_.stored()),
      notices_([this] { return window_->seconds(); }),
      autosave_(options.autosave),
      baker_(wake()),
      requests_(session_, baker_),
      loader_(session_, baker_, requests_, options.mesh, options.recipe, wake(), options.recent),
      commands_(session_, loader_, notices_, wake()),
      atlas_(window_->context().gl(), wake()),
      viewport_(window_->context().gl(), session_, baker_, requests_, atlas_, wake()),
      side_(window_->context(), options.gallery, wake()) {
    if (options.gallery) node_gallery_.emplace(window_->context().gl(), wake());
    if (options.preferences.empty()) preferences_.welcomed = true;  // a script knows what to do
    viewport_.light.choose(options.light);
    choose_synthesis(options.synthesis);
    scale_ = normal_scale_ = options.ui_scale * window_->text_scale();
}

void EditorProgram::take(const InputEvent& event) {
    feed(ImGui::GetIO(), event);
    if (event.kind == InputKind::text) fonts_.meet(event.text);
    if (event.kind == InputKind::drop)
        for (const std::string& file : event.files) loader_.files().open(file);
    if (event.kind == InputKind::close) {
        release_keys(ImGui::GetIO());  // of Alt+F4 the window manager keeps the rest
        commands_.quit();
    }
}

/// Takes over the results of other threads.
void EditorProgram::take_news() {
    if (loader_.take()) {
        side_.deselect();
        session_.timeline.chosen = {};
    }
    if (const auto problem = baker_.take_problem()) session_.complain(*problem);
    if (const auto problem = atlas_.take_problem()) session_.complain(*problem);
    commands_.take_outcome();
    if (const auto problem = session_.take_problem(); problem && !loader_.files().asks())
        notices_.tell(*problem, true);
    follow_mesh();
    keep();
}

/// Writes the autosave when it is due.
void EditorProgram::keep() {
    autosave_.keep(session_.history(), window_->seconds(),
                   view_text(loader_.files(), viewport_.camera));
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

bool EditorProgram::settled() const {
    return loader_.files().idle() && baker_.idle() && viewport_.idle() && atlas_.idle() &&
           !viewport_.object().uploading() && !viewport_.object().drawing() && !session_.moving();
}

void EditorProgram::frame(const std::vector<InputEvent>& events) {
    window_->context().make_current();
    ++frames_;
    times_ = {};
    const double began = thread_seconds();
    timed(times_.panels, [&] { panels(events); });
    times_.panels -= times_.object;
    times_.worked += thread_seconds() - began;
    timed(times_.screen, [&] { draw_screen(); });
    if (std::exchange(screenshot_due_, false)) take_screenshot();
}

/// Tells ImGui the size and the time of the frame that begins.
void EditorProgram::begin_frame() {
    ImGuiIO& io = ImGui::GetIO();
    const glm::ivec2 size = window_->size(), pixels = window_->pixels();
    io.DisplaySize = {float(size.x), float(size.y)};
    if (size.x > 0 && size.y > 0)
        io.DisplayFramebufferScale = {float(pixels.x) / float(size.x),
                                      float(pixels.y) / float(size.y)};
    const double now = window_->seconds();
    io.DeltaTime = float(std::clamp(now - last_seconds_, 1e-4, 0.25));
    last_seconds_ = now;
}

/// Notes the characters of all texts that come from people and files.
void EditorProgram::meet_texts() {
    const std::deque<LogLine>& log = session_.log();
    if (!log.empty() && std::exchange(met_line_, log.back().text) != log.back().text)
        for (const LogLine& line : log) fonts_.meet(line.text);
    if (const auto revision = session_.history().revision();
        std::exchange(met_revision_, revision) != revision) {
        fonts_.meet(session_.recipe().name);
        fonts_.meet(session_.recipe().about);
        for (const RecipeControl& control : session_.recipe().controls)
            fonts_.meet(control.name + control.about);
    }
    for (const std::string& name : commands_.dialog().names()) fonts_.meet(name);
}

/// Stands a mesh that was opened as it stood last, and notes how it stands now.
void EditorProgram::follow_mesh() {
    const std::string& mesh = loader_.files().mesh();
    if (mesh.empty()) return;
    std::map<std::string, std::string>& axes = preferences_.up_axes;
    if (std::exchange(seen_mesh_, mesh) != mesh) {
        const auto known = axes.find(kept_name(mesh));
        viewport_.camera.up = known == axes.end() ? UpAxis::y : up_axis_from(known->second);
    } else if (viewport_.camera.up == UpAxis::y) {
        axes.erase(kept_name(mesh));
    } else {
        axes[kept_name(mesh)] = to_text(viewport_.camera.up);
    }
}

/// Goes back to the mesh, pose and camera that a recovered recipe was seen with.
void EditorProgram::take_recovered(const std::string& view) {
    const std::optional<KeptView> kept = kept_view_from(view);
    if (!kept) return;
    loader_.open_posed(kept->mesh, kept->pose);
    viewport_.camera = kept->camera;
    seen_mesh_ = kept->mesh;
    preferences_.up_axes[kept_name(kept->mesh)] = to_text(kept->camera.up);
}

/// Follows scale, theme and characters wanted, between two frames.
void EditorProgram::follow_look() {
    meet_texts();
    const bool scaled = std::exchange(shown_scale_, scale_) != scale_;
    const bool themed = std::exchange(shown_theme_, preferences_.theme) != preferences_.theme;
    if (scaled || themed || fonts_.has_news()) {
        set_interface(scale_, preferences_.theme, fonts_);
        renderer_.upload_fonts();
        if (!fonts_.problem().empty()) session_.tell(fonts_.problem());
    }
    if (!ImGui::IsAnyMouseDown()) preference_file_.store(preferences_);
}

/// Runs a frame except for drawing the screen.
void EditorProgram::panels(const std::vector<InputEvent>& events) {
    begin_frame();
    if (recording_) {
        recording_->size = window_->size();
        append_frame(*recording_, events);
    }
    for (const InputEvent& event : events) take(event);
    take_news();
    advance(session_, double(ImGui::GetIO().DeltaTime));
    items_.clear();
    follow_look();
    const std::string new_title = title();
    if (std::exchange(shown_title_, new_title) != new_title) window_->set_title(new_title);
    viewport_.follow();
    if (graph_.shown) graph_.follow(session_);
    forget_unseen_popups();
    ImGui::NewFrame();
    allow_tiny_corners();
    shortcuts();
    layout();
    ImGui::Render();
    window_->set_pointer(pointer_of(ImGui::GetMouseCursor()));
    requests_.update(atlas_.state.shown);
    atlas_.follow(baker_.front(), requests_.last(), requests_.last_recipe());
    follow_opening();
}

/// Holds background work that can wait while a mesh is being opened and needs the processors, or
/// that waits for a light.
void EditorProgram::follow_opening() {
    const GlEditObject& object = viewport_.object();
    const bool is_seen = !object.uploading() && object.picture() == baker_.front().picture().get();
    const bool opening = !loader_.files().reading(FileKind::mesh).empty() || baker_.opening() ||
                         (opening_ && !is_seen);
    if (opening_ && !opening) rest_.ask(2);
    opening_ = opening;
    baker_.hold_jobs(opening_);
    // Balls wait for the light that they are drawn in.
    const bool held = opening_ || !viewport_.light.idle();
    side_.hold(held);
    if (node_gallery_) node_gallery_->hold(held);
}

std::string EditorProgram::title() const {
    const std::string mesh = file_name(loader_.files().mesh());
    return fmt::format("{}{} on {} - Burl", session_.recipe().name,
                       session_.history().unsaved() ? " *" : "", mesh);
}

void EditorProgram::draw_screen() {
    window_->bind_screen();
    const ImVec4 screen = style_color(palette().screen);
    const Vec3f background(screen.x, screen.y, screen.z);
    renderer_.update(*ImGui::GetDrawData(), background, viewport_.image(),
                     [this](ImTextureID texture) { return side_.lasts(texture); });
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
    GlEditObject& object = viewport_.object();
    while (true) {
        const bool uploading = object.uploading();
        window_->context().make_current();
        object.upload();
        const std::vector<InputEvent> some =
            window_->poll(object.uploading() ? 0.0 : pace_.seconds_left());
        events.insert(events.end(), some.begin(), some.end());
        const bool news = some.empty() && !object.uploading();
        const bool ended = uploading && !object.uploading();
        if (news || ended || !passes_by(some) || pace_.seconds_left() <= 0.0) return events;
    }
}

void EditorProgram::turn() {
    const bool moves = viewport_.turntable || session_.timeline.playing;
    const bool busy = moves || viewport_.object().uploading();
    const bool handled = ImGui::IsAnyMouseDown() || moves;
    const double from = window_->seconds();
    const std::vector<InputEvent> events =
        opening_ && !handled ? until_due() : window_->poll(busy ? 0.0 : rest_.patience());
    const bool news = window_->take_news() || notices_.outdated();
    const bool due = rest_.ended(!events.empty(), news, window_->seconds() - from);
    if (!due && !busy && !opening_ && viewport_.idle()) return keep();
    for (const std::vector<InputEvent>& some : in_frames(events)) {
        const auto began = EditPace::Clock::now();
        frame(some);
        if (opening_) window_->context().gl().Finish();
        pace_.drew(EditPace::Clock::now() - began);
        window_->present();
    }
}

void EditorProgram::run() {
    loader_.files().watch();
    while (!wants_to_close()) turn();
    autosave_.clear();
}

/// Runs frames until all that is there is uploaded and drawn.
void EditorProgram::show_all() {
    do {
        frame({});
    } while (viewport_.object().uploading());
    do {
        frame({});
    } while (viewport_.object().drawing());
}

void EditorProgram::settle() {
    while (loader_.files().settle()) frame({});
    commands_.wait();
    baker_.hold_jobs(false);
    baker_.wait();
    show_all();
    viewport_.wait();
    frame({});
    side_.wait();
    if (node_gallery_) node_gallery_->wait();
    atlas_.wait();
    show_all();
    window_->present();
}

void EditorProgram::play(InputScript script, const std::string& folder) {
    ScriptPlayer player(std::move(script));
    frame({});
    window_->present();
    while (!player.done() && !wants_to_close()) {
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
