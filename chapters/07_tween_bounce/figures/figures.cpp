#include "figures.hpp"

using namespace first_contact::program;

void draw_tween_bounce_figures(const Program& program, const tween_bounce::Flight& flight,
                               const tween_bounce::Flight& printed, const tween_bounce::Flight& physical) {
  tween_bounce::draw_paper_figures(program, flight);
  tween_bounce::draw_bounces(program, printed, physical);
  tween_bounce::draw_tweens(program);
}
