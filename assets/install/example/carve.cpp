// carve MESH RECIPE OUT: bakes a mesh, tells how far it is, and writes it.
#include <cstdio>
#include <string>

#include <burl/bake.h>

int main(int count, char** words) {
    if (count != 4) {
        std::fprintf(stderr,
                     "usage: carve MESH RECIPE OUT, such as carve sample:teapot oak out.glb\n");
        return 1;
    }
    try {
        burl::BakeOptions options;
        options.size = 256;
        options.progress = [](const burl::ProgressState& state) {
            std::printf("%3.0f %% %s\n", 100.0 * state.share, state.stage.c_str());
            return true;  // false would stop the bake
        };
        const burl::Baked baked =
            burl::bake(burl::Mesh::read(words[1]), burl::Recipe::load(words[2]), options);
        for (const std::string& name : baked.image_names()) {
            const burl::ImageView image = baked.image(name);
            std::printf("%s: %zu x %zu x %zu\n", name.c_str(), image.width, image.height,
                        image.components);
        }
        for (const std::string& lost : burl::write(baked, words[3]))
            std::fprintf(stderr, "%s\n", lost.c_str());
    } catch (const burl::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return int(error.kind());
    }
}
