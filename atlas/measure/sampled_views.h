#pragma once
// Views as graphics hardware samples them: what pixels that look at the surface from anywhere
// should show, by rays. They depend on the mesh and the texture's size only, so that one truth
// serves all atlases. A view is local, a pixel with its camera at one point of the surface: the
// picture's rows lie along the horizon, the projection is parallel, and the triangle's plane gives
// the steps from pixel to pixel, as it does on graphics hardware.
#include <array>
#include <cstdint>
#include <vector>

#include "atlas/measure/surface_mean.h"
#include "atlas/measure/surface_points.h"

namespace burl {

/// Unit directions in the plane of a point's triangle, at right angles: along a footprint and
/// across it.
struct FootprintAxes {
    Vec3d along{0.0}, across{0.0};
};

/// A direction of the triangle's plane at `turn` (0..1) of a full turn, and the direction at right
/// angles to it. The triangle must have area.
FootprintAxes random_axes(const Mesh& mesh, std::uint32_t triangle, double turn);

/// How far and from which side the views look.
struct ViewOptions {
    std::size_t points = 2000;  ///< number of pixels in each row
    /// Sides of a pixel where the surface is seen straight on, in texels.
    std::vector<double> minifications{1.0, 2.0, 4.0, 8.0, 16.0};
    /// Angles between the line of sight and the surface's normal, in degrees, each below 90.
    std::vector<double> tilts{0.0, 30.0, 60.0, 75.0, 85.0};
    /// The root of the number of rays through a pixel, for each of the two quadratures.
    std::uint32_t rays = 6;
    std::uint64_t seed = 1;
};

/// The steps on a triangle's plane, in mesh units, from pixel to pixel along the screen's axes.
struct PixelSteps {
    Vec3d x{0.0}, y{0.0};
};

/// The true colours of the pixels of one minification and tilt.
struct ViewRow {
    double minification = 1.0, tilt = 0.0;  ///< as in ViewOptions
    std::vector<Vec3d> means;               ///< mean of two quadratures at each point
    /// RMS error of the means: half the RMS difference of the two quadratures.
    double noise = 0.0;
};

/// All rows share their pixels: the point in a pixel's centre, and the side it is seen from.
struct SampledViews {
    std::vector<SurfacePoint> points;
    std::vector<FootprintAxes> axes;  ///< `along` points to the camera's side, at random
    double texel = 0.0;               ///< side of a texel, in mesh units
    std::vector<ViewRow> rows;        ///< tilts of the first minification, then of the next

    /// The steps at point `i` in a row.
    PixelSteps steps(std::size_t i, const ViewRow& row) const;
};

/// The views of a texture f on the mesh's surface. A row's mean at a point is that of f over what
/// the pixel's square shows of the surface round the point: on each ray, of the places that face
/// the camera, the one nearest to the plane of the point's triangle, within two steps of it. Other
/// parts of the mesh hide nothing, and rays that pass by the surface count for nothing. `texel` > 0
/// is in mesh units.
SampledViews sample_views(const Mesh& mesh, const SolidColor& f, double texel,
                          const ViewOptions& options);

/// The number of calls of f by sample_views(), at most.
double view_calls(const ViewOptions& options);

}  // namespace burl
