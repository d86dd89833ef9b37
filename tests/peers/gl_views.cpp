// Errors of sampled views (`burl metrics --levels`) by OpenGL's own samplers, beside ours:
//   gl_views osmesa|egl SIZE [average|sharp|KIND:FILE]...
// KIND is an atlas of ours, or own: the file's coordinates; levels are by the rule before, or
// means. Prints lines of FILE KIND MINIFICATION TILT, RMS errors of our trilinear, 16x and 16x
// ellipse lookups, and of OpenGL's with 1 and 16 probes.
#include <cstdio>
#include <exception>
#include <string>

#include "app/gl/device/context.h"
#include "atlas/base/sharp_level.h"
#include "atlas/measure/lookup_errors.h"
#include "tests/app/support/gl_lookups.h"

namespace {

using namespace burl;

constexpr std::size_t points = 4000;

double error_of(const ViewedMesh& viewed, std::size_t row, const ViewSampler& sampler) {
    std::vector<Vec3d> values;
    for (const Lookup& one : viewed.rows[row])
        values.push_back(sampler.lookup(viewed.chain, one.at, one.steps));
    return viewed.error(row, values);
}

void print_views(const GladGLContext& gl, const std::string& kind, const std::string& file,
                 std::uint32_t size, bool sharp) {
    ViewedMesh viewed(file, enum_named<AtlasKind>(kind), size, points);
    for (std::size_t l = 1; sharp && l < viewed.chain.levels.size(); ++l)
        sharpen(viewed.chain.levels[l]);
    for (std::size_t r = 0; r < viewed.rows.size(); ++r) {
        std::printf("%s %s %g %g", file.c_str(), kind.c_str(), viewed.views.rows[r].minification,
                    viewed.views.rows[r].tilt);
        for (const std::size_t s : {0, 4, 5})
            std::printf(" %.6f", error_of(viewed, r, view_samplers[s]));
        for (const int most : {1, 16})
            std::printf(" %.6f",
                        viewed.error(r, gl_lookups(gl, viewed.chain, viewed.rows[r], most)));
        std::printf("\n");
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        ask_for_exact_lookups();
        const auto context = create_gl_context(argc > 1 ? argv[1] : "osmesa");
        bool sharp = false;
        for (int i = 3; i < argc; ++i) {
            const std::string what = argv[i];
            if (what == "sharp" || what == "average") {
                sharp = what == "sharp";
                continue;
            }
            const std::size_t colon = what.find(':');
            print_views(context->gl(), what.substr(0, colon), what.substr(colon + 1),
                        std::uint32_t(std::stoul(argv[2])), sharp);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
