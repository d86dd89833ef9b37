// Desktop windows through GLFW, whose callbacks are queued as input events.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <optional>
#include <utility>

#include "app/editor/window/window.h"
#include "app/gl/device/target.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

// GLFW has one global state, which only the main thread may touch.
std::string last_problem() {
    const char* text = nullptr;
    return glfwGetError(&text) != GLFW_NO_ERROR && text != nullptr ? text : "no reason given";
}

/// Initialises GLFW, and terminates it when the last window of the process is gone.
struct GlfwLibrary {
    GlfwLibrary() {
        glfwInitHint(GLFW_JOYSTICK_HAT_BUTTONS, GLFW_FALSE);
        if (glfwInit() == GLFW_FALSE)
            throw Error(ExitCode::unsupported,
                        fmt::format("no window can be opened ({}); run burl-edit on a desktop, "
                                    "under xvfb-run, or without a window: --script FILE --unseen",
                                    last_problem()));
    }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
    ~GlfwLibrary() { glfwTerminate(); }
};

struct DestroyWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, DestroyWindow>;

/// Opens a window whose context shares the objects of another's (null: of none); it is seen unless
/// there is another.
WindowHandle open_window(const glm::ivec2& size, const std::string& title,
                         GLFWwindow* shared = nullptr) {
    glfwWindowHint(GLFW_VISIBLE, shared ? GLFW_FALSE : GLFW_TRUE);
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    for (const auto& [major, minor] : gl_versions) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        if (WindowHandle window{glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, shared)})
            return window;
    }
    throw Error(ExitCode::unsupported,
                fmt::format("this display gives no window with OpenGL 3.3 core ({}); install a "
                            "graphics driver, or run without a window: --script FILE --unseen",
                            last_problem()));
}

struct DestroyCursor {
    void operator()(GLFWcursor* cursor) const { glfwDestroyCursor(cursor); }
};
using CursorHandle = std::unique_ptr<GLFWcursor, DestroyCursor>;

int glfw_shape(PointerShape shape) {
    switch (shape) {
        case PointerShape::text:
            return GLFW_IBEAM_CURSOR;
        case PointerShape::cross:
            return GLFW_CROSSHAIR_CURSOR;
        case PointerShape::hand:
            return GLFW_HAND_CURSOR;
        case PointerShape::resize_sideways:
            return GLFW_HRESIZE_CURSOR;
        case PointerShape::resize_upright:
            return GLFW_VRESIZE_CURSOR;
        case PointerShape::arrow:
        case PointerShape::none:
            break;
    }
    return GLFW_ARROW_CURSOR;
}

class DesktopContext final : public GlContext {
  public:
    /// The context of a window; `owned` is that window where nobody else owns it.
    explicit DesktopContext(GLFWwindow* window, WindowHandle owned = nullptr)
        : owned_(std::move(owned)), window_(window) {
        make_current();
        load_functions("the display");
    }
    void make_current() override { glfwMakeContextCurrent(window_); }
    void release() override { glfwMakeContextCurrent(nullptr); }
    std::unique_ptr<GlContext> share() override {
        WindowHandle hidden = open_window({16, 16}, "Burl", window_);
        GLFWwindow* const window = hidden.get();
        auto other = std::make_unique<DesktopContext>(window, std::move(hidden));
        make_current();
        return other;
    }
    GlProcedure get_proc(const char* name) override { return glfwGetProcAddress(name); }
    std::string origin() const override { return "GLFW"; }

  private:
    WindowHandle owned_;
    GLFWwindow* window_;
};

/// GLFW's keys besides letters and digits, by their names in docs/guide/editor.md.
constexpr std::array<std::pair<int, const char*>, 35> named_keys{{
    {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_PAGE_UP, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"},
    {GLFW_KEY_INSERT, "Insert"},
    {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_KP_ENTER, "Enter"},
    {GLFW_KEY_ESCAPE, "Escape"},
    {GLFW_KEY_LEFT_CONTROL, "Ctrl"},
    {GLFW_KEY_RIGHT_CONTROL, "Ctrl"},
    {GLFW_KEY_LEFT_SHIFT, "Shift"},
    {GLFW_KEY_RIGHT_SHIFT, "Shift"},
    {GLFW_KEY_LEFT_ALT, "Alt"},
    {GLFW_KEY_RIGHT_ALT, "Alt"},
    {GLFW_KEY_KP_ADD, "Plus"},
    {GLFW_KEY_KP_SUBTRACT, "Minus"},
    {GLFW_KEY_MINUS, "Minus"},
    {GLFW_KEY_EQUAL, "Plus"},
    {GLFW_KEY_COMMA, "Comma"},
    {GLFW_KEY_PERIOD, "Period"},
    {GLFW_KEY_KP_1, "1"},
    {GLFW_KEY_KP_3, "3"},
    {GLFW_KEY_KP_5, "5"},
    {GLFW_KEY_KP_7, "7"},
    {GLFW_KEY_KP_0, "0"},
    {GLFW_KEY_LEFT_SUPER, "Ctrl"},
    {GLFW_KEY_RIGHT_SUPER, "Ctrl"},
}};

/// Returns the name of a key; letters are those of the keyboard layout, so that Ctrl+Z is where Z
/// is printed.
std::string name_of_key(int key, int scancode) {
    for (const auto& [number, name] : named_keys)
        if (number == key) return name;
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return std::string(1, char('0' + key - GLFW_KEY_0));
    const char* printed = glfwGetKeyName(key, scancode);
    if (printed == nullptr || printed[0] == '\0' || printed[1] != '\0') return {};
    const char letter = printed[0];
    if (letter >= 'a' && letter <= 'z') return std::string(1, char(letter - 'a' + 'A'));
    return {};
}

std::string utf8(unsigned code) {
    const auto tail = [&](unsigned shift) { return char(0x80U | ((code >> shift) & 0x3fU)); };
    if (code < 0x80) return {char(code)};
    if (code < 0x800) return {char(0xc0U | (code >> 6)), tail(0)};
    if (code < 0x10000) return {char(0xe0U | (code >> 12)), tail(6), tail(0)};
    return {char(0xf0U | (code >> 18)), tail(12), tail(6), tail(0)};
}

class DesktopWindow final : public GlWindow {
  public:
    DesktopWindow(const glm::ivec2& size, const std::string& title)
        : window_(open_window(size, title)), context_(window_.get()) {
        glfwSwapInterval(1);
        listen();
    }

    GlContext& context() override { return context_; }
    glm::ivec2 size() const override {
        glm::ivec2 size(0);
        glfwGetWindowSize(window_.get(), &size.x, &size.y);
        return size;
    }
    glm::ivec2 pixels() const override {
        glm::ivec2 size(0);
        glfwGetFramebufferSize(window_.get(), &size.x, &size.y);
        return size;
    }
    /// Binds an offscreen target, which keeps its size while the window is minimised to 0 pixels.
    void bind_screen() override {
        const glm::ivec2 size = pixels();
        const bool resized = size.x > 0 && size.y > 0 && screen_ && screen_->size() != size;
        if (!screen_ || resized)
            screen_.emplace(context_.gl(), glm::max(size, glm::ivec2(1)), screen_format);
        screen_->bind();
    }
    void present() override {
        if (const GLenum problem = context_.gl().GetError(); problem == context_lost)
            throw Error(ExitCode::unsupported,
                        "the display's OpenGL context was lost; start burl-edit again, it will "
                        "offer what was not saved");
        if (screen_) show_screen();
        glfwSwapBuffers(window_.get());
    }
    std::vector<InputEvent> poll(double seconds) override {
        if (seconds > 0.0)
            glfwWaitEventsTimeout(seconds);
        else
            glfwPollEvents();
        return std::exchange(events_, {});
    }
    void wake() override {
        news_ = true;
        glfwPostEmptyEvent();
    }
    bool take_news() override { return news_.exchange(false); }
    double text_scale() const override {
        float scale = 1.0f, unused = 1.0f;
        glfwGetWindowContentScale(window_.get(), &scale, &unused);
        const glm::ivec2 points = size(), all = pixels();
        const double zoomed = points.x > 0 ? double(all.x) / double(points.x) : 1.0;
        return std::clamp(double(scale) / zoomed, 1.0, 4.0);
    }
    void resize(const glm::ivec2& size) override {
        if (size.x > 0 && size.y > 0) glfwSetWindowSize(window_.get(), size.x, size.y);
    }
    void set_title(const std::string& title) override {
        glfwSetWindowTitle(window_.get(), title.c_str());
    }
    void show_pointer(PointerShape shape) override {
        const bool hidden = shape == PointerShape::none;
        glfwSetInputMode(window_.get(), GLFW_CURSOR,
                         hidden ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
        if (!hidden) glfwSetCursor(window_.get(), cursor(shape));
    }
    std::string clipboard() const override {
        const char* text = glfwGetClipboardString(window_.get());
        return text != nullptr ? text : "";
    }
    void set_clipboard(const std::string& text) override {
        glfwSetClipboardString(window_.get(), text.c_str());
    }
    double seconds() const override { return glfwGetTime(); }

  private:
    static constexpr GLenum context_lost = 0x0507;  // GL_CONTEXT_LOST of OpenGL 4.5

    static constexpr std::initializer_list<GLenum> screen_format{GL_RGBA8};

    /// Copies the offscreen target to the display's back buffer, whose content is undefined after a
    /// swap.
    void show_screen() {
        const GladGLContext& gl = context_.gl();
        const glm::ivec2 size = screen_->size();
        screen_->bind();
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        gl.BlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
        screen_->bind();
    }

    /// The display's cursor of a shape, made when it is first wanted; null, the arrow, where the
    /// display has none of that shape.
    GLFWcursor* cursor(PointerShape shape) {
        if (shape == PointerShape::arrow) return nullptr;
        CursorHandle& handle = cursors_[shape];
        if (!handle) handle.reset(glfwCreateStandardCursor(glfw_shape(shape)));
        return handle.get();
    }

    static DesktopWindow& self(GLFWwindow* window) {
        return *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(window));
    }
    InputEvent& add(InputKind kind) { return events_.emplace_back(InputEvent{kind}); }

    /// The modifiers with GLFW's bits for them.
    static constexpr std::array<std::pair<int, const char*>, 3> modifiers{
        {{GLFW_MOD_CONTROL, "Ctrl"}, {GLFW_MOD_SHIFT, "Shift"}, {GLFW_MOD_ALT, "Alt"}}};

    void follow_modifier(const std::string& key, bool down) {
        for (const auto& [bit, name] : modifiers)
            if (key == name) held_ = down ? held_ | bit : held_ & ~bit;
    }
    /// Releases modifiers that the display no longer holds: a window manager that took Alt+F4 kept
    /// the release of Alt.
    void release_unheld(int held) {
        for (const auto& [bit, name] : modifiers) {
            // The other of two keys, such as the Windows key for Ctrl, has no such bit.
            const bool also_super = bit == GLFW_MOD_CONTROL && (held & GLFW_MOD_SUPER) != 0;
            if ((held_ & bit) == 0 || (held & bit) != 0 || also_super) continue;
            add(InputKind::key).text = name;
            held_ &= ~bit;
        }
    }

    void listen() {
        GLFWwindow* const window = window_.get();
        glfwSetWindowUserPointer(window, this);
        glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
            self(w).add(InputKind::move).at = {x, y};
        });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int held) {
            if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
            self(w).release_unheld(held);
            InputEvent& event = self(w).add(InputKind::button);
            event.button = button;
            event.down = action == GLFW_PRESS;
        });
        glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
            self(w).add(InputKind::wheel).at = {x, y};
        });
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int) {
            if (action == GLFW_REPEAT) self(w).news_ = true;  // Dear ImGui repeats keys by itself
            std::string name = name_of_key(key, scancode);
            if (name.empty() || action == GLFW_REPEAT) return;
            InputEvent& event = self(w).add(InputKind::key);
            event.text = std::move(name);
            event.down = action == GLFW_PRESS;
            self(w).follow_modifier(event.text, event.down);
        });
        glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code) {
            self(w).add(InputKind::text).text = utf8(code);
        });
        glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** files) {
            self(w).add(InputKind::drop).files.assign(files, files + count);
        });
        glfwSetWindowSizeCallback(window, [](GLFWwindow* w, int x, int y) {
            self(w).add(InputKind::resize).at = {x, y};
        });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { self(w).news_ = true; });
        glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
            glfwSetWindowShouldClose(w, GLFW_FALSE);  // the program decides, and may ask first
            self(w).add(InputKind::close);
        });
    }

    GlfwLibrary library_;
    WindowHandle window_;
    std::map<PointerShape, CursorHandle> cursors_;
    DesktopContext context_;
    std::optional<GlTarget> screen_;
    std::vector<InputEvent> events_;
    std::atomic<bool> news_ = false;  ///< of other threads or of the display
    int held_ = 0;  ///< GLFW's bits of the modifiers whose press was the last that was heard of
};

}  // namespace

std::unique_ptr<GlWindow> create_desktop_window(const glm::ivec2& size, const std::string& title) {
    return std::make_unique<DesktopWindow>(size, title);
}

}  // namespace burl
