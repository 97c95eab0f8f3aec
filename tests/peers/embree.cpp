// Embree's ray of the sphere's centre: how fast a tree can be gone through at all. Single precision; no
// sphere's answer.
#include <embree3/rtcore.h>

#include "peers/ways.hpp"

namespace {

using namespace peers;

struct Scene {
  explicit Scene(const Mesh& mesh) : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices().size()));
    for (const Point& p : mesh.vertices())
      for (const double x : p) *corner++ = static_cast<float>(x);
    auto* number = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.size()));
    for (const Mesh::Face& face : mesh.faces()) number = std::copy(face.begin(), face.end(), number);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  double ray(const Moving<Sphere>& moving) const {
    const Eigen::Vector3f from = moving.shape.center.cast<float>(), along = moving.displacement.cast<float>();
    RTCRayHit hit{};
    hit.ray.org_x = from.x(), hit.ray.org_y = from.y(), hit.ray.org_z = from.z();
    hit.ray.dir_x = along.x(), hit.ray.dir_y = along.y(), hit.ray.dir_z = along.z();
    hit.ray.tfar = 1;
    hit.ray.mask = ~0U;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &hit);
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? never : static_cast<double>(hit.ray.tfar);
  }

 private:
  RTCDevice device;
  RTCScene scene;
};

const Entry entry([](const Mesh& mesh) {
  const auto scene = std::make_shared<const Scene>(mesh);
  Way way = one_by_one("Embree, centre ray", [scene](const auto& cast) { return scene->ray(cast); });
  way.of_spheres = false;
  return way;
});

}  // namespace
