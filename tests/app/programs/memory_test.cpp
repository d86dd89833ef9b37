// Peak memory of whole bakes: what a texel more takes, of all channels of a material together.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/app/programs/run_program.h"
#include "tests/app/support/material_recipes.h"

namespace burl::test {
namespace {

/// The peak of resident memory in bytes of a bake of the torus by two threads; the folder of `path`
/// is the scratch one. Negative where it fails.
double peak_of_bake(const Scratch& scratch, const std::string& recipe, int size,
                    const std::string& file, const std::string& levels) {
    const std::string program = binary_folder() + std::string("/bin/burl");
    const std::string out = scratch / file, side = std::to_string(size);
    std::vector<const char*> words{program.c_str(),
                                   "bake",
                                   "sample:torus",
                                   "-r",
                                   recipe.c_str(),
                                   "-s",
                                   side.c_str(),
                                   "-o",
                                   out.c_str(),
                                   "-j",
                                   "2",
                                   "-q",
                                   "--levels",
                                   levels.c_str()};
    if (levels.empty()) words.resize(words.size() - 2);
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        execv(program.c_str(), const_cast<char* const*>(words.data()));
        _exit(127);
    }
    int status = 0;
    rusage used{};
    if (child < 0 || wait4(child, &status, 0, &used) != child || status != 0) return -1.0;
#ifdef __APPLE__
    return double(used.ru_maxrss);
#else
    return 1024.0 * double(used.ru_maxrss);
#endif
}

struct MemoryCase {
    const char* file;
    const char* levels;
    double most;  ///< bytes of a texel
};

class MaterialMemory : public testing::TestWithParam<MemoryCase> {};

/// Twelve pictures and a normal map, whose codes are 21 bytes a texel. As floats of four components
/// the twelve would be 192.
TEST_P(MaterialMemory, IsAFewTensOfBytesATexel) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's own memory counts";
#endif
    const Scratch scratch;
    const std::string recipe = scratch.write("all.json", all_channels);
    const auto [file, levels, most] = GetParam();
    const double least = peak_of_bake(scratch, recipe, 256, file, levels);
    const double peak = peak_of_bake(scratch, recipe, 2048, file, levels);
    ASSERT_GT(least, 0.0);
    ASSERT_GT(peak, 0.0);
    EXPECT_LT((peak - least) / (2048.0 * 2048 - 256.0 * 256), most);
}

INSTANTIATE_TEST_SUITE_P(Bakes, MaterialMemory,
                         testing::Values(MemoryCase{"a.png", "", 40},
                                         MemoryCase{"b.png", "all", 80},
                                         MemoryCase{"c.exr", "", 30},
                                         MemoryCase{"d.exr", "all", 50}));

}  // namespace
}  // namespace burl::test
