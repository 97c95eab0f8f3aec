#include "figures.hpp"

using namespace first_contact;

void draw_general_sphere_figures(const program::Program& program, const Environment& environment,
                                 const Moving<Sphere>& moving, const std::optional<Contact>& contact) {
  const figure::Studio& studio = program.studio();
  draw_moved_out(studio);
  draw_face_first(studio);
  draw_valley(studio);
  draw_jar(studio);
  draw_lowest_point(program);
  draw_printed_cylinder(program);
  draw_order(program);
  draw_minkowski_sum(studio);
  draw_ray(studio);
  draw_bunny(program);
  draw_jaw(program);
  draw_sweep(studio, environment, moving, contact);
  draw_accuracy(program);
}
