#pragma once
// The scale of the editor's text and panels: steps for keys, and fonts rasterised at that size, so
// that they stay sharp.

namespace burl {

/// The next larger or smaller scale of a fixed list from 0.5 to 4, clamped at its ends; at scale 1
/// the font is 13 pixels high.
double larger_scale(double scale);
double smaller_scale(double scale);

/// Sets style and fonts of ImGui's current context, between frames; the fonts' texture must be
/// uploaded again.
void set_interface_scale(double scale);

/// The scale set last; 0: none yet.
double interface_scale();

}  // namespace burl
