#include "figures.hpp"

using namespace first_contact;

void draw_plane_figures(const program::Program& program, const Plane& plane, const Moving<Sphere>& ball,
                        const std::optional<Contact>& contact) {
  draw_definition(program.studio());
  draw_touch(program.studio());
  draw_unit_normal(program);
  draw_sweep(program.studio(), plane, ball, contact);
}
