// OSMesa by dlopen: the few declarations it needs stand here, so neither its header nor its library
// is a dependency of the build.
#include <dlfcn.h>
#include <glad/gl.h>

#include <array>
#include <cstdint>

#include "app/gl_context.h"
#include "atlas/error.h"

namespace burl {

namespace {

// From the OSMesa interface (GL/osmesa.h).
constexpr int osmesa_format = 0x22;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_context_major_version = 0x36;
constexpr int osmesa_context_minor_version = 0x37;

struct OsMesaLibrary {
    std::string name;
    void* (*create_context)(const int* attributes, void* share) = nullptr;
    void (*destroy_context)(void* context) = nullptr;
    unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width,
                                  int height) = nullptr;
    GlProcedure (*get_proc)(const char* name) = nullptr;
};

template <class Function>
bool find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

/// The library stays loaded until the program ends: LLVM inside it does not survive unloading.
OsMesaLibrary load_library(std::span<const char* const> names) {
    for (const char* name : names) {
        void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) continue;
        OsMesaLibrary result;
        result.name = name;
        if (!find(library, "OSMesaCreateContextAttribs", result.create_context) ||
            !find(library, "OSMesaDestroyContext", result.destroy_context) ||
            !find(library, "OSMesaMakeCurrent", result.make_current) ||
            !find(library, "OSMesaGetProcAddress", result.get_proc)) {
            throw Error(ExitCode::unsupported,
                        fmt::format("{} is too old to make an OpenGL 3.3 context; install the "
                                    "package libosmesa6 (Mesa 12 or later)",
                                    name));
        }
        return result;
    }
    throw Error(ExitCode::unsupported,
                "the software OpenGL library OSMesa was not found; install the package libosmesa6 "
                "to draw pictures");
}

class OsMesaContext final : public GlContext {
  public:
    explicit OsMesaContext(std::span<const char* const> library_names)
        : library_(load_library(library_names)) {
        const std::array<int, 9> attributes{osmesa_format,
                                            GL_RGBA,
                                            osmesa_profile,
                                            osmesa_core_profile,
                                            osmesa_context_major_version,
                                            3,
                                            osmesa_context_minor_version,
                                            3,
                                            0};
        context_ = library_.create_context(attributes.data(), nullptr);
        if (context_ == nullptr) {
            throw Error(ExitCode::unsupported,
                        fmt::format("{} gives no OpenGL 3.3 core context; install a later "
                                    "libosmesa6",
                                    library_.name));
        }
        try {
            make_current();
            load_functions(library_.name);
        } catch (...) {
            release();
            throw;
        }
    }

    ~OsMesaContext() override { release(); }

    void make_current() override {
        if (!library_.make_current(context_, window_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
            throw Error(ExitCode::runtime,
                        fmt::format("{} could not activate its OpenGL context", library_.name));
        }
    }

    GlProcedure get_proc(const char* name) override { return library_.get_proc(name); }

    std::string description() const override {
        const auto text = [&](GLenum name) {
            return reinterpret_cast<const char*>(gl().GetString(name));
        };
        return fmt::format("OSMesa, {}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
    }

  private:
    void release() {
        library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        library_.destroy_context(context_);
    }

    OsMesaLibrary library_;
    void* context_ = nullptr;
    std::array<std::uint8_t, 4> window_{};  ///< the unused default framebuffer: one pixel
};

}  // namespace

std::span<const char* const> osmesa_library_names() {
    static constexpr std::array names{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    return names;
}

std::unique_ptr<GlContext> create_osmesa_context(std::span<const char* const> library_names) {
    return std::make_unique<OsMesaContext>(library_names);
}

}  // namespace burl
