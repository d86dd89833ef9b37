#pragma once
// A place to draw a program's picture and to hear of its user: a window of the desktop through
// GLFW, or none at all, for scripts and tests.
#include <memory>
#include <string>
#include <vector>

#include "app/editor/session/input.h"
#include "app/gl/device/context.h"
#include "atlas/base/image.h"

namespace burl {

class GlWindow {
  public:
    virtual ~GlWindow() = default;
    GlWindow(const GlWindow&) = delete;
    GlWindow& operator=(const GlWindow&) = delete;

    virtual GlContext& context() = 0;
    /// In screen coordinates, which are those of input.
    virtual glm::ivec2 size() const = 0;
    /// Pixels, those of the framebuffer; both are 0 while the window is minimised.
    virtual glm::ivec2 pixels() const = 0;
    /// Binds the framebuffer that will be shown; row 0 is the lowest. As long as it keeps its size
    /// it holds what was drawn last.
    virtual void bind_screen() = 0;
    /// Shows what was drawn. Throws Error(unsupported) when the context was lost.
    virtual void present() = 0;
    /// What happened since the last call; waits at most `seconds` for something to happen.
    virtual std::vector<InputEvent> poll(double seconds) = 0;
    /// Ends a wait of poll(); may be called by any thread.
    virtual void wake() = 0;
    /// How much larger than usual text must be on this display to be read, where one screen
    /// coordinate is one of its pixels.
    virtual double text_scale() const { return 1.0; }
    /// Makes it as large, in screen coordinates; a desktop may not obey, or not at once.
    virtual void resize(const glm::ivec2& size) = 0;
    virtual void set_title(const std::string& title) = 0;
    virtual std::string clipboard() const = 0;
    virtual void set_clipboard(const std::string& text) = 0;
    /// Seconds since the window was made, of a clock that never goes back.
    virtual double seconds() const = 0;

  protected:
    GlWindow() = default;
};

/// A window of the desktop. Only the main thread may make and use it. Throws Error(unsupported)
/// with what to do where there is no display or no OpenGL 3.3.
std::unique_ptr<GlWindow> create_desktop_window(const glm::ivec2& size, const std::string& title);

/// A window nobody sees, drawn by `context`; poll() returns at once and reports nothing, and every
/// present() moves the clock on by 1/60 second, so that what is done in it repeats.
std::unique_ptr<GlWindow> create_unseen_window(std::unique_ptr<GlContext> context,
                                               const glm::ivec2& size);

/// What the bound framebuffer shows, row 0 on top.
Image<Rgb8> read_screen(const GlWindow& window, const GladGLContext& gl);

}  // namespace burl
