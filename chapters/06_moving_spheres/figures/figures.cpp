#include "figures.hpp"

using namespace first_contact;

void draw_moving_spheres_figures(const program::Program& program, const Moving<Sphere>& p,
                                 const Moving<Sphere>& q) {
  draw_motions(program.studio());
  draw_contact(program.studio());
  draw_distance(program, p, q);
  draw_closest_approach(program.studio(), p, q);
  draw_far_away(program);
  draw_growth(program);
}
