#include "figures.hpp"

using namespace first_contact;

void draw_box_figures(const program::Program& program, const Plane& plane, const Moving<Box>& moving,
                      const std::optional<Contact>& contact) {
  draw_bounding_shapes(program.studio());
  draw_effective_radius(program.studio());
  draw_sweep(program.studio(), plane, moving, contact);
  draw_landings(program.studio());
  draw_signs(program);
  draw_tightness(program.studio());
  draw_frustum(program.studio());
}
