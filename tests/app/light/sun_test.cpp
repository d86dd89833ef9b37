// A sun taken from its sky, and surfaces in both, against sums over all directions.
#include "app/light/sun.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "app/direct/traced_light.h"
#include "app/light/brdf.h"
#include "app/light/microfacets.h"
#include "app/light/prefilter.h"

namespace burl {
namespace {

using std::numbers::pi;

/// Light of a small solid angle.
struct Ray {
    Vec3d direction, light;
};

/// The map cut into rays, of which a pixel that is bright or beside a bright one has 64.
std::vector<Ray> rays_of(const Environment& e) {
    const double width = double(e.radiance.width()), height = double(e.radiance.height());
    std::vector<Ray> rays;
    for (std::size_t y = 0; y < e.radiance.height(); ++y)
        for (std::size_t x = 0; x < e.radiance.width(); ++x) {
            double brightest = 0.0;
            for (int k = 0; k < 9; ++k) {
                const Vec2d at(double(x) + 0.5 * (k % 3), double(y) + 0.5 * (k / 3));
                brightest = std::max(brightest, light_at(e, at / Vec2d(width, height)).g);
            }
            const int n = brightest > 20.0 ? 8 : 1;
            for (int k = 0; k < n * n; ++k) {
                const Vec2d uv((double(x) + (k % n + 0.5) / n) / width,
                               (double(y) + (k / n + 0.5) / n) / height);
                const double solid = 2.0 * pi * pi / (width * height * n * n) * std::sin(pi * uv.y);
                rays.push_back({direction_at(uv), solid * light_at(e, uv)});
            }
        }
    return rays;
}

Vec3d sum_over(const std::vector<Ray>& rays, const ShadedPoint& point, const Vec3d& normal,
               const Vec3d& view) {
    Vec3d sum(0.0);
    for (const Ray& ray : rays) sum += reflected(point, normal, view, ray.direction) * ray.light;
    return sum;
}

double flux(const Environment& e) {
    double sum = 0.0;
    for (std::size_t y = 0; y < e.radiance.height(); ++y)
        for (const RgbF& p : e.radiance.row(y))
            sum += double(p.g) * std::sin(pi * (double(y) + 0.5) / double(e.radiance.height()));
    return sum * 2.0 * pi * pi / double(e.radiance.pixels().size());
}

Environment lamp(double radius, double light) {
    const Vec3d middle = glm::normalize(Vec3d(0.4, 0.6, -0.5));
    Environment e{Image<RgbF>(512, 256)};
    for (std::size_t y = 0; y < 256; ++y)
        for (std::size_t x = 0; x < 512; ++x) {
            const Vec3d d = direction_at({(double(x) + 0.5) / 512.0, (double(y) + 0.5) / 256.0});
            const float seen = std::acos(glm::dot(d, middle)) < radius ? float(light) : 0.0f;
            e.radiance(x, y) = {0.5f + seen, 0.5f + seen, 0.5f + seen};
        }
    return e;
}

TEST(Sun, TheSkyHasOne) {
    const Environment e = make_environment("sun");
    const auto [sun, sky] = without_sun(e);
    ASSERT_TRUE(sun.shines());
    EXPECT_NEAR(double(sun.direction.y), std::sin(34.0 * pi / 180.0), 1e-3);
    EXPECT_NEAR(double(sun.radius), 1.2 * pi / 180.0, 0.15 * pi / 180.0);
    EXPECT_NEAR(double(sun.light.g) + flux(sky), flux(e), 1e-3 * flux(e));
    EXPECT_GT(double(sun.light.g), 0.3 * flux(e));
}

TEST(Sun, OtherRoomsHaveNone) {
    for (const char* name : {"studio", "overcast", "dusk", "warehouse", "neutral"}) {
        const Environment e = make_environment(name);
        const auto [sun, sky] = without_sun(e);
        EXPECT_FALSE(sun.shines()) << name;
        EXPECT_EQ(sky.radiance, e.radiance) << name;
    }
    EXPECT_TRUE(without_sun(lamp(0.02, 4000.0)).sun.shines());
    EXPECT_FALSE(without_sun(lamp(0.02, 20.0)).sun.shines()) << "too weak";
    EXPECT_FALSE(without_sun(lamp(0.12, 4000.0)).sun.shines()) << "too large";
}

/// Discs of slopes by midpoints, seen along the normal, where light's discs are discs of slopes.
TEST(Sun, LobesOverDiscsAreMeansOfLobes) {
    const double radius = 0.04;
    for (const double alpha : {0.002, 0.01, 0.05, 0.3, 1.0})
        for (const double off : {0.0, 0.01, 0.03, 0.1, 0.4}) {
            const double h = 0.5 * off, c = std::cos(h);
            const double size = 0.5 * radius / std::sqrt(c * c * c * c);  // in slopes
            double sum = 0.0;
            constexpr int rings = 400, spokes = 200;
            for (int i = 0; i < rings; ++i)
                for (int k = 0; k < spokes; ++k) {
                    const double share = (i + 0.5) / rings, r = size * share;
                    const double turn = 2.0 * pi * (k + 0.5) / spokes;
                    const double x = std::tan(h) + r * std::cos(turn), y = r * std::sin(turn);
                    const double a2 = alpha * alpha, d = a2 + x * x + y * y;
                    sum += 2.0 * share * a2 / (pi * d * d) / (rings * spokes);
                }
            const double want = sum / std::pow(c, 4.0);
            EXPECT_NEAR(ggx_over_disc(c, c, alpha, radius), want, 0.01 * want)
                << alpha << " " << off;
        }
}

/// Where the half vector lies at the horizon, as for bumps that turn away from light and view.
TEST(Sun, LobesOverDiscsStayLobesAtTheHorizon) {
    for (const double alpha : {0.01, 0.1, 0.6, 1.0})
        for (const double cosine : {1e-6, 1e-3, 0.1, 0.4}) {
            const double lobe = ggx(cosine, alpha);
            EXPECT_NEAR(ggx_over_disc(cosine, 0.5, alpha, 0.05), lobe, 0.02 * lobe) << cosine;
        }
}

struct Case {
    const char* name;
    double metallic, roughness, specular;
    double summed, drawn;  ///< greatest relative differences of the light traced and prefiltered
};

/// Normals of the half of a ball that a view sees, and of bumps that turn away from it.
std::vector<Vec3d> seen_normals(const Vec3d& view, int count) {
    const Vec3d right = glm::normalize(glm::cross(Vec3d(0.0, 1.0, 0.0), view));
    const Vec3d up = glm::cross(view, right);
    std::vector<Vec3d> normals;
    for (int i = 0; i < count; ++i) {
        const double z = i % 10 == 9 ? -0.02 * i / count : std::sqrt((i + 0.5) / count);
        const double out = std::sqrt(1.0 - z * z);
        normals.push_back(out * std::cos(2.4 * i) * right + out * std::sin(2.4 * i) * up +
                          z * view);
    }
    return normals;
}

/// Root mean square difference over the root mean square, of light cut at 2.
class Difference {
  public:
    void add(const Vec3d& made, const Vec3d& truth) {
        const Vec3d a = glm::min(made, Vec3d(2.0)), b = glm::min(truth, Vec3d(2.0));
        square_ += glm::dot(a - b, a - b), whole_ += glm::dot(b, b);
    }
    double share() const { return std::sqrt(square_ / whole_); }

  private:
    double square_ = 0.0, whole_ = 0.0;
};

/// Smooth balls, which throw no shadow on themselves.
TEST(Sun, BallsShowTheSumOverTheirSky) {
    const Environment e = make_environment("sun", 128);
    const std::vector<Ray> rays = rays_of(e);
    const PrefilteredLight light = prefilter(e, 128);
    const TracedLight traced(e, 256, nullptr);
    const Vec3d view = glm::normalize(Vec3d(0.3, 0.35, 0.9));
    for (const Case& one :
         {Case{"white", 0.0, 1.0, 0.0, 0.02, 0.01}, Case{"plastic", 0.0, 0.3, 1.0, 0.02, 0.02},
          Case{"metal", 1.0, 0.3, 1.0, 0.02, 0.04},
          Case{"dull metal", 1.0, 0.6, 1.0, 0.02, 0.04}}) {
        ShadedPoint point;
        point.base = {0.9, 0.75, 0.4}, point.metallic = one.metallic;
        point.roughness = one.roughness, point.specular = one.specular;
        Difference drawn, summed;
        for (const Vec3d& normal : seen_normals(view, 60)) {
            const Vec3d truth = sum_over(rays, point, normal, view);
            drawn.add(ambient_shading(point, normal, view, light), truth);
            Vec3d mean(0.0);
            for (int part = 0; part < 4; ++part)
                mean += 0.25 * traced(point, {{}, {}, normal, normal, view}, {11, part});
            summed.add(mean, truth);
        }
        EXPECT_LT(drawn.share(), one.drawn) << one.name;
        EXPECT_LT(summed.share(), one.summed) << one.name;
    }
}

/// Below the surface without bumps the sun does not shine on bumps.
TEST(Sun, ItShinesOnlyAboveTheSurface) {
    const PrefilteredLight light = prefilter(make_environment("sun", 128), 64);
    const Vec3d sun(light.sun.direction), view = glm::normalize(Vec3d(-sun.x, 3.0, -sun.z));
    ShadedPoint point;
    point.coat_normal = glm::normalize(Vec3d(-sun.x, 0.3 * sun.y, -sun.z));
    const Vec3d hidden = ambient_shading(point, sun, view, light);
    point.coat_normal = sun;
    const Vec3d open = ambient_shading(point, sun, view, light);
    EXPECT_GT(open.g - hidden.g, 0.9 * double(light.sun.light.g) / pi * 0.9);
}

}  // namespace
}  // namespace burl
