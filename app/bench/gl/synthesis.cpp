#include "app/bench/gl/synthesis.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "app/bench/synthesis.h"
#include "app/gl/fill/block_levels.h"
#include "app/gl/fill/multipass.h"
#include "app/gl/fill/synthesize.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

using Clock = std::chrono::steady_clock;

/// Returns the median without the first value, the warm-up round.
double median(std::vector<double> values) {
    if (values.size() < 2) return 0.0;
    const auto begin = values.begin() + 1, middle = begin + (values.end() - begin) / 2;
    std::nth_element(begin, middle, values.end());
    return *middle;
}

/// A texture to draw; errors are taken on every step-th row.
struct GlSubject {
    std::shared_ptr<Pipeline> pipeline;
    std::uint32_t octaves = 0, side = 0, step = 1;
    std::string group{};
};

GlSubject make_subject(std::uint32_t octaves, std::uint32_t side) {
    GlSubject subject{std::make_shared<Pipeline>(torus(6000)), octaves, side};
    subject.pipeline->set_recipe(
        load_recipe("marble", {fmt::format("atlas.size={}", side),
                               fmt::format("texture.input.noise.0.octaves={}", octaves)}));
    subject.pipeline->solid();
    const std::uint64_t texels = std::uint64_t(side) * side;
    subject.step = std::uint32_t(std::max<std::uint64_t>(1, texels >> 20));
    subject.group =
        fmt::format("{} octave{}, {} x {}", octaves, octaves == 1 ? "" : "s", side, side);
    return subject;
}

/// A method of making the subject's texture.
class Way {
  public:
    explicit Way(std::string text) : name(std::move(text)) {}
    Way(const Way&) = delete;
    Way& operator=(const Way&) = delete;
    virtual ~Way() = default;
    /// Makes the texture as 8-bit sRGB in host memory.
    virtual void run() = 0;
    /// Returns colours in linear light of every step-th row; empty for a method whose noise differs
    /// from the definition.
    virtual std::vector<double> colors() = 0;
    virtual void describe(GlBench&) const {}

    const std::string name;
};

class HostSynthesis final : public Way {
  public:
    HostSynthesis(const GlSubject& subject, int threads)
        : Way(threads == 1 ? "host, 1 thread" : "host, all threads"),
          subject_(subject),
          threads_(threads) {}
    void run() override {
        subject_.pipeline->set_threads(threads_);
        image_ = subject_.pipeline->synthesize<Rgb8>();
    }
    std::vector<double> colors() override {
        return color_values(subject_.pipeline->solid(), subject_.pipeline->synthesize<RgbF>(),
                            subject_.step);
    }

  private:
    GlSubject subject_;
    int threads_;
    Image<Rgb8> image_;
};

/// A texture made by GlSynthesis or a class with its interface, in an OpenGL context of its own.
template <class Synthesis>
class GlWay final : public Way {
  public:
    /// Creates the context and, by make(GlContext&), the Synthesis, and draws the first picture.
    template <class Make>
    GlWay(const std::string& text, const GlSubject& subject, const std::string& platform,
          const Make& make, bool is_defined = true)
        : Way(text), subject_(subject), is_defined_(is_defined) {
        const auto start = Clock::now();
        context_ = create_gl_context(platform);
        cold_.context = seconds_since(start);
        synthesis_.emplace(make(*context_));
        draw(image_);
        cold_.total = seconds_since(start);
        const GlWork& work = synthesis_->work();
        cold_.compile = work.compile, cold_.maps = work.map, cold_.draw = work.draw;
    }
    /// Makes the context current in which the members are destroyed.
    ~GlWay() override { context_->make_current(); }
    void run() override {
        draw(image_);
        const GlWork& work = synthesis_->work();
        gpu_.push_back(work.gpu), draw_.push_back(work.draw), transfer_.push_back(work.transfer);
    }
    std::vector<double> colors() override {
        if (!is_defined_) return {};
        Image<RgbF> image;
        draw(image);
        return color_values(subject_.pipeline->solid(), image, subject_.step);
    }
    void describe(GlBench& row) const override {
        row.passes = synthesis_->work().passes;
        row.parts = {median(gpu_), median(draw_), median(transfer_)};
        row.cold = cold_;
    }

  private:
    template <class Pixel>
    void draw(Image<Pixel>& image) {
        const Recipe& recipe = subject_.pipeline->recipe();
        synthesis_->synthesize(subject_.pipeline->solid(), *plain_texture(recipe.texture),
                               texture_from_solid(recipe), 0, image);
    }

    GlSubject subject_;
    bool is_defined_;
    std::unique_ptr<GlContext> context_;
    std::optional<Synthesis> synthesis_;
    GlColdStart cold_;
    std::vector<double> gpu_, draw_, transfer_;
    Image<Rgb8> image_;
};

using Ways = std::vector<std::shared_ptr<Way>>;

struct Passes {
    const char* name;
    PassPrecision precision;
    Randomizer randomizer;
};

/// The papers' multi-pass methods at every precision, and for 4 octaves with their own random
/// numbers, which differ from the definition's. The one by bits has thousands of passes and is
/// measured for small textures only.
std::vector<Passes> passes_of(const GlSubject& subject) {
    std::vector<Passes> passes{{"multipass 32f", PassPrecision::float32, Randomizer::hash},
                               {"multipass 16f", PassPrecision::float16, Randomizer::hash},
                               {"multipass 8", PassPrecision::fixed8, Randomizer::hash}};
    if (subject.octaves == 4 && subject.side <= 512) {
        passes.push_back({"multipass 32f, table", PassPrecision::float32, Randomizer::table});
        passes.push_back({"multipass 8, bits", PassPrecision::fixed8, Randomizer::bits});
    }
    return passes;
}

Ways ways_of(const GlSubject& subject, const std::string& platform) {
    Ways ways;
    for (const int threads : {1, 0})
        ways.push_back(std::make_shared<HostSynthesis>(subject, threads));
    for (const bool float64 : {true, false})
        ways.push_back(
            std::make_shared<GlWay<GlSynthesis>>(float64 ? "single pass" : "single pass, float32",
                                                 subject, platform, [&](GlContext& context) {
                                                     GlSynthesisLimits limits;
                                                     limits.float64 = float64;
                                                     return GlSynthesis(context, limits);
                                                 }));
    for (const Passes& passes : passes_of(subject))
        ways.push_back(std::make_shared<GlWay<GlMultipassSynthesis>>(
            passes.name, subject, platform,
            [&](GlContext& context) {
                return GlMultipassSynthesis(context, {passes.precision, passes.randomizer});
            },
            passes.randomizer == Randomizer::hash));
    return ways;
}

std::vector<GlBench> bench_subject(const GlSubject& subject, const std::string& platform,
                                   int repeats) {
    const Ways ways = ways_of(subject, platform);
    std::vector<BenchCase> cases;
    const double texels = double(subject.side) * subject.side;
    for (const auto& way : ways)
        cases.push_back({way->name, texels, "texel", [way] { way->run(); }, subject.group});
    const std::vector<BenchRow> times = run_paired(cases, repeats);
    const std::vector<double> reference =
        defined_colors(subject.pipeline->solid(), subject.pipeline->recipe(), subject.step);
    std::vector<GlBench> rows;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        GlBench row{{times[i]}, subject.octaves, subject.side};
        const std::vector<double> colors = ways[i]->colors();
        if (!colors.empty()) row.result.error = BenchError::of(colors, reference);
        ways[i]->describe(row);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<double> values_of(const std::vector<Image<RgbF>>& levels) {
    std::vector<double> values;
    for (const Image<RgbF>& level : levels)
        for (const RgbF& c : level.pixels()) values.insert(values.end(), {c.r, c.g, c.b});
    return values;
}

/// Measures all MIP levels of a texture, uploaded and read back, with errors against the host's.
std::vector<GlBench> bench_levels(const GlSubject& subject, const std::string& platform,
                                  int repeats) {
    Pipeline& pipeline = *subject.pipeline;
    const Image<RgbF> texture = pipeline.synthesize<RgbF>();
    const auto context = create_gl_context(platform);
    const GlBlockLevels draw(*context, pipeline.mesh_atlas());
    std::vector<Image<RgbF>> host, drawn;
    const std::string group = fmt::format("all levels of {} x {}", subject.side, subject.side);
    const double texels = double(subject.side) * subject.side;
    const std::vector<BenchCase> cases{
        {"levels, host", texels, "texel",
         [&] { host = block_levels(pipeline.mesh_atlas(), texture, 99); }, group},
        {"levels, OpenGL", texels, "texel", [&] { drawn = draw(texture, 99); }, group}};
    const std::vector<BenchRow> times = run_paired(cases, repeats);
    const std::vector<double> reference = values_of(host);
    GlBench on_gl{{times[1], BenchError::of(values_of(drawn), reference)}, 0, subject.side};
    on_gl.passes = int(drawn.size());
    return {{{times[0]}, 0, subject.side}, on_gl};
}

void append(std::vector<GlBench> rows, std::vector<GlBench>& all) {
    std::ranges::move(rows, std::back_inserter(all));
}

Json gl_json(const GlBench& row) {
    Json json = result_json(row.result);
    json.update(Json{{"octaves", row.octaves},
                     {"size", row.side},
                     {"passes", row.passes},
                     {"gpu_ms", row.parts.gpu * 1e3},
                     {"draw_ms", row.parts.draw * 1e3},
                     {"transfer_ms", row.parts.transfer * 1e3},
                     {"cold_ms",
                      {{"context", row.cold.context * 1e3},
                       {"compile", row.cold.compile * 1e3},
                       {"maps", row.cold.maps * 1e3},
                       {"draw", row.cold.draw * 1e3},
                       {"total", row.cold.total * 1e3}}}});
    return json;
}

void print_gl(const GlBenchReport& report) {
    fmt::print("{}\n", report.opengl);
    std::string group;
    for (const GlBench& row : report.rows) {
        const BenchRow& time = row.result.time;
        if (group != time.group)
            fmt::print("\n{:<26} {:>9} {:>8} {:>6} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>9}\n",
                       time.group, "ms", "ns/texel", "passes", "GPU ms", "draw", "transfer",
                       "cold ms", "(compile)", "max error", "RMS");
        group = time.group;
        fmt::print("{:<26} {:>9.2f} {:>8.2f}", time.name, time.median * 1e3, time.ns_per_unit());
        fmt::print(" {:>6}", row.passes > 0 ? std::to_string(row.passes) : "");
        if (row.cold.total > 0.0)
            fmt::print(" {:>8.2f} {:>8.2f} {:>8.2f} {:>9.1f} {:>9.1f}", row.parts.gpu * 1e3,
                       row.parts.draw * 1e3, row.parts.transfer * 1e3, row.cold.total * 1e3,
                       row.cold.compile * 1e3);
        else
            fmt::print("{:>46}", "");
        if (row.result.error)
            fmt::print(" {:>9.3g} {:>9.3g}", row.result.error->max, row.result.error->rms);
        fmt::print("\n");
    }
}

}  // namespace

GlBenchReport bench_gl(const std::string& platform, int repeats, const GlBenchSubjects& subjects) {
    GlBenchReport report{create_gl_context(platform)->description(), {}};
    for (const std::uint32_t side : subjects.sides) {
        for (const std::uint32_t octaves : subjects.octaves)
            append(bench_subject(make_subject(octaves, side), platform, repeats), report.rows);
        append(bench_levels(make_subject(1, side), platform, repeats), report.rows);
    }
    return report;
}

void run_gl_bench(const BenchCommand& command) {
    GlBenchSubjects subjects;
    if (command.size > 0) subjects.sides = {std::uint32_t(command.size)};
    const GlBenchReport report = bench_gl(command.gl, command.repeats, subjects);
    const auto to_json = [&](const GlBench& row) {
        Json json = gl_json(row);
        json["opengl"] = report.opengl;
        return json;
    };
    if (report_rows(command, report.rows, to_json)) print_gl(report);
}

}  // namespace burl
