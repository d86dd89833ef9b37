// probe RECIPE: a recipe's colour at a point, and the share of a texture that a cube's atlas uses.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <burl/evaluate.h>
#include <burl/metrics.h>

int main(int count, char** words) {
    try {
        const burl::Recipe recipe = burl::Recipe::load(count > 1 ? words[1] : "oak");
        const std::vector<double> points{0.1, 0.2, 0.3};
        const burl::Evaluated at = burl::evaluate(recipe, points);
        std::printf("%.17g %.17g %.17g\n", at.colors[0], at.colors[1], at.colors[2]);
        const std::vector<double> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        const std::vector<std::uint32_t> faces{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
        burl::MetricsOptions options;
        options.size = 64;
        const std::string json = burl::metrics(burl::Mesh(corners, faces), recipe, options);
        std::printf("coverage %.3f\n", burl::number_at(json, "/atlases/0/coverage"));
    } catch (const burl::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return int(error.kind());
    }
}
