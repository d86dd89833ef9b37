// The processor time of a mesh's layouts on one thread, by turns with a kernel that never changes:
//   layout_times MESH ROUNDS KIND...
// prints {"KIND": {"ms": MEDIAN, "kernels": MEDIAN}}, the second in times of the kernel.
#include <algorithm>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "atlas/base/error.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/read/read_mesh.h"
#include "tests/quality/reference_kernel.h"

namespace burl {
namespace {

volatile double kept_result = 0.0;

/// Milliseconds of processor time that `work` takes.
template <class Work>
double milliseconds(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return 1e3 * double(std::clock() - start) / double(CLOCKS_PER_SEC);
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// The mean time of `runs` runs.
template <class Work>
double mean_milliseconds(int runs, const Work& work) {
    return milliseconds([&] {
               for (int run = 0; run < runs; ++run) work();
           }) /
           runs;
}

/// A layout's part of the answer. Within a round, layouts that take less than the kernel are
/// repeated until they take as long, and the kernel until it takes a tenth of the layout's time. A
/// layout of seconds has three rounds.
std::string timed(const Mesh& mesh, const Connectivity& connectivity, AtlasKind kind, int rounds) {
    AtlasOptions options;
    options.kind = kind;
    const auto lay_out = [&] { build_atlas(mesh, connectivity, options); };
    const auto kernel = [] { kept_result = kept_result + test::reference_kernel(); };
    const double share = milliseconds(lay_out) / milliseconds(kernel);
    const int runs = 1 + int(1.0 / std::max(0.005, share)), kernels = 1 + int(0.1 * share);
    if (share > 40.0) rounds = std::min(rounds, 3);
    std::vector<double> times, ratios;
    double before = mean_milliseconds(kernels, kernel);
    for (int round = 0; round < rounds; ++round) {
        const double taken = mean_milliseconds(runs, lay_out);
        const double after = mean_milliseconds(kernels, kernel);
        times.push_back(taken);
        ratios.push_back(taken / (0.5 * (before + after)));
        before = after;
    }
    return fmt::format("\"{}\": {{\"ms\": {:.3f}, \"kernels\": {:.4f}}}", to_string(kind),
                       median(times), median(ratios));
}

int run(const std::vector<std::string>& arguments) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Mesh mesh = read_mesh(arguments.at(0));
    const Connectivity connectivity = build_connectivity(mesh);
    std::string lines;
    for (std::size_t i = 2; i < arguments.size(); ++i)
        lines += (lines.empty() ? "" : ", ") + timed(mesh, connectivity,
                                                     enum_named<AtlasKind>(arguments[i]).value(),
                                                     std::stoi(arguments[1]));
    std::cout << "{" << lines << "}\n";
    return 0;
}

}  // namespace
}  // namespace burl

int main(int count, char** values) {
    try {
        return burl::run({values + 1, values + count});
    } catch (const std::exception& error) {
        std::cerr << "layout_times: " << error.what() << "\n";
        return 1;
    }
}
