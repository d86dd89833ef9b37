#pragma once
// Options of a picture's light and of what lies around the object, which all ways of drawing share.
#include <optional>
#include <string>
#include <vector>

#include "app/light/background.h"
#include "app/light/light.h"

namespace CLI {
class App;
}  // namespace CLI

namespace burl {

/// --light, --turn-light, --exposure, --tone, --background and --ground.
struct LightArguments {
    std::optional<std::string> light{}, tone{}, background{};
    std::optional<double> turn{}, exposure{};
    bool ground = false;  ///< whether the object throws a shadow on the ground

    void add(CLI::App& verb);
    /// The light asked for; the studio where --light is left out. Throws Error(usage) for an
    /// unknown light, and for options that the headlight has no use for.
    LightOptions light_options() const;
    /// The background asked for. Throws Error(usage).
    Background background_asked() const;
    /// The files that the light is read from: none, or the picture of --light.
    std::vector<std::string> files() const;
    /// The first option given that is about light; empty where there is none.
    std::string given() const;
};

}  // namespace burl
