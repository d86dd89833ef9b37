// Offscreen windows for scripts and tests, with a clipboard and a clock of their own.
#include <algorithm>
#include <atomic>
#include <initializer_list>
#include <optional>
#include <utility>

#include "app/editor/window/window.h"
#include "app/gl/device/target.h"

namespace burl {

namespace {

class UnseenWindow final : public GlWindow {
  public:
    UnseenWindow(std::unique_ptr<GlContext> context, const glm::ivec2& size)
        : context_(std::move(context)),
          size_(size),
          screen_(std::in_place, context_->gl(), size, screen_format) {}

    GlContext& context() override { return *context_; }
    glm::ivec2 size() const override { return size_; }
    glm::ivec2 pixels() const override { return size_; }
    void bind_screen() override { screen_->bind(); }
    void present() override { seconds_ += 1.0 / 60.0; }
    std::vector<InputEvent> poll(double) override { return {}; }
    void wake() override { woken_ = true; }
    bool take_news() override { return woken_.exchange(false); }
    void resize(const glm::ivec2& size) override {
        if (size == size_ || size.x < 1 || size.y < 1) return;
        screen_.emplace(context_->gl(), size, screen_format);
        size_ = size;
    }
    void set_title(const std::string&) override {}
    std::string clipboard() const override { return clipboard_; }
    void set_clipboard(const std::string& text) override { clipboard_ = text; }
    double seconds() const override { return seconds_; }

  private:
    static constexpr std::initializer_list<GLenum> screen_format{GL_RGBA8};

    std::unique_ptr<GlContext> context_;
    glm::ivec2 size_;
    std::optional<GlTarget> screen_;
    std::string clipboard_;
    double seconds_ = 0.0;
    std::atomic<bool> woken_ = false;
};

}  // namespace

std::unique_ptr<GlWindow> create_unseen_window(std::unique_ptr<GlContext> context,
                                               const glm::ivec2& size) {
    return std::make_unique<UnseenWindow>(std::move(context), size);
}

Image<Rgb8> read_screen(const GlWindow& window, const GladGLContext& gl) {
    const glm::ivec2 size = window.pixels();
    Image<Rgb8> upside_down(std::size_t(size.x), std::size_t(size.y));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.ReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, upside_down.row(0).data());
    check_gl(gl, "reading the screen");
    Image<Rgb8> picture(upside_down.width(), upside_down.height());
    for (std::size_t y = 0; y < picture.height(); ++y)
        std::ranges::copy(upside_down.row(picture.height() - 1 - y), picture.row(y).begin());
    return picture;
}

}  // namespace burl
