#include "app/light/chosen_environment.h"

#include <algorithm>

namespace burl {

Environment environment_of(const LightOptions& options, std::size_t rows) {
    const auto notes = environment_notes();
    const bool is_built_in =
        std::ranges::find(notes, options.light, &EnvironmentNote::name) != notes.end();
    Environment environment =
        is_built_in ? make_environment(options.light, rows) : load_environment(options.light);
    return options.turn == 0.0 ? environment : turned(environment, options.turn);
}

}  // namespace burl
