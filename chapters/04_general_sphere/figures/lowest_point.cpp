#include "figures.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// A triangle as it is seen along the motion, which is a dot there: the three triangles that the dot makes with
// the edges, green where they are turned like the face, pink where not.
void add_view(figure::Scene& scene, const Point& place, const Point& dot, const std::string& words,
              const Colour& verdict) {
  const std::array<Point, 3> corners{place + at(-2, -1.2), place + at(2, -0.9), place + at(0.3, 1.9)};
  const Point seen = place + dot;
  scene.polygon({corners.begin(), corners.end()}, solid, -2);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &from = corners[i], &to = corners[(i + 1) % 3];
    const bool like_the_face = (to - from).cross(seen - from).z() > 0;
    const Colour& turn = like_the_face ? colour::green : colour::pink;
    scene.polygon({from, to, seen}, {turn, like_the_face ? 0.22 : 0.5, false, Pen{turn, 1.4}},
                  like_the_face ? -1 : 0);
    const Point middle = (from + to + seen) / 3;
    scene.label(like_the_face ? "+" : "−", middle, 0, 0, colour::ink);
  }
  scene.sphere({seen, 0.09}, colour::red, 1, 3);
  scene.label(words, place + at(0, -1.6), 0, 0, verdict);
  scene.dot(place + at(0, -1.8), colour::paper);  // room for the words
}

}  // namespace

void draw_lowest_point(const program::Program& program) {
  figure::Scene scene(from_above, 0.04);
  add_view(scene, at(-2.7, 0), at(0.2, -0.1), program.say({"within the face", "在面內"}), colour::green);
  add_view(scene, at(2.7, 0), at(1.75, 0.75), program.say({"beside it", "在面外"}), colour::pink);
  finish(program.studio(), "lowest-point", scene);
}
