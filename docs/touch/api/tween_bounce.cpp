// Chapter 7: the ball of programs 1 to 3, as printed and as it obeys gravity.
#include "07_tween_bounce/flight.hpp"
#include "page.hpp"

using namespace first_contact;
using namespace tween_bounce;
using touch::tell;

namespace {

// The first few are told: as printed, it hits the floor hundreds of times while it lies there.
void tell_printed(const Flight& flight) {
  for (std::size_t i = 0; i < std::min<std::size_t>(2, flight.impacts.size()); ++i) {
    tell("impacts/" + std::to_string(i) + "/time", flight.impacts[i].time);
    tell("impacts/" + std::to_string(i) + "/speed", flight.impacts[i].speed);
  }
  if (!flight.apexes.empty()) tell("apexes/0/height", flight.apexes[0].height);
  if (flight.rest_time) tell("rest_time", *flight.rest_time);
}

}  // namespace

FOR_THE_PAGE(tween_bounce)
(double v0, double y0, double g, double dt, double samples, double restitution, double time) {
  const auto count = static_cast<std::size_t>(samples);
  const Flight printed = printed_flight(run({v0, y0, g, dt, count, restitution}));
  const Bounce bounce(y0, v0, g, restitution);
  const Flight physical = physical_flight(bounce, dt, count);
  tell_printed(printed);
  if (const auto landing = bounce.impact(1); landing && bounce.apex(1)) {
    tell("true_t1", landing->time);
    tell("true_v1", landing->speed);
  }
  tell("drawn/t", printed.t);
  tell("drawn/printed", printed.y);
  tell("drawn/physical", physical.y);
  tell("drawn/ball", height_at(printed, time));
  tell("drawn/true_ball", bounce.height(time));
}
