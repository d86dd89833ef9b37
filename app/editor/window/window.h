#pragma once
// The interface of a window with an OpenGL context and input: one on the desktop through GLFW, or
// an offscreen one for scripts and tests.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/session/input.h"
#include "app/gl/device/context.h"
#include "atlas/base/image.h"

namespace burl {

/// The shapes of the pointer.
enum class PointerShape { arrow, text, cross, hand, resize_sideways, resize_upright, none };

/// A window. All functions except wake() are called by the main thread.
class GlWindow {
  public:
    virtual ~GlWindow() = default;
    GlWindow(const GlWindow&) = delete;
    GlWindow& operator=(const GlWindow&) = delete;

    virtual GlContext& context() = 0;
    /// The window's size in screen coordinates, in which input is given, too.
    virtual glm::ivec2 size() const = 0;
    /// The framebuffer's size in pixels; 0 x 0 while the window is minimised.
    virtual glm::ivec2 pixels() const = 0;
    /// Binds the framebuffer that present() shows; row 0 is the lowest. It keeps its content
    /// between frames while its size stays.
    virtual void bind_screen() = 0;
    /// Shows the framebuffer. Throws Error(unsupported) when the context was lost.
    virtual void present() = 0;
    /// Returns the input since the last call, after waiting at most `seconds` for some.
    virtual std::vector<InputEvent> poll(double seconds) = 0;
    /// Ends a wait of poll(). May be called by any thread.
    virtual void wake() = 0;
    /// Returns whether, since the last call, wake() was called or the display lost what it showed.
    virtual bool take_news() = 0;
    /// Factor by which text must be enlarged to be readable on this display, where screen
    /// coordinates are pixels.
    virtual double text_scale() const { return 1.0; }
    /// Requests a size in screen coordinates, which a desktop may ignore or apply later.
    virtual void resize(const glm::ivec2& size) = 0;
    virtual void set_title(const std::string& title) = 0;
    /// Sets the shape of the pointer over the window.
    void set_pointer(PointerShape shape) {
        if (std::exchange(pointer_, shape) != shape) show_pointer(shape);
    }
    /// The shape set last.
    PointerShape pointer() const { return pointer_; }
    virtual std::string clipboard() const = 0;
    virtual void set_clipboard(const std::string& text) = 0;
    /// Seconds since the window was made, on a steady clock.
    virtual double seconds() const = 0;

  protected:
    GlWindow() = default;
    /// Shows a shape that differs from the last one, where there is a pointer to be seen.
    virtual void show_pointer(PointerShape) {}

  private:
    PointerShape pointer_ = PointerShape::arrow;
};

/// Opens a window on the desktop; only the main thread may create and use it. Throws
/// Error(unsupported) with advice where there is no display or no OpenGL 3.3.
std::unique_ptr<GlWindow> create_desktop_window(const glm::ivec2& size, const std::string& title);

/// Creates an offscreen window drawn by `context`. Its poll() returns at once without input, and
/// every present() advances its clock by 1/60 second, so that runs repeat.
std::unique_ptr<GlWindow> create_unseen_window(std::unique_ptr<GlContext> context,
                                               const glm::ivec2& size);

/// Reads the pixels of the bound framebuffer, row 0 on top.
Image<Rgb8> read_screen(const GlWindow& window, const GladGLContext& gl);

}  // namespace burl
