#include "figures.hpp"
#include "parts.hpp"
#include "rounded.hpp"
#include "scenes.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void draw_minkowski_sum(const Studio& studio) {
  figure::Scene scene({66, 32}, 0.09);
  const Environment solid_body{general_sphere_chapter::cut_cube()};
  const double r = 0.35;
  scene.mesh(solid_body.mesh(), {colour::sky, 1, true}, true, 0);
  draw_ridges(scene, solid_body, {66, 32}, 1);
  draw_rounded(scene, solid_body, r, {66, 32}, 2);
  scene.arrow({-0.1, 0.3, 0.8}, {-0.1, 0.3, 0.8 + r}, {colour::red, 2.4}, 3);
  scene.label("{/:Italic r}", {-0.1, 0.3, 0.8 + 0.5 * r}, 0.9, 0, colour::red);
  scene.label("{/:Italic P}", {-0.1, -0.8, -0.1}, 0, 0);
  scene.label("{/:Italic P} ⊕ {/:Italic B}_{/:Italic r}", {1.15, 1.15, 1.15}, 0, 1.6, colour::ink,
              Align::right);
  finish(studio, "minkowski-sum", scene);
}
