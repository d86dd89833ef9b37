// Peak memory of whole bakes: what a texel more takes, of all channels of a material together.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "tests/app/programs/run_program.h"
#include "tests/app/support/kept_samples.h"
#include "tests/app/support/material_recipes.h"

namespace burl::test {
namespace {

/// The peak of resident memory in bytes of a bake with these arguments by two threads. Negative
/// where it fails.
double peak_of_bake(const std::vector<std::string>& arguments) {
    const std::string program = binary_folder() + std::string("/bin/burl");
    std::vector<const char*> words{program.c_str(), "bake", "-j", "2", "-q"};
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
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

/// The bytes of a texel more of a bake to `file` in the scratch folder.
double bytes_of_texel(const Scratch& scratch, std::vector<std::string> arguments,
                      const std::string& file, const std::string& levels) {
    arguments.insert(arguments.end(), {"-o", scratch / file, "-s", "256"});
    if (!levels.empty()) arguments.insert(arguments.begin(), {"--levels", levels});
    const double least = peak_of_bake(arguments);
    arguments.back() = "2048";
    const double peak = peak_of_bake(arguments);
    EXPECT_GT(least, 0.0);
    EXPECT_GT(peak, least);
    return (peak - least) / (2048.0 * 2048 - 256.0 * 256);
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
    EXPECT_LT(bytes_of_texel(scratch, {"sample:torus", "-r", recipe}, file, levels), most);
}

INSTANTIATE_TEST_SUITE_P(Bakes, MaterialMemory,
                         testing::Values(MemoryCase{"a.png", "", 40},
                                         MemoryCase{"b.png", "all", 80},
                                         MemoryCase{"c.exr", "", 30},
                                         MemoryCase{"d.exr", "all", 50}));

/// Eight pictures and a normal map, as floats of four components 128 bytes a texel, twice where a
/// recipe's own were beside all.
TEST(SharedMemory, IsThatOfOneRecipeAndTheNormals) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's own memory counts";
#endif
    const Scratch scratch;
    const std::string recipe = scratch.write("all.json", all_channels);
    const std::string mesh = scratch.write("two.gltf", kept_samples().at("two_materials"));
    const std::vector<std::string> arguments{mesh, "--assign", "Wood*=" + recipe, "--assign",
                                             "Metal=oak"};
    EXPECT_LT(bytes_of_texel(scratch, arguments, "a.glb", "all"), 115.0);
    EXPECT_LT(bytes_of_texel(scratch, arguments, "b.glb", ""), 70.0);
}

}  // namespace
}  // namespace burl::test
