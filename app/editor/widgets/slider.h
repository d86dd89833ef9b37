#pragma once
// A slider of one number: its frame is filled up to the value, and the number stands on top.
// Ctrl-click to type, Shift to move at a tenth of the pointer's speed.

namespace burl {

/// The values at a slider's ends.
struct SliderRange {
    double low = 0.0, high = 1.0;
};

/// The scale of a slider's values along it.
enum class SliderScale {
    linear,
    logarithmic  ///< equal ways are equal factors; the range must be above 0
};

/// Returns the place of a value along the range, clamped to 0..1.
double share_of(double value, const SliderRange& range, SliderScale scale);

/// Draws a slider as wide as ImGui's next item; `id` is its name for ImGui, and `format` that of
/// printf. Returns whether the value changed. While the pointer holds the slider, the value follows
/// how far it has moved, so that pressing or releasing Shift changes the speed and nothing else.
bool slide(const char* id, double& value, const SliderRange& range,
           SliderScale scale = SliderScale::linear, const char* format = "%.4g");

}  // namespace burl
