// EGL by dlopen, without window or display: all devices that EGL lists and Mesa's surfaceless
// platform are tried in turn, hardware first (EGL_EXT_platform_device,
// EGL_MESA_platform_surfaceless, EGL_MESA_device_software). The few declarations needed are
// repeated here.
#include <glad/gl.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "app/gl/device/context.h"
#include "app/gl/device/library.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

// Constants of the EGL interface (EGL/egl.h, EGL/eglext.h).
using EglInt = std::int32_t;
using EglHandle = void*;
constexpr unsigned opengl_api = 0x30A2;
constexpr EglInt extensions_text = 0x3055, none = 0x3038;
constexpr EglInt surface_type = 0x3033, renderable_type = 0x3040, opengl_bit = 0x0008;
constexpr EglInt major_version = 0x3098, minor_version = 0x30FB;
constexpr EglInt profile_mask = 0x30FD, core_profile_bit = 0x0001;
constexpr unsigned platform_surfaceless = 0x31DD, platform_device = 0x313F;

struct EglLibrary {
    std::string name;
    GlProcedure (*get_proc)(const char* name) = nullptr;
    const char* (*query_string)(EglHandle display, EglInt name) = nullptr;
    unsigned (*initialize)(EglHandle display, EglInt* major, EglInt* minor) = nullptr;
    unsigned (*bind_api)(unsigned api) = nullptr;
    unsigned (*choose_config)(EglHandle display, const EglInt* attributes, EglHandle* configs,
                              EglInt size, EglInt* count) = nullptr;
    EglHandle (*create_context)(EglHandle display, EglHandle config, EglHandle share,
                                const EglInt* attributes) = nullptr;
    unsigned (*destroy_context)(EglHandle display, EglHandle context) = nullptr;
    unsigned (*make_current)(EglHandle display, EglHandle draw, EglHandle read,
                             EglHandle context) = nullptr;
    EglHandle (*current_context)() = nullptr;
    // Extensions of the library itself; null where it lacks them.
    EglHandle (*platform_display)(unsigned platform, void* native,
                                  const EglInt* attributes) = nullptr;
    unsigned (*query_devices)(EglInt size, EglHandle* devices, EglInt* count) = nullptr;
    const char* (*device_string)(EglHandle device, EglInt name) = nullptr;
};

bool has_word(const char* words, std::string_view word) {
    if (words == nullptr) return false;
    return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

EglLibrary load_egl(std::span<const char* const> names) {
    const auto [library, name] = open_library(names);
    if (library == nullptr)
        throw Error(ExitCode::unsupported,
                    "the library EGL was not found; install the package libegl1, or draw with --gl "
                    "osmesa");
    EglLibrary egl;
    egl.name = name;
    if (!find_function(library, "eglGetProcAddress", egl.get_proc) ||
        !find_function(library, "eglQueryString", egl.query_string) ||
        !find_function(library, "eglInitialize", egl.initialize) ||
        !find_function(library, "eglBindAPI", egl.bind_api) ||
        !find_function(library, "eglChooseConfig", egl.choose_config) ||
        !find_function(library, "eglCreateContext", egl.create_context) ||
        !find_function(library, "eglDestroyContext", egl.destroy_context) ||
        !find_function(library, "eglMakeCurrent", egl.make_current) ||
        !find_function(library, "eglGetCurrentContext", egl.current_context)) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{} is not EGL 1.4 or later; install the package libegl1, or draw "
                                "with --gl osmesa",
                                name));
    }
    const auto extension = [&](const char* function, auto& pointer) {
        pointer =
            reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(egl.get_proc(function));
    };
    extension("eglGetPlatformDisplayEXT", egl.platform_display);
    extension("eglQueryDevicesEXT", egl.query_devices);
    extension("eglQueryDeviceStringEXT", egl.device_string);
    return egl;
}

/// A device or platform that a context may be created on.
struct Place {
    unsigned platform = platform_surfaceless;
    EglHandle device = nullptr;
    std::string name = "EGL surfaceless";
};

/// All devices and platforms, hardware first.
std::vector<Place> places_of(const EglLibrary& egl) {
    const char* const extensions = egl.query_string(nullptr, extensions_text);
    std::vector<Place> places, software;
    if (egl.platform_display == nullptr) return places;
    if (has_word(extensions, "EGL_EXT_platform_device") && egl.query_devices && egl.device_string) {
        std::array<EglHandle, 64> devices{};
        EglInt count = 0;
        if (!egl.query_devices(EglInt(devices.size()), devices.data(), &count)) count = 0;
        for (EglInt i = 0; i < count; ++i) {
            const EglHandle device = devices[std::size_t(i)];
            const bool soft =
                has_word(egl.device_string(device, extensions_text), "EGL_MESA_device_software");
            (soft ? software : places)
                .push_back({platform_device, device, fmt::format("EGL device {}", i)});
        }
    }
    if (has_word(extensions, "EGL_MESA_platform_surfaceless")) places.push_back({});
    places.insert(places.end(), software.begin(), software.end());
    return places;
}

/// A display and a context on it; both null where the place gives none. EGL displays are shared by
/// all users of one place, so they are never closed.
struct Made {
    EglHandle display = nullptr, context = nullptr;
};

Made make_context(const EglLibrary& egl, const Place& place) {
    Made made;
    made.display = egl.platform_display(place.platform, place.device, nullptr);
    if (made.display == nullptr || !egl.initialize(made.display, nullptr, nullptr)) return {};
    const char* const extensions = egl.query_string(made.display, extensions_text);
    if (!has_word(extensions, "EGL_KHR_surfaceless_context") || !egl.bind_api(opengl_api))
        return {};
    const std::array<EglInt, 5> wanted{surface_type, 0, renderable_type, opengl_bit, none};
    EglHandle config = nullptr;
    EglInt count = 0;
    if (!egl.choose_config(made.display, wanted.data(), &config, 1, &count) || count < 1) return {};
    for (const auto& [major, minor] : gl_versions) {
        const std::array<EglInt, 7> attributes{
            major_version, major, minor_version, minor, profile_mask, core_profile_bit, none};
        made.context = egl.create_context(made.display, config, nullptr, attributes.data());
        if (made.context != nullptr) return made;
    }
    return {};
}

class EglContext final : public GlContext {
  public:
    explicit EglContext(std::span<const char* const> library_names)
        : egl_(load_egl(library_names)) {
        const std::vector<Place> places = places_of(egl_);
        for (std::size_t i = 0; i < places.size() && made_.context == nullptr; ++i) {
            made_ = make_context(egl_, places[i]);
            name_ = places[i].name;
        }
        if (made_.context == nullptr)
            throw Error(
                ExitCode::unsupported,
                fmt::format("none of the {} devices and platforms of {} gives an OpenGL 3.3 "
                            "core context; install a driver, or draw with --gl osmesa",
                            places.size(), egl_.name));
        try {
            make_current();
            load_functions(egl_.name);
        } catch (...) {
            release();
            throw;
        }
    }

    ~EglContext() override { release(); }

    void make_current() override {
        egl_.bind_api(opengl_api);
        if (!egl_.make_current(made_.display, nullptr, nullptr, made_.context))
            throw Error(ExitCode::runtime,
                        fmt::format("{} could not activate its OpenGL context", egl_.name));
    }

    GlProcedure get_proc(const char* name) override { return egl_.get_proc(name); }
    std::string origin() const override { return name_; }

  private:
    void release() {
        if (egl_.current_context() == made_.context)
            egl_.make_current(made_.display, nullptr, nullptr, nullptr);
        egl_.destroy_context(made_.display, made_.context);
    }

    EglLibrary egl_;
    Made made_;
    std::string name_;
};

}  // namespace

std::span<const char* const> egl_library_names() {
    static constexpr std::array names{"libEGL.so.1", "libEGL.so"};
    return names;
}

std::unique_ptr<GlContext> create_egl_context(std::span<const char* const> library_names) {
    return std::make_unique<EglContext>(library_names);
}

}  // namespace burl
