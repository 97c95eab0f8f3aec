#include "jaw.hpp"

#include <array>
#include <cmath>
#include <numbers>

using namespace first_contact;

namespace jaw {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degrees = 180 / pi;

//! [bones]
/// A bone's section: where its middle is seen from above, which way it is thick, and from where to where it
/// stands.
struct Section {
  double x, y;                // of the middle
  double across_x, across_y;  // half its thickness
  double low, high;
};

// A bone as a tube of six-sided sections, pointed above and below, closed at its ends.
Mesh bone(const std::vector<Section>& sections) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const auto& [x, y, ax, ay, low, high] : sections) {
    const double bevel = std::min(0.14, 0.3 * (high - low));
    for (const auto& [side, z] : {std::pair(0, low),
                                  {1, low + bevel},
                                  {1, high - bevel},
                                  {0, high},
                                  {-1, high - bevel},
                                  {-1, low + bevel}})
      vertices.emplace_back(x + side * ax, y + side * ay, z);
  }
  const auto rings = static_cast<std::uint32_t>(sections.size());
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    for (std::uint32_t k = 0; k < 6; ++k) {
      const std::uint32_t a = 6 * ring + k, b = 6 * ring + (k + 1) % 6;
      faces.push_back({a, a + 6, b + 6});
      faces.push_back({a, b + 6, b});
    }
  const std::uint32_t last = 6 * (rings - 1);
  for (std::uint32_t k = 1; k < 5; ++k) {
    faces.push_back({0, k, k + 1});
    faces.push_back({last, last + k + 1, last + k});
  }
  return {std::move(vertices), std::move(faces)};
}

// The same on the other side of the plane y = 0; the faces are turned round so that they look outward again.
Mesh mirrored(const Mesh& mesh) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const Point& p : mesh.vertices()) vertices.emplace_back(p.x(), -p.y(), p.z());
  for (const auto& [a, b, c] : mesh.faces()) faces.push_back({a, c, b});
  return {std::move(vertices), std::move(faces)};
}
//! [bones]

}  // namespace

const double opening = 40 / degrees;

//! [jaw]
Mesh jaw_bone(double spur) {
  const double y = 2.2;
  std::vector<Section> half{
      // from the joint forwards: condyle, notch, coronoid process, body
      {-0.32, y, 0, 0.16, -1.3, -0.2},        {-0.18, y, 0, 0.26, -2.0, 0.14},
      {0.0, y, 0, 0.28, -2.35, 0.2},          {0.22, y, 0, 0.24, -2.5, 0.06},
      {0.45, y, 0, 0.2, -2.6, -0.45},         {0.8, y, 0, 0.19, -2.65, -0.6},
      {1.0, y, 0, 0.19, -2.66, -0.3},         {1.15, y, 0, 0.18, -2.67, spur - 0.75},
      {1.27, y, 0, 0.15, -2.67, spur - 0.12}, {1.38, y, 0, 0.13, -2.68, spur},
      {1.52, y, 0, 0.14, -2.68, spur - 0.2},  {1.64, y, 0, 0.18, -2.69, std::min(spur - 0.8, 0.4)},
      {1.75, y, 0, 0.2, -2.7, -0.55},         {1.95, y, 0, 0.24, -2.7, -1.3}};
  for (int i = 0; i <= 6; ++i) {  // round the arch to the chin
    const double turn = (0.08 + 0.92 * i / 6) * pi / 2, s = std::sin(turn), c = std::cos(turn);
    const double thick = 0.26 / std::hypot(y * s, 2.7 * c);
    half.push_back({2.0 + 2.7 * s, y * c, thick * y * s, thick * 2.7 * c, -2.72 - 0.3 * s, -1.62 - 0.35 * s});
  }
  std::vector<Section> whole = half;
  for (std::size_t i = half.size() - 1; i-- > 0;) {
    const auto& [x, at, ax, ay, low, high] = half[i];
    whole.push_back({x, -at, -ax, ay, low, high});
  }
  return bone(whole);
}

Mesh cheek_bone(double side) {
  const Mesh left = bone({{-0.7, 2.7, -0.03, 0.1, 0.2, 0.55},
                          {0.3, 2.93, -0.01, 0.1, 0.22, 0.52},
                          {1.0, 2.96, 0.01, 0.1, 0.2, 0.55},
                          {1.5, 2.85, 0.05, 0.14, 0.05, 0.68},
                          {1.95, 2.58, 0.12, 0.14, -0.32, 0.85},
                          {2.3, 2.2, 0.15, 0.11, -0.5, 0.8},
                          {2.62, 1.7, 0.14, 0.08, -0.55, 0.4}});
  return side > 0 ? left : mirrored(left);
}

Turning<Mesh> opening_jaw(double spur) { return {jaw_bone(spur), {0, 0, 0}, {0, 1, 0}, opening}; }
//! [jaw]

//! [jaw_report]
void tell(program::Program& program) {
  program::Report& report = program.report();
  const Mesh cheek = cheek_bone(-1);
  report.say({"Virtual reality (3.2.4, figure 16): a jaw opens by 40 degrees. Does it touch the cheek bone?",
              "虛擬實境（3.2.4，圖十六）：下顎張口 40 度，冠狀突與顴骨是否碰撞？"});
  const auto usual_one = sweep(opening_jaw(usual), cheek), long_one = sweep(opening_jaw(grown), cheek);
  report.row("usual spur", std::string(usual_one ? "touches" : "free"),
             {"the coronoid process passes below the cheek bone", "冠狀突自顴骨下方通過"});
  if (!long_one) return;
  const double turned = long_one->time * opening * degrees;
  program
      .row("long spur", program::Shown{turned, program::readable(turned) + " degrees"},
           {"it is stopped by the cheek bone at this opening", "張口至此角度時碰到顴骨"})
      .value("jaw_contact_degrees");
  program.value("jaw_opening_degrees", opening * degrees);
  program.value("jaw_triangles", jaw_bone(grown).size());
  program.value("cheek_triangles", cheek.size());
}
//! [jaw_report]

}  // namespace jaw
