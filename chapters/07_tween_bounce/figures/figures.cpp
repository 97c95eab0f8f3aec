#include "figures.hpp"

#include "film/read_film.hpp"

using namespace first_contact::program;

void draw_tween_bounce_figures(const Program& program, const tween_bounce::Flight& flight,
                               const tween_bounce::Flight& printed, const tween_bounce::Flight& physical) {
  tween_bounce::draw_paper_figures(program, flight);
  tween_bounce::draw_bounces(program, printed, physical);
  tween_bounce::draw_tweens(program);
  tween_bounce::draw_curve_lessons(program);
  tween_bounce::draw_turns(program);
  const tween_bounce::Film hall = tween_bounce::film_named("hall"), soft = tween_bounce::film_named("squash");
  tween_bounce::draw_film(program, hall, tween_bounce::Showing(hall), {hall.end(), 25});
  tween_bounce::draw_still(program, soft, tween_bounce::Showing(soft), soft.end());
}
