// The measurement that `--synth auto` goes by: who takes long is found to, and nothing of it stays.
#include "app/pipeline/measure_synthesis.h"
#include "app/recipe/edit/recipe_json.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {
namespace {

/// Takes a while, and notes what it was asked.
class Slow final : public TextureSynthesizer {
  public:
    explicit Slow(std::chrono::milliseconds pause) : pause_(pause) {}
    std::string problem(const Recipe&) const override { return ""; }
    void synthesize(const SolidAtlas& solid, const Recipe&, int, ImageToFill image) override {
        std::this_thread::sleep_for(pause_);
        ++calls;
        sizes_fit = sizes_fit && solid.size == 32 && solid.spans.size() == 32 &&
                    std::get<Image<Rgb8>*>(image)->width() == 32;
        knows_atlas = true;
    }
    void forget_atlas() override { knows_atlas = false; }
    nlohmann::ordered_json report() const override { return {}; }

    int calls = 0;
    bool sizes_fit = true, knows_atlas = false;

  private:
    std::chrono::milliseconds pause_;
};

TEST(MeasureSynthesisTest, FindsWhoTakesLonger) {
    Slow slow(std::chrono::milliseconds(60));
    const SynthesisSeconds seconds = measure_synthesis(slow, load_recipe("marble"), 32);
    EXPECT_GE(seconds.other, 0.06);
    EXPECT_GT(seconds.host, 0.0);
    EXPECT_EQ(slow.calls, 4);
    EXPECT_TRUE(slow.sizes_fit);
    EXPECT_FALSE(slow.knows_atlas);
}

}  // namespace
}  // namespace burl
