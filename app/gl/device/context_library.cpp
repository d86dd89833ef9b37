// OSMesa and EGL by dlopen, so that neither the libraries nor their headers are dependencies of the
// build; the few declarations needed are repeated here. Without window or display EGL has several
// places for a context: all devices that it lists and Mesa's surfaceless platform are tried in
// turn, hardware first (EGL_EXT_platform_device, EGL_MESA_platform_surfaceless,
// EGL_MESA_device_software).
#include <dlfcn.h>
#include <glad/gl.h>

#include <cstdint>
#include <functional>
#include <string_view>

#include "app/gl/device/context.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// A library of OpenGL contexts, loaded at run time. It stays loaded until the program ends, since
/// LLVM inside drivers does not survive unloading.
class Library {
  public:
    /// Loads the first library that there is. Errors are `missing` where there is none, and the
    /// library's name with `unfit` where it lacks a function.
    Library(std::span<const char* const> names, const char* missing, const char* unfit)
        : unfit_(unfit) {
        for (const char* name : names) {
            library_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
            name_ = name;
            if (library_ != nullptr) return;
        }
        throw Error(ExitCode::unsupported, missing);
    }

    /// Looks up a function. Throws Error(unsupported) where there is none of that name.
    template <class Function>
    void find(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(dlsym(library_, name));
        if (function == nullptr)
            throw Error(ExitCode::unsupported, fmt::format("{} {}", name_, unfit_));
    }
    const std::string& name() const { return name_; }

  private:
    const char* unfit_;
    void* library_ = nullptr;
    std::string name_;
};

/// The context of the highest version that create(major, minor) makes; null where it makes none.
template <class Create>
void* create_highest(Create create) {
    for (const auto& [major, minor] : gl_versions)
        if (void* const context = create(major, minor)) return context;
    return nullptr;
}

/// A context as its library made it.
struct Made {
    std::string library, origin;
    GlProcedure (*get_proc)(const char* name) = nullptr;
    std::function<bool()> make_current;
    std::function<void()> release;
    /// Makes another context that shares this one's objects.
    std::function<Made(void* context)> share{};
    /// The context, whose deleter takes it from the thread where it is current, and destroys it.
    std::shared_ptr<void> context;
};

class LibraryContext final : public GlContext {
  public:
    explicit LibraryContext(Made made) : made_(std::move(made)) {
        make_current();
        load_functions(made_.library);
    }

    void make_current() override {
        if (!made_.make_current())
            throw Error(ExitCode::runtime,
                        fmt::format("{} could not activate its OpenGL context", made_.library));
    }
    void release() override { made_.release(); }
    std::unique_ptr<GlContext> share() override {
        auto other = std::make_unique<LibraryContext>(made_.share(made_.context.get()));
        make_current();
        return other;
    }
    GlProcedure get_proc(const char* name) override { return made_.get_proc(name); }
    std::string origin() const override { return made_.origin; }

  private:
    Made made_;
};

// Constants of the OSMesa interface (GL/osmesa.h).
constexpr int osmesa_format = 0x22;
constexpr int osmesa_profile = 0x33, osmesa_core_profile = 0x34;
constexpr int osmesa_context_major_version = 0x36, osmesa_context_minor_version = 0x37;

struct OsMesa {
    explicit OsMesa(const Library& library) {
        library.find("OSMesaCreateContextAttribs", create_context);
        library.find("OSMesaDestroyContext", destroy_context);
        library.find("OSMesaMakeCurrent", make_current);
        library.find("OSMesaGetCurrentContext", current_context);
        library.find("OSMesaGetProcAddress", get_proc);
    }

    void* (*create_context)(const int* attributes, void* share) = nullptr;
    void (*destroy_context)(void* context) = nullptr;
    unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width,
                                  int height) = nullptr;
    void* (*current_context)() = nullptr;
    GlProcedure (*get_proc)(const char* name) = nullptr;
};

Made make_osmesa(const OsMesa& mesa, const std::string& library, void* shared) {
    void* const context = create_highest([&](int major, int minor) {
        const int attributes[] = {osmesa_format,
                                  GL_RGBA,
                                  osmesa_profile,
                                  osmesa_core_profile,
                                  osmesa_context_major_version,
                                  major,
                                  osmesa_context_minor_version,
                                  minor,
                                  0};
        return mesa.create_context(attributes, shared);
    });
    if (context == nullptr)
        throw Error(ExitCode::unsupported,
                    fmt::format("{} gives no OpenGL 3.3 core context; install a later libosmesa6",
                                library));
    // The unused default framebuffer has one pixel.
    const auto make_current = [=, window = std::make_shared<std::uint32_t>()] {
        return mesa.make_current(context, window.get(), GL_UNSIGNED_BYTE, 1, 1) != 0;
    };
    const auto release = [mesa] { mesa.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); };
    const auto destroy = [mesa, release](void* dead) {
        if (mesa.current_context() == dead) release();
        mesa.destroy_context(dead);
    };
    const auto share = [mesa, library](void* with) { return make_osmesa(mesa, library, with); };
    return {library, "OSMesa", mesa.get_proc, make_current, release, share, {context, destroy}};
}

Made make_osmesa(std::span<const char* const> names) {
    const Library library(names,
                          "the software OpenGL library OSMesa was not found; install the package "
                          "libosmesa6 to draw pictures",
                          "is too old to make an OpenGL 3.3 context; install the package "
                          "libosmesa6 (Mesa 12 or later)");
    return make_osmesa(OsMesa(library), library.name(), nullptr);
}

// Constants of the EGL interface (EGL/egl.h, EGL/eglext.h).
using EglInt = std::int32_t;
using EglHandle = void*;
constexpr unsigned opengl_api = 0x30A2;
constexpr EglInt extensions_text = 0x3055, none = 0x3038;
constexpr EglInt surface_type = 0x3033, renderable_type = 0x3040, opengl_bit = 0x0008;
constexpr EglInt major_version = 0x3098, minor_version = 0x30FB;
constexpr EglInt profile_mask = 0x30FD, core_profile_bit = 0x0001;
constexpr unsigned platform_surfaceless = 0x31DD, platform_device = 0x313F;

struct Egl {
    explicit Egl(const Library& library) {
        library.find("eglGetProcAddress", get_proc);
        library.find("eglQueryString", query_string);
        library.find("eglInitialize", initialize);
        library.find("eglBindAPI", bind_api);
        library.find("eglChooseConfig", choose_config);
        library.find("eglCreateContext", create_context);
        library.find("eglDestroyContext", destroy_context);
        library.find("eglMakeCurrent", make_current);
        library.find("eglGetCurrentContext", current_context);
        const auto extension = [&](const char* function, auto& pointer) {
            pointer =
                reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(get_proc(function));
        };
        extension("eglGetPlatformDisplayEXT", platform_display);
        extension("eglQueryDevicesEXT", query_devices);
        extension("eglQueryDeviceStringEXT", device_string);
    }

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

/// A device or platform that a context may be created on.
struct Place {
    unsigned platform = platform_surfaceless;
    EglHandle device = nullptr;
    std::string name = "EGL surfaceless";
};

/// All devices and platforms, hardware first.
std::vector<Place> places_of(const Egl& egl) {
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

/// The display of a place with a form of its pixels, and a context on it; all null where the place
/// gives none. EGL displays are shared by all users of one place, so they are never closed.
struct EglContext {
    EglHandle display = nullptr, config = nullptr, context = nullptr;
};

/// A context of the highest version, which shares the objects of another (null: of none).
EglHandle highest_context(const Egl& egl, EglHandle display, EglHandle config, EglHandle shared) {
    return create_highest([&](int major, int minor) {
        const EglInt attributes[] = {major_version,    major, minor_version, minor, profile_mask,
                                     core_profile_bit, none};
        return egl.create_context(display, config, shared, attributes);
    });
}

EglContext make_context(const Egl& egl, const Place& place) {
    const EglHandle display = egl.platform_display(place.platform, place.device, nullptr);
    if (display == nullptr || !egl.initialize(display, nullptr, nullptr)) return {};
    const char* const extensions = egl.query_string(display, extensions_text);
    if (!has_word(extensions, "EGL_KHR_surfaceless_context") || !egl.bind_api(opengl_api))
        return {};
    const EglInt wanted[] = {surface_type, 0, renderable_type, opengl_bit, none};
    EglHandle config = nullptr;
    EglInt count = 0;
    if (!egl.choose_config(display, wanted, &config, 1, &count) || count < 1) return {};
    return {display, config, highest_context(egl, display, config, nullptr)};
}

Made made_egl(const Egl& egl, const std::string& library, const std::string& place,
              const EglContext& of) {
    const auto make_current = [egl, of] {
        egl.bind_api(opengl_api);
        return egl.make_current(of.display, nullptr, nullptr, of.context) != 0;
    };
    const auto release = [egl, of] { egl.make_current(of.display, nullptr, nullptr, nullptr); };
    const auto destroy = [egl, of, release](void* dead) {
        if (egl.current_context() == dead) release();
        egl.destroy_context(of.display, dead);
    };
    const auto share = [egl, library, place, of](void* with) {
        egl.bind_api(opengl_api);
        EglContext other = of;
        other.context = highest_context(egl, of.display, of.config, with);
        if (other.context == nullptr)
            throw Error(ExitCode::unsupported, library + " gives no second context");
        return made_egl(egl, library, place, other);
    };
    return {library, place, egl.get_proc, make_current, release, share, {of.context, destroy}};
}

Made make_egl(std::span<const char* const> names) {
    const Library library(
        names,
        "the library EGL was not found; install the package libegl1, or draw with --gl osmesa",
        "is not EGL 1.4 or later; install the package libegl1, or draw with --gl osmesa");
    const Egl egl(library);
    const std::vector<Place> places = places_of(egl);
    for (const Place& place : places) {
        const EglContext made = make_context(egl, place);
        if (made.context != nullptr) return made_egl(egl, library.name(), place.name, made);
    }
    throw Error(ExitCode::unsupported,
                fmt::format("none of the {} devices and platforms of {} gives an OpenGL 3.3 core "
                            "context; install a driver, or draw with --gl osmesa",
                            places.size(), library.name()));
}

}  // namespace

std::unique_ptr<GlContext> create_osmesa_context(std::span<const char* const> library_names) {
    return std::make_unique<LibraryContext>(make_osmesa(library_names));
}

std::unique_ptr<GlContext> create_egl_context(std::span<const char* const> library_names) {
    return std::make_unique<LibraryContext>(make_egl(library_names));
}

}  // namespace burl
