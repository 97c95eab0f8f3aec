#include "rooms.hpp"

#include "first_contact/sweep/sphere_mesh.hpp"

using namespace first_contact;

//! [rooms]
const std::vector<Rectangle> ground{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}};
const std::vector<Rectangle> crease{ground[0], {{0, 2, 0.9}, {3, 0, 0}, {0, 0, 0.9}}};
const std::vector<Rectangle> corner{{{0.75, 0, 0}, {2.25, 0, 0}, {0, 2, 0}},
                                    {{0.75, 2, 0.9}, {2.25, 0, 0}, {0, 0, 0.9}},
                                    {{3, 0, 0.9}, {0, 2, 0}, {0, 0, 0.9}}};

const Moving<Sphere> into_crease{{{-2.2, -1.2, 1.1}, 0.5}, {4.5, 5, -1.8}};
const Moving<Sphere> into_corner{{{-0.8, -1.4, 1.2}, 0.5}, {5.5, 3, -3}};
//! [rooms]

const Moving<Sphere> over_the_bunny{{{4, -1.2, 9}, 0.5}, {-0.05, 0, -0.06}};

Mesh walls(const std::vector<Rectangle>& rectangles) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const auto& [middle, u, v] : rectangles) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {middle - u - v, middle + u - v, middle + u + v, middle - u + v});
    faces.push_back({first, first + 1, first + 2});
    faces.push_back({first, first + 2, first + 3});
  }
  return {std::move(vertices), std::move(faces)};
}

std::vector<Rectangle> ground_with_wall(const Vector& wall) {
  std::vector<Rectangle> room = ground;
  if (!wall.isZero(0)) room.push_back({Point(1, 0, 0) + 0.5 * wall, 0.5 * wall, {0, 2, 0}});
  return room;
}

//! [slide_frames]
Frames slide_frames(const Moving<Sphere>& ball, const Environment& environment, int frames) {
  Frames run{{ball.shape.center}};
  for (int frame = 0; frame < frames; ++frame) {
    const Sphere now{run.positions.back(), ball.shape.radius};
    const Slide path = slide(Moving<Sphere>{now, ball.displacement}, environment);
    run.positions.push_back(path.end());
    run.contacts += path.contacts.size();
  }
  return run;
}
//! [slide_frames]
