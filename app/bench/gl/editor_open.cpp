#include "app/bench/gl/editor_open.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>
#include <memory>
#include <optional>

#include "app/base/stopwatch.h"
#include "app/bench/files.h"
#include "app/bench/gl/editor_window.h"
#include "app/bench/meshes.h"
#include "app/editor/window/program.h"

namespace burl {

namespace {

constexpr glm::ivec2 window_size{1280, 800};

/// The editor while it opens a mesh, with moving pointer input and a record of its frame times.
class Opening {
  public:
    explicit Opening(const std::string& file) : file_(file) {
        auto window = std::make_unique<BenchWindow>(create_osmesa_context(), window_size);
        window_ = window.get();
        editor_ = std::make_unique<EditorProgram>(std::move(window), EditorOptions{});
        while (!editor_->shown() || !editor_->settled()) editor_->turn();
        window_->on_frame([this](const BenchWindow::Frame& frame) {
            frames_.push_back(1e3 * (frame.end - frame.begin));
            panels_.push_back(1e3 * editor_->times().panels);
            thread_.push_back(1e3 * editor_->times().worked);
        });
        InputEvent drop{InputKind::drop};
        drop.files = {file_};
        drop_ = drop;
        start_ = window_->seconds();
        window_->set_hand([this](double seconds) { return hand(seconds); });
    }

    /// Runs turns until `done`; returns the seconds since the drop.
    template <class Done>
    double until(const Done& done) {
        while (!done(*editor_)) editor_->turn();
        return window_->seconds() - start_;
    }
    void turn_camera(double seconds) {
        frames_.clear();
        turns_ = true;
        const double end = window_->seconds() + seconds;
        until([&](EditorProgram&) { return window_->seconds() > end; });
    }
    double close() {
        double seconds = 0.0;
        timed(seconds, [&] { editor_.reset(); });
        return seconds;
    }

    Durations frames() const { return durations_of(frames_); }
    Durations panels() const { return durations_of(panels_); }
    Durations thread() const { return durations_of(thread_); }

  private:
    /// Returns pointer motion in a circle: over the panels, or as a drag on the object.
    std::vector<InputEvent> hand(double seconds) {
        const glm::dvec2 round(std::cos(3.0 * seconds), std::sin(3.0 * seconds));
        const glm::dvec2 middle = turns_ ? glm::dvec2(400, 400) : glm::dvec2(1050, 400);
        std::vector<InputEvent> events{{InputKind::move, middle + 100.0 * round}};
        if (drop_) events.push_back(*std::exchange(drop_, std::nullopt));
        if (turns_ && !pressed_) {
            pressed_ = true;
            events.push_back({InputKind::button});
            events.back().down = true;
        }
        return events;
    }

    std::string file_;
    BenchWindow* window_ = nullptr;
    std::unique_ptr<EditorProgram> editor_;
    std::optional<InputEvent> drop_;
    double start_ = 0.0;
    bool turns_ = false, pressed_ = false;
    std::vector<double> frames_, panels_, thread_;
};

}  // namespace

OpenBench bench_open(std::size_t faces) {
    const BenchFolder folder;
    OpenBench bench;
    const std::string file = folder.path / "sphere.ply";
    {
        const Mesh mesh = bumpy_sphere(faces);
        bench.faces = mesh.triangles.size();
        write_bench_ply(file, mesh);
    }
    const auto read = [&](EditorProgram& editor) { return editor.files().mesh() == file; };
    const auto shown = [&](EditorProgram& editor) {
        const auto surface = editor.baker().front().surface();
        return surface->triangles == bench.faces && editor.shown() &&
               editor.shown()->surface == surface->number;
    };
    const auto finest = [&](EditorProgram& editor) {
        return shown(editor) && editor.shown()->level == 0;
    };
    const auto smooth = [&](EditorProgram& editor) {
        return finest(editor) && editor.shown_smooth();
    };
    const auto patches = [&](EditorProgram& editor) {
        return finest(editor) && editor.baker().front().surface()->atlas == "patch";
    };
    {
        Opening opening(file);
        const std::clock_t began = std::clock();
        bench.read = opening.until(read);
        bench.shown = opening.until(shown);
        bench.worked = double(std::clock() - began) / CLOCKS_PER_SEC;
        bench.finest = opening.until(finest);
        bench.smooth = opening.until(smooth);
        bench.patches = opening.until(patches);
        bench.frame = opening.frames();
        bench.panels = opening.panels();
        bench.thread = opening.thread();
        opening.turn_camera(2.0);
        bench.turning = opening.frames();
    }
    Opening opening(file);
    opening.until(finest);
    bench.closing = opening.close();
    return bench;
}

Json open_bench_json(const OpenBench& bench) {
    const auto json = [](const Durations& d) {
        return Json{{"median", d.median}, {"p95", d.p95}, {"longest", d.longest}};
    };
    return {{"faces", bench.faces},
            {"read_seconds", bench.read},
            {"shown_seconds", bench.shown},
            {"shown_processor_seconds", bench.worked},
            {"finest_seconds", bench.finest},
            {"smooth_seconds", bench.smooth},
            {"patches_seconds", bench.patches},
            {"frame_ms", json(bench.frame)},
            {"panels_ms", json(bench.panels)},
            {"thread_ms", json(bench.thread)},
            {"turning_ms", json(bench.turning)},
            {"closing_seconds", bench.closing}};
}

std::string open_bench_table(const OpenBench& bench) {
    const auto row = [](const Durations& d) {
        return fmt::format("{:.1f} ({:.1f}, longest {:.1f}) ms", d.median, d.p95, d.longest);
    };
    return fmt::format(
        "{} faces\n  read                  {:.2f} s\n  first picture         {:.2f} s ({:.2f} s of "
        "processors)\n"
        "  finest level          {:.2f} s, smooth {:.2f} s\n  patches               {:.2f} s\n"
        "  frames, median (p95)  {}\n  panels alone          {}\n  worked, drawing aside {}\n  "
        "while turning         {}\n"
        "  closing meanwhile     {:.2f} s\n",
        bench.faces, bench.read, bench.shown, bench.worked, bench.finest, bench.smooth,
        bench.patches, row(bench.frame), row(bench.panels), row(bench.thread), row(bench.turning),
        bench.closing);
}

}  // namespace burl
