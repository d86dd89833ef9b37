// The only file that knows Embree's headers.
#include "atlas/shape/ray_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>

#include "atlas/base/error.h"

namespace burl {

/// Embree's objects, released with the last tree that shares them.
struct RayTree::Scene {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
};

namespace {

/// A device whose kernels are those of SSE 4.2 on every x86 processor: with AVX2 Embree fuses
/// products and sums, which rounds otherwise, and single rays are only a fifth faster.
RTCDevice one_width_device() {
    RTCDevice device = rtcNewDevice("isa=sse4.2");
    return device ? device : rtcNewDevice(nullptr);
}

void* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t bytes,
                 std::size_t count) {
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, bytes, count);
    if (!buffer) throw Error(ExitCode::runtime, "there is no memory for the rays of this mesh");
    return buffer;
}

void fill(RTCGeometry geometry, std::span<const Vec3d> points,
          std::span<const Triangle> triangles) {
    auto* corners = static_cast<Vec3f*>(new_buffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, sizeof(Vec3f), points.size()));
    std::ranges::transform(points, corners, [](const Vec3d& p) { return Vec3f(p); });
    auto* faces = static_cast<Triangle*>(new_buffer(
        geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, sizeof(Triangle), triangles.size()));
    std::ranges::copy(triangles, faces);
}

void set(RTCRay& to, const ShapeRay& ray, float reach) {
    to.org_x = ray.origin.x, to.org_y = ray.origin.y, to.org_z = ray.origin.z;
    to.dir_x = ray.direction.x, to.dir_y = ray.direction.y, to.dir_z = ray.direction.z;
    to.tnear = 0.0f, to.tfar = reach, to.time = 0.0f;
    to.mask = 0xffffffff, to.id = 0, to.flags = 0;
}

}  // namespace

RayTree::RayTree(std::span<const Vec3d> points, std::span<const Triangle> triangles) {
    auto made = std::make_shared<Scene>();
    made->device = one_width_device();
    if (!made->device) throw Error(ExitCode::runtime, "Embree does not start on this machine");
    made->scene = rtcNewScene(made->device);
    rtcSetSceneFlags(made->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(made->scene, RTC_BUILD_QUALITY_HIGH);
    if (!triangles.empty()) {
        const RTCGeometry geometry = rtcNewGeometry(made->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::shared_ptr<void> released(
            geometry, [](void* g) { rtcReleaseGeometry(static_cast<RTCGeometry>(g)); });
        fill(geometry, points, triangles);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(made->scene, geometry);
    }
    rtcCommitScene(made->scene);
    if (rtcGetDeviceError(made->device) != RTC_ERROR_NONE)
        throw Error(ExitCode::runtime, "there is no memory for the rays of this mesh");
    scene_ = std::move(made);
}

bool RayTree::blocked(const ShapeRay& ray, float reach) const {
    RTCRay asked;
    set(asked, ray, reach);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_->scene, &context, &asked);
    return asked.tfar < 0.0f;
}

std::uint32_t RayTree::nearest(const ShapeRay& ray, float reach) const {
    RTCRayHit asked;
    set(asked.ray, ray, reach);
    asked.hit.geomID = asked.hit.primID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_->scene, &context, &asked);
    return asked.hit.geomID == RTC_INVALID_GEOMETRY_ID ? nothing_met : asked.hit.primID;
}

}  // namespace burl
