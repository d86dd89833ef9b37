#pragma once
// An invisible display (Xvfb) with a mouse and a keyboard (the X test extension), for tests that
// use windows as a person does. The libraries are loaded at run time, so that tests build without
// them and say why they are skipped.
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "atlas/base/vec.h"

namespace burl::test {

/// An Xvfb server on a display of its own, ended by the destructor.
class XServer {
  public:
    /// Starts the server; `screen` is Xvfb's option, such as "1200x900x24".
    explicit XServer(const std::string& screen) {
        int ends[2];
        if (pipe(ends) != 0) return;
        const std::string ready = fmt::format("{}", ends[1]);
        process_ = fork();
        if (process_ == 0) {
            const int nowhere = open("/dev/null", O_RDWR);
            dup2(nowhere, 1);
            dup2(nowhere, 2);
            execlp("Xvfb", "Xvfb", "-displayfd", ready.c_str(), "-screen", "0", screen.c_str(),
                   "-nolisten", "tcp", static_cast<char*>(nullptr));
            _exit(127);
        }
        close(ends[1]);
        read_number(ends[0]);
        close(ends[0]);
    }
    XServer(const XServer&) = delete;
    XServer& operator=(const XServer&) = delete;
    ~XServer() {
        if (process_ <= 0) return;
        kill(process_, SIGTERM);
        waitpid(process_, nullptr, 0);
    }

    /// The display's name, such as ":99"; empty: the server did not start.
    const std::string& display() const { return display_; }

  private:
    /// Reads the number of the display, which the server writes on a line once it accepts
    /// connections.
    void read_number(int from) {
        std::string number;
        pollfd ready{from, POLLIN, 0};
        for (char c = 0; ::poll(&ready, 1, 60000) > 0 && read(from, &c, 1) == 1 && c != '\n';)
            number += c;
        if (!number.empty()) display_ = ":" + number;
    }

    pid_t process_ = -1;
    std::string display_;
};

/// Keeps the libraries loaded now until the process ends, so that the leak checker can name those
/// whose memory display drivers leave behind (tests/lsan.supp).
inline void keep_libraries() {
    std::vector<std::string> names;
    dl_iterate_phdr(
        [](dl_phdr_info* library, std::size_t, void* list) {
            static_cast<std::vector<std::string>*>(list)->emplace_back(library->dlpi_name);
            return 0;
        },
        &names);
    for (const std::string& name : names)
        if (!name.empty()) dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
}

/// Moves the pointer and presses buttons and keys of a display. The server has handled a call when
/// it returns.
class XHand {
  public:
    /// Connects to a display; problem() says why that failed.
    explicit XHand(const std::string& display)
        : x11_(dlopen("libX11.so.6", RTLD_NOW)), xtst_(dlopen("libXtst.so.6", RTLD_NOW)) {
        if (x11_ == nullptr || xtst_ == nullptr) {
            problem_ = "libX11.so.6 or libXtst.so.6 is not installed";
            return;
        }
        display_ = call<void* (*)(const char*)>(x11_, "XOpenDisplay")(display.c_str());
        int number = 0;
        const auto asks =
            call<int (*)(void*, int*, int*, int*, int*)>(xtst_, "XTestQueryExtension");
        if (display_ == nullptr)
            problem_ = fmt::format("no connection to display {}", display);
        else if (asks(display_, &number, &number, &number, &number) == 0)
            problem_ = fmt::format("display {} lacks the X test extension", display);
    }
    XHand(const XHand&) = delete;
    XHand& operator=(const XHand&) = delete;
    ~XHand() {
        if (display_ != nullptr) call<int (*)(void*)>(x11_, "XCloseDisplay")(display_);
    }
    const std::string& problem() const { return problem_; }

    /// Moves the pointer to a position on the screen.
    void move(const glm::dvec2& to) const {
        call<int (*)(void*, int, int, int, unsigned long)>(xtst_, "XTestFakeMotionEvent")(
            display_, -1, int(to.x), int(to.y), 0);
        sync();
    }
    /// Presses or releases a button: 1 left, 2 middle, 3 right.
    void button(unsigned number, bool down) const {
        call<int (*)(void*, unsigned, int, unsigned long)>(xtst_, "XTestFakeButtonEvent")(
            display_, number, down ? 1 : 0, 0);
        sync();
    }
    /// Presses or releases a key by its X name, such as "z", "Control_L" or "F1".
    void key(const std::string& name, bool down) const {
        const auto sym = call<unsigned long (*)(const char*)>(x11_, "XStringToKeysym");
        press(code_of(sym(name.c_str())), down);
    }
    /// Types ASCII text.
    void type(const std::string& text) const {
        for (const char c : text) {
            // Keysyms of Latin-1 characters are their codes.
            const auto sym = static_cast<unsigned char>(c);
            const unsigned char code = code_of(sym);
            const auto plain = call<unsigned long (*)(void*, unsigned char, int, int)>(
                x11_, "XkbKeycodeToKeysym")(display_, code, 0, 0);
            if (plain != sym) key("Shift_L", true);
            press(code, true);
            press(code, false);
            if (plain != sym) key("Shift_L", false);
        }
    }

  private:
    template <class Function>
    static Function call(void* library, const char* name) {
        return reinterpret_cast<Function>(dlsym(library, name));
    }
    unsigned char code_of(unsigned long sym) const {
        return call<unsigned char (*)(void*, unsigned long)>(x11_, "XKeysymToKeycode")(display_,
                                                                                       sym);
    }
    void press(unsigned code, bool down) const {
        call<int (*)(void*, unsigned, int, unsigned long)>(xtst_, "XTestFakeKeyEvent")(
            display_, code, down ? 1 : 0, 0);
        sync();
    }
    void sync() const { call<int (*)(void*, int)>(x11_, "XSync")(display_, 0); }

    void* x11_ = nullptr;
    void* xtst_ = nullptr;
    void* display_ = nullptr;
    std::string problem_;
};

}  // namespace burl::test
