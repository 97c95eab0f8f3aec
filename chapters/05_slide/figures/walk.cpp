#include "figures.hpp"
#include "first_contact/figure/scene.hpp"
#include "first_contact/program/terrain.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// Of a terrain's (n + 1)^2 vertices (cells + 1)^2: enough to see its hills.
Mesh thinned(const Mesh& terrain, std::uint32_t n, std::uint32_t cells) {
  const auto nth = [&](std::uint32_t i) { return (2 * i * n + cells) / (2 * cells); };  // rounded
  std::vector<Point> vertices;
  for (std::uint32_t j = 0; j <= cells; ++j)
    for (std::uint32_t i = 0; i <= cells; ++i)
      vertices.push_back(terrain.vertices()[nth(j) * (n + 1) + nth(i)]);
  return {std::move(vertices), program::grid_faces(cells)};
}

// A walk in lines, cut where the ball was set down again; of frames that lie close together one is enough.
void add_trail(figure::Scene& scene, const std::vector<Point>& trail, double radius) {
  const Pen pen{colour::green, 2};
  std::vector<Point> line;
  for (const Point& p : trail) {
    const double step = line.empty() ? 0 : (p - line.back()).norm();
    if (step > 3 * radius) {  // no frame is longer than two radii
      scene.line(line, pen, 2);
      line.clear();
    }
    if (line.empty() || step > radius / 4) line.push_back(p);
  }
  scene.line(line, pen, 2);
}

}  // namespace

void draw_walk(const Studio& studio, const walks::Ground& terrain, const walks::Walk& walk) {
  figure::Scene scene({48, -24}, 0.02);
  scene.mesh(thinned(terrain.mesh, 100, 33), {colour::floor, 1, true}, false, -1);
  add_trail(scene, walk.trail, terrain.ball.radius);
  scene.sphere(terrain.ball, colour::amber, 1, 3, 10);
  Figure figure(studio, "walk", scene.size());
  scene.draw(figure);
  figure.draw();
}
