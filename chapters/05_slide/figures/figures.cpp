#include "figures.hpp"

using namespace first_contact;

void draw_slide_figures(const program::Program& program, const Environment& environment,
                        const Moving<Sphere>& ball, const Slide& path) {
  draw_projection(program.studio());
  draw_half_sunk(program);
  draw_room(program.studio(), "crease", crease, into_crease);
  draw_room(program.studio(), "corner", corner, into_corner);
  draw_wedge(program);
  draw_jitter(program);
  draw_gap(program);
  draw_bunny(program.studio());
  draw_run(program.studio(), environment, ball, path);
}
