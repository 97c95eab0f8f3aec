#include "camera.hpp"
#include "figures.hpp"
#include "parts.hpp"
#include "studies.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

void draw_seen_from(const View& view, const char* name, const Studio& studio) {
  const Transform back = box_chapter::camera().inverse();
  const auto corner = [&](double x, double y, double z) { return back.point({x, y, z}); };
  figure::Scene scene(view, 0.03);
  const std::array<Eigen::Vector2d, 4> around{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  std::vector<Point> near, far;
  for (const auto& p : around) {
    near.push_back(corner(p.x(), p.y(), -1));
    far.push_back(corner(p.x(), p.y(), 1));
    scene.line({Point(0, 0, 0), near.back()}, offset_edge, 0);
  }
  const Pen edge{colour::blue, 1.4};
  scene.polygon(far, {colour::sky, 0.18, false, edge}, -2);
  scene.polygon({near[0], near[1], far[1], far[0]}, {colour::sky, 0.30, false, edge}, -2);
  const auto sights = box_chapter::sights();
  for (const auto& sight : sights) {
    const Colour& kept = &sight == &sights.back() ? colour::amber : colour::green;
    scene.box(sight.box, {sight.rejected ? colour::pale : kept, 1, true}, 0);
    const Point above = sight.box.center + Vector(0, 0.5, 0.75);
    if (sight.rejected) scene.label("{/:Italic E}·{/:Italic Q} < −{/:Italic r}_{eff}", above, 0, 0.9);
    scene.label("", sight.box.center + Vector(0.6, 0, 0));  // room for what stands above
  }
  scene.polygon(near, {colour::sky, 0.18, false, edge}, 1);
  for (const std::size_t i : {2U, 3U}) scene.line({near[i], far[i]}, edge, 1);
  scene.dot({0, 0, 0});
  Figure figure(studio, name, scene.size());
  scene.draw(figure);
  figure.draw();
}

}  // namespace

void draw_frustum(const Studio& studio) {
  draw_seen_from({42, -12}, "frustum", studio);
  draw_seen_from({0, 0}, "frustum-above", studio);
}
