// A surface of triangles: a ball, a point and a box fall on it; what lies on it overlaps it.
#include <cstdio>

#include "first_contact/first_contact.hpp"

int main() {
  using namespace first_contact;
  const Mesh square{{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const Vector fall(0, 0, -4);
  const Environment plain(square);  // the plain way
  const Bvh fast(square);           // the fast way, to the same bits
  const auto ball = sweep(Moving{Sphere{Point(1, 2, 3), 1}, fall}, fast);
  const auto same = sweep(Moving{Sphere{Point(1, 2, 3), 1}, fall}, plain);
  const auto point = sweep(Moving{Point(1, 2, 3), fall}, fast);
  const auto box = sweep(Moving{Box{{1, 2, 3}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, fall}, plain);
  if (!ball || !same || !point || !box) return 1;
  std::printf("ball %g, point %g, box %g\n", ball->time, point->time, box->time);
  const bool lies = overlap(Sphere{Point(1, 2, 1), 1}, plain);
  return ball->time == 0.5 && same->time == 0.5 && point->time == 0.75 && box->time == 0.5 && lies ? 0 : 1;
}
