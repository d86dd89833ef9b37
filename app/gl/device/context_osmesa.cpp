// OSMesa by dlopen. The few declarations needed are repeated here.
#include <glad/gl.h>

#include <array>
#include <cstdint>

#include "app/gl/device/context.h"
#include "app/gl/device/library.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

// Constants of the OSMesa interface (GL/osmesa.h).
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
    void* (*current_context)() = nullptr;
    GlProcedure (*get_proc)(const char* name) = nullptr;
};

OsMesaLibrary load_osmesa(std::span<const char* const> names) {
    const auto [library, name] = open_library(names);
    if (library == nullptr)
        throw Error(ExitCode::unsupported,
                    "the software OpenGL library OSMesa was not found; install the package "
                    "libosmesa6 to draw pictures");
    OsMesaLibrary result;
    result.name = name;
    if (!find_function(library, "OSMesaCreateContextAttribs", result.create_context) ||
        !find_function(library, "OSMesaDestroyContext", result.destroy_context) ||
        !find_function(library, "OSMesaMakeCurrent", result.make_current) ||
        !find_function(library, "OSMesaGetCurrentContext", result.current_context) ||
        !find_function(library, "OSMesaGetProcAddress", result.get_proc)) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{} is too old to make an OpenGL 3.3 context; install the package "
                                "libosmesa6 (Mesa 12 or later)",
                                name));
    }
    return result;
}

/// A core context of the highest version; null where the library gives none.
void* create_highest(const OsMesaLibrary& library) {
    for (const auto& [major, minor] : gl_versions) {
        const std::array<int, 9> attributes{osmesa_format,
                                            GL_RGBA,
                                            osmesa_profile,
                                            osmesa_core_profile,
                                            osmesa_context_major_version,
                                            major,
                                            osmesa_context_minor_version,
                                            minor,
                                            0};
        if (void* const context = library.create_context(attributes.data(), nullptr))
            return context;
    }
    return nullptr;
}

class OsMesaContext final : public GlContext {
  public:
    explicit OsMesaContext(std::span<const char* const> library_names)
        : library_(load_osmesa(library_names)), context_(create_highest(library_)) {
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
    std::string origin() const override { return "OSMesa"; }

  private:
    void release() {
        if (library_.current_context() == context_)
            library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        library_.destroy_context(context_);
    }

    OsMesaLibrary library_;
    void* context_ = nullptr;
    std::array<std::uint8_t, 4> window_{};  ///< the unused default framebuffer, one pixel
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
