// JPEG through libjpeg-turbo, which reports errors by longjmp: what calls it after setjmp holds
// nothing with a destructor, and callbacks let no exception out.
#include <array>
#include <exception>

#include "app/image/jpeg_errors.h"
#include "app/image/picture_coding.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

/// Beyond as many pixels, Huffman codes are JPEG's own: made-to-measure ones need all coefficients
/// in memory, six bytes a pixel.
constexpr std::uint64_t most_measured = 1u << 26;

/// libjpeg's target of bytes: a buffer that goes to the sink when it is full.
struct JpegTarget {
    ::jpeg_destination_mgr manager{};  // the first member
    const ByteSink* sink = nullptr;
    std::exception_ptr thrown{};
    std::array<std::uint8_t, 1u << 16> buffer{};
};

/// Passes bytes of the buffer on; false where the sink throws.
bool pass_on(JpegTarget& target, std::size_t count) {
    try {
        (*target.sink)({target.buffer.data(), count});
    } catch (...) {
        target.thrown = std::current_exception();
        return false;
    }
    return true;
}

void start_buffer(::j_compress_ptr jpeg) {
    auto* target = reinterpret_cast<JpegTarget*>(jpeg->dest);
    target->manager.next_output_byte = target->buffer.data();
    target->manager.free_in_buffer = target->buffer.size();
}

void stop_at_sink(::j_compress_ptr jpeg) {
    std::longjmp(reinterpret_cast<JpegErrors*>(jpeg->err)->jump, 1);
}

::boolean on_full(::j_compress_ptr jpeg) {
    auto* target = reinterpret_cast<JpegTarget*>(jpeg->dest);
    if (!pass_on(*target, target->buffer.size())) stop_at_sink(jpeg);
    start_buffer(jpeg);
    return TRUE;
}

void on_end(::j_compress_ptr jpeg) {
    auto* target = reinterpret_cast<JpegTarget*>(jpeg->dest);
    const std::size_t count = target->buffer.size() - target->manager.free_in_buffer;
    if (count > 0 && !pass_on(*target, count)) stop_at_sink(jpeg);
}

/// The owner of libjpeg's struct.
struct JpegWriter {
    ::jpeg_compress_struct jpeg{};
    JpegErrors errors;
    JpegTarget target;

    explicit JpegWriter(const ByteSink& sink) {
        jpeg.err = ::jpeg_std_error(&errors.manager);
        errors.manager.error_exit = on_jpeg_error;
        target.sink = &sink;
        target.manager.init_destination = start_buffer;
        target.manager.empty_output_buffer = on_full;
        target.manager.term_destination = on_end;
    }
    ~JpegWriter() { ::jpeg_destroy_compress(&jpeg); }
    JpegWriter(const JpegWriter&) = delete;
    JpegWriter& operator=(const JpegWriter&) = delete;
};

void set_method(::jpeg_compress_struct& jpeg, const CodeRaster& raster, int quality) {
    jpeg.image_width = ::JDIMENSION(raster.width);
    jpeg.image_height = ::JDIMENSION(raster.height);
    jpeg.input_components = int(raster.components);
    jpeg.in_color_space = raster.components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    ::jpeg_set_defaults(&jpeg);
    ::jpeg_set_quality(&jpeg, quality, TRUE);
    for (int c = 0; c < jpeg.num_components; ++c)
        jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
    jpeg.dct_method = JDCT_ISLOW;
    jpeg.optimize_coding = raster.width * raster.height <= most_measured ? TRUE : FALSE;
}

bool write_jpeg(JpegWriter& writer, const CodeRaster& raster, int quality, TaskMeter* meter) {
    if (setjmp(writer.errors.jump)) return false;
    ::jpeg_create_compress(&writer.jpeg);
    writer.jpeg.dest = &writer.target.manager;
    set_method(writer.jpeg, raster, quality);
    ::jpeg_start_compress(&writer.jpeg, TRUE);
    const std::size_t stride = raster.stride();
    while (writer.jpeg.next_scanline < writer.jpeg.image_height) {
        // libjpeg only reads the row although it takes it as its own.
        auto* row = const_cast<::JSAMPROW>(raster.pixels + writer.jpeg.next_scanline * stride);
        ::jpeg_write_scanlines(&writer.jpeg, &row, 1);
        if (meter) meter->add(stride);
    }
    ::jpeg_finish_compress(&writer.jpeg);
    return true;
}

}  // namespace

void encode_jpeg(const CodeRaster& raster, const ByteSink& sink, int quality, TaskMeter* meter) {
    JpegWriter writer(sink);
    if (write_jpeg(writer, raster, quality, meter)) return;
    if (writer.target.thrown) std::rethrow_exception(writer.target.thrown);
    throw Error(ExitCode::runtime,
                fmt::format("the JPEG image of {} x {} could not be encoded: {}", raster.width,
                            raster.height, writer.errors.message.data()));
}

}  // namespace burl
