#pragma once
// libjpeg's errors, which it reports by longjmp: what calls it after setjmp holds nothing with a
// destructor.
#include <array>
#include <csetjmp>
#include <cstdio>

#include <jerror.h>
#include <jpeglib.h>

namespace burl {

/// libjpeg's error handler, and where it jumps.
struct JpegErrors {
    ::jpeg_error_mgr manager{};  // the first member, since libjpeg knows its address only
    std::jmp_buf jump;
    std::array<char, JMSG_LENGTH_MAX> message{};
};

inline void on_jpeg_error(::j_common_ptr jpeg) {
    auto* errors = reinterpret_cast<JpegErrors*>(jpeg->err);
    errors->manager.format_message(jpeg, errors->message.data());
    std::longjmp(errors->jump, 1);
}

}  // namespace burl
