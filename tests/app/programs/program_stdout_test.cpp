// What the program does where its results cannot be written, or are read while it runs.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>
#include <vector>

#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

/// `burl` running beside the test, its stdout being a file descriptor of ours.
class RunningBurl {
  public:
    RunningBurl(std::vector<std::string> words, int out, const std::string& err_path) {
        words.insert(words.begin(), test::binary_folder() + "/bin/burl");
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_path.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
        EXPECT_EQ(
            posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ), 0);
        posix_spawn_file_actions_destroy(&actions);
    }
    void kill() const { ::kill(process_, SIGKILL); }
    /// Waits for its end.
    int status() const {
        int status = 0;
        EXPECT_EQ(waitpid(process_, &status, 0), process_);
        return status;
    }

  private:
    pid_t process_ = -1;
};

const char* const two_points = "0,0,0\n0.1,0.2,0.3\n";

/// How the program ends whose stdout nobody reads.
int status_without_reader(const std::vector<std::string>& words, const std::string& err_path) {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe(ends.data()), 0);
    close(ends[0]);
    const int status = RunningBurl(words, ends[1], err_path).status();
    close(ends[1]);
    return status;
}

TEST(ProgramStdout, ABatchGoesOnToItsReportWhereItsReaderHasGone) {
    const Scratch scratch;
    const std::string manifest = scratch.write("m.json", R"({"defaults": {"size": 16}, "bakes": [
        {"mesh": "sample:cube", "output": "a.png"}, {"mesh": "sample:cube", "output": "b.png"}]})");
    const int status = status_without_reader(
        {"batch", manifest, "--report", scratch / "report.json"}, scratch / "err.txt");
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGPIPE) << status;
    EXPECT_TRUE(fs::exists(scratch / "b.png"));
    EXPECT_NE(slurp(scratch / "report.json").find("\"written\": 2"), std::string::npos);
}

TEST(ProgramStdout, EndsQuietlyWhereItsReaderHasGone) {
    const Scratch scratch;
    const std::string points = scratch.write("p.csv", two_points);
    const std::vector<std::string> lines[] = {
        {"list", "parameters"},
        {"list", "recipes", "--json"},
        {"--help"},
        {"bake", "--help"},
        {"--version"},
        {"eval", "marble", "--points", points},
        {"metrics", "sample:cube", "--size", "64"},
        {"figures", "--commands"},
        {"bake", "sample:cube", "-o", scratch / "a.png", "--size", "64"}};
    for (const auto& words : lines) {
        const int status = status_without_reader(words, scratch / "err.txt");
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGPIPE) << words[0] << status;
        EXPECT_EQ(slurp(scratch / "err.txt"), "") << words[0];
    }
    EXPECT_TRUE(fs::exists(scratch / "a.png"));
}

TEST(ProgramStdout, IsAnErrorWhereItIsFull) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    const Scratch scratch;
    const std::string points = scratch.write("p.csv", two_points), mesh = "sample:cube";
    const std::string manifest = scratch.write(
        "m.json", R"({"bakes": [{"mesh": "sample:cube", "output": "b.png", "size": 64}]})");
    const std::string picture = scratch / "a.png", other = scratch / "c.png";
    const auto bake = [&](const std::string& path, const char* recipe) {
        ASSERT_EQ(
            run_burl(scratch, fmt::format("bake {} -o '{}' --size 64 -r {}", mesh, path, recipe))
                .exit_code,
            0);
    };
    bake(picture, "marble");
    bake(other, "wood");
    const std::string lines[] = {
        fmt::format("bake {} -o '{}' --size 64 --force", mesh, picture),
        fmt::format("bake {} -o '{}' --size 64 --json", mesh, picture),
        fmt::format("batch '{}'", manifest),
        fmt::format("diff '{0}' '{0}'", picture),
        fmt::format("diff '{}' '{}'", picture, other),  // 7 where it can be told
        fmt::format("metrics {} --size 64", mesh),
        "bench mesh_io --repeats 1 --size 12",
        fmt::format("eval marble --points '{}'", points),
        fmt::format("eval marble --points '{}' --json", points),
        fmt::format("figures -o '{}' --only fire", scratch / "f"),
        "figures --commands",
        "list recipes",
        "list parameters --json",
        "--help",
        "--version",
        "render --help"};
    for (const std::string& line : lines) {
        const int status = std::system(fmt::format("'{}/bin/burl' {} >/dev/full 2>'{}' </dev/null",
                                                   test::binary_folder(), line, scratch / "e.txt")
                                           .c_str());
        EXPECT_EQ(WEXITSTATUS(status), 2) << line;
        const std::string err = slurp(scratch / "e.txt");
        expect_one_sentence(err);
        EXPECT_NE(err.find("cannot be written to stdout"), std::string::npos) << line;
    }
}

TEST(ProgramStdout, HasTheLineOfABakeWhileTheNextOneRuns) {
    const Scratch scratch;
    const std::string manifest = scratch.write("m.json", R"({"bakes": [
        {"mesh": "sample:cube", "output": "quick.png", "size": 16},
        {"mesh": "sample:teapot", "output": "slow.png", "size": 4096, "filter": "supersample:1024"}
    ]})");
    const std::string out = scratch / "out.txt";
    const int file = open(out.c_str(), O_WRONLY | O_CREAT, 0600);
    const RunningBurl batch({"batch", manifest}, file, scratch / "err.txt");
    close(file);
    for (int i = 0; i < 400 && slurp(out).empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    batch.kill();
    EXPECT_TRUE(WIFSIGNALED(batch.status()));
    EXPECT_NE(slurp(out).find("quick.png: written"), std::string::npos) << slurp(out);
    EXPECT_FALSE(fs::exists(scratch / "slow.png"));
}

}  // namespace
}  // namespace burl::test
