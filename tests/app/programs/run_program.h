#pragma once
// Runs the built programs as a shell would and keeps their output, for tests of whole commands.
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "tests/paths.h"

namespace burl::test {

namespace fs = std::filesystem;

/// The exit code and the output of a program.
struct Outcome {
    int exit_code = -1;  ///< 128 + signal when the program was killed
    std::string out, err;
};

inline std::string slurp(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A folder of the running test's own, empty at the start and removed at the end.
class Scratch {
  public:
    Scratch() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = fmt::format("{}.{}", info->test_suite_name(), info->name());
        for (char& c : name) c = c == '/' ? '-' : c;
        path_ = fs::path(test::binary_folder()) / "scratch" / name;
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    const fs::path& path() const { return path_; }
    std::string write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return *this / name;
    }
    std::size_t files() const {
        return std::size_t(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
    }

  private:
    fs::path path_;
};

/// Runs `PROGRAM ARGUMENTS`, one of the built programs, after `prefix`, shell text such as "ulimit
/// -f 1;".
inline Outcome run_program(const Scratch& scratch, const std::string& program,
                           const std::string& arguments, const std::string& prefix = "") {
    const std::string out = scratch / "stdout.txt", err = scratch / "stderr.txt";
    const std::string command = fmt::format("{} '{}/bin/{}' {} >'{}' 2>'{}' </dev/null", prefix,
                                            test::binary_folder(), program, arguments, out, err);
    const int status = std::system(command.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), slurp(out),
                    slurp(err)};
    fs::remove(out);
    fs::remove(err);
    return outcome;
}

inline Outcome run_burl(const Scratch& scratch, const std::string& arguments,
                        const std::string& prefix = "") {
    return run_program(scratch, "burl", arguments, prefix);
}

/// Expects one line that begins with the program's name.
inline void expect_one_sentence(const std::string& text) {
    EXPECT_TRUE(text.starts_with("burl: ")) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_GT(text.size(), 20u) << text;
}

}  // namespace burl::test
