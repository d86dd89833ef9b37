#pragma once
// The size of the editor's text and panels: steps for keys, and fonts drawn at that size, which
// stay sharp.

namespace burl {

/// The next larger or smaller of a few sizes from 0.5 to 4; 1: thirteen pixels a line. At the ends
/// the last one.
double larger_scale(double scale);
double smaller_scale(double scale);

/// Sets style and fonts of ImGui's current context, between frames. The fonts' texture is to be
/// uploaded anew.
void set_interface_scale(double scale);

/// What is set now; 0: nothing yet.
double interface_scale();

}  // namespace burl
