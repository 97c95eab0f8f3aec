#include "scene.hpp"

using namespace first_contact;

//! [meeting]
Meeting::Meeting(const Moving<Sphere>& a, const Moving<Sphere>& b, const Interval& when)
    : contact(sweep(a, b, when)), p(a.shape.center), q(b.shape.center) {
  const double t = contact ? contact->time : when.first;
  p += t * a.displacement;
  q += t * b.displacement;
  const auto times = contact_interval(a, b);
  if (times && times->begin <= when.last && times->end >= when.first) separation = times->end;
}
//! [meeting]
