// Batches of a matrix, in shards, side by side, and killed: the files are always those of single
// bakes.
#include <algorithm>
#include <map>

#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

class BatchMatrixRun : public testing::Test {
  protected:
    const Scratch scratch;

    BatchMatrixRun() {
        for (const char* name : {"a", "b", "c"})
            scratch.write(
                fmt::format("{}.obj", name),
                fmt::format("# {}\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", name));
    }
    /// Twelve bakes into a folder.
    Outcome run(const std::string& folder, const std::string& options = "",
                const std::string& prefix = "") const {
        const std::string here = scratch.path().string();
        return run_burl(
            scratch,
            fmt::format("batch '{}/?.obj' -r marble -r oak --size 32 --size 64 "
                        "--with levels=all -o '{}/{}/{{mesh}}_{{recipe}}_{{size}}.glb' {}",
                        here, here, folder, options),
            prefix);
    }
    std::map<std::string, std::string> files_in(const std::string& folder) const {
        std::map<std::string, std::string> files;
        if (!fs::exists(scratch / folder)) return files;
        for (const auto& file : fs::directory_iterator(scratch / folder))
            if (file.path().extension() == ".glb")
                files[file.path().filename()] = slurp(file.path());
        return files;
    }
};

TEST_F(BatchMatrixRun, WritesEveryCombinationAsSingleBakesDo) {
    const Outcome outcome = run("all");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto made = files_in("all");
    ASSERT_EQ(made.size(), 12u);
    const std::string single = scratch / "single.glb";
    for (const char* recipe : {"marble", "oak"}) {
        const std::string command = fmt::format("bake '{}' -r {} --size 64 --levels all -o '{}'",
                                                scratch / "b.obj", recipe, single);
        ASSERT_EQ(run_burl(scratch, command).exit_code, 0) << command;
        EXPECT_EQ(made.at(fmt::format("b_{}_64.glb", recipe)), slurp(single));
    }
}

TEST_F(BatchMatrixRun, AMeshThatIsNoneIsOneSentence) {
    const std::string a = scratch / "a.obj", out = scratch / "{mesh}_{recipe}.glb";
    const auto refused = [&](const std::string& what) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("batch '{}' {} -o '{}' --dry-run", a, what, out));
        expect_one_sentence(outcome.err);
        return outcome;
    };
    const Outcome recipe = refused("-r oak gold");
    EXPECT_EQ(recipe.exit_code, 1);
    EXPECT_NE(recipe.err.find("gold is a recipe"), std::string::npos) << recipe.err;
    EXPECT_EQ(refused("nothing.obj -r oak").exit_code, 2);
}

TEST_F(BatchMatrixRun, ShardsAndWorkersGiveTheSameBytes) {
    ASSERT_EQ(run("all", "--jobs 1").exit_code, 0);
    ASSERT_EQ(run("three", "--jobs 4").exit_code, 0);
    const auto all = files_in("all");
    EXPECT_EQ(files_in("three"), all);
    for (const int shards : {3, 10, 100}) {
        const std::string folder = fmt::format("of{}", shards);
        for (int i = 1; i <= std::min(shards, 20); ++i) {
            const Outcome outcome = run(folder, fmt::format("--shard {}/{}", i, shards));
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        }
        for (const auto& [name, bytes] : files_in(folder)) EXPECT_EQ(bytes, all.at(name)) << name;
        EXPECT_TRUE(shards > 20 || files_in(folder).size() == all.size()) << shards;
    }
}

TEST_F(BatchMatrixRun, ADryRunSaysWhatIsToDoAndDoesNothing) {
    const Outcome planned = run("all", "--dry-run");
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
    EXPECT_FALSE(fs::exists(scratch / "all"));
    EXPECT_NE(planned.out.find("c_oak_64.glb: planned"), std::string::npos) << planned.out;
    ASSERT_EQ(run("all", "--shard 1/2").exit_code, 0);
    const Outcome rest = run("all", "--dry-run");
    EXPECT_NE(rest.out.find("a_oak_64.glb: up to date"), std::string::npos) << rest.out;
    EXPECT_NE(rest.out.find("c_oak_64.glb: planned"), std::string::npos) << rest.out;
}

TEST_F(BatchMatrixRun, KilledAndRunAgainItEndsWithTheSameBytes) {
    ASSERT_EQ(run("whole").exit_code, 0);
    for (int time = 1; time <= 3; ++time) {
        run("killed", "", fmt::format("timeout -s KILL {}", 0.07 * time));
        for (const auto& [name, bytes] : files_in("killed"))
            EXPECT_EQ(bytes, files_in("whole").at(name)) << name;
    }
    ASSERT_EQ(run("killed").exit_code, 0);
    EXPECT_EQ(files_in("killed"), files_in("whole"));
}

TEST_F(BatchMatrixRun, ReadsAManifestFromStdin) {
    const std::string manifest =
        scratch.write("m.json", fmt::format(R"({{"bakes": [{{"mesh": "{0}/a.obj", "size": [32, 64],
                                "output": "{0}/x{{size}}.png"}}]}})",
                                            scratch.path().string()));
    // The comment takes the program's usual stdin away.
    const Outcome outcome = run_burl(scratch, fmt::format("batch - --quiet <'{}' #", manifest));
    ASSERT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(fs::exists(scratch / "x32.png"));
    EXPECT_TRUE(fs::exists(scratch / "x64.png"));
}

TEST_F(BatchMatrixRun, WrongPartsAndSizesAreRefused) {
    for (const char* options : {"--shard 0/3", "--shard 4/3", "--shard 3", "--shard a/b",
                                "--memory lots", "--with nonsense=1"}) {
        EXPECT_EQ(run("all", options).exit_code, 1) << options;
        EXPECT_FALSE(fs::exists(scratch / "all")) << options;
    }
    for (const char* mistake : {"'none*.obj' -o '{mesh}.glb'", "sample:cube -o '{mehs}.glb'"})
        EXPECT_EQ(run_burl(scratch, fmt::format("batch -r oak {}", mistake)).exit_code, 1);
}

}  // namespace
}  // namespace burl::test
