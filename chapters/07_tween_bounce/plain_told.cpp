#include "plain_told.hpp"

#include "film/read_film.hpp"
#include "film/showing.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "flight.hpp"
#include "plain_length.hpp"
#include "plain_play.hpp"
#include "plain_slerp.hpp"
#include "plain_sweep_along.hpp"

using namespace first_contact;
using first_contact::program::Program;

namespace tween_bounce {

namespace {

// The ball on the first curve, against the floor.
void note_chords(Program& program, const Film& film) {
  const Curve first_curve = film.keys[1].path.from_to(film.keys[1].place, film.keys[2].place);
  program.value("chords", chords(first_curve, 1e-6).size() - 1);
  const Plane floor({0, 0, 1}, 0);
  for (const int n : {4, 16})
    program.value("plain_" + std::to_string(n), plain_sweep_along(first_curve, 0.5, floor, n).value());
  program.value("along", sweep_along(first_curve, 0.5, floor, 1e-8)->time);
}

// How much the sum of chords is short of the arch.
void note_length(Program& program) {
  const double length = ArcLength(arch()).total();
  for (const int n : {100, 1000})
    program.value("short_" + std::to_string(n), length - plain_length(arch(), n));
}

// Where the ball is at last, played picture by picture, with the restitution that the film has.
void note_play(Program& program, const Film& film) {
  const auto meets = [&](const Moving<Sphere>& moving) { return first_of_all(film.walls, moving); };
  for (const int n : {7, 60}) {
    const Point last = plain_play(places_of(film), 0.5, meets, 0.6, n).back();
    program.value("played_" + std::to_string(n) + ".x", last.x());
    program.value("played_" + std::to_string(n) + ".over", last.z() - 0.5);
  }
}

}  // namespace

void note_plain(Program& program) {
  const Film film = film_named("hall");
  note_chords(program, film);
  note_length(program);
  note_play(program, film);
  program.value("lost_at_rest", lost_at_rest(1000));
}

}  // namespace tween_bounce
