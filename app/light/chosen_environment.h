#pragma once
// The environment that the options of a picture's light name.
#include <cstddef>

#include "app/light/environment.h"
#include "app/light/light.h"

namespace burl {

/// The environment of options that are not the headlight's, turned: a built-in one, `rows` high, or
/// that of a file. Throws Error as make_environment and load_environment do.
Environment environment_of(const LightOptions& options, std::size_t rows = 256);

}  // namespace burl
