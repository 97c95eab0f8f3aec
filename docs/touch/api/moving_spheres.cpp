// Chapter 6: two moving spheres, the world as it is and as it is seen from Q.
#include "06_moving_spheres/scene.hpp"
#include "first_contact/sweep/contact_times.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;

namespace {

void tell_meeting(const Meeting& meeting) {
  if (meeting.separation) tell("separation_time", *meeting.separation);
  if (!meeting.contact) return;
  tell("contact/time", meeting.contact->time);
  tell("contact/p", meeting.p);
  tell("contact/q", meeting.q);
  tell("contact/point", meeting.contact->point());
  tell("contact/normal", meeting.contact->normal);
}

void tell_roots(const Moving<Sphere>& p, const Moving<Sphere>& q, const Vector& w, const Vector& u) {
  const Vector moment = accurate_cross(w, u);
  tell("discriminant", discriminant(u, moment, p.shape.radius + q.shape.radius));
  if (u.squaredNorm() > 0) {
    tell("closest_time", -w.dot(u) / u.squaredNorm());
    tell("closest_distance", moment.norm() / u.norm());
  }
  if (const auto times = contact_interval(p, q)) {
    tell("t1", times->begin);
    tell("t2", times->end);
  }
}

}  // namespace

FOR_THE_PAGE(moving_spheres)
(double p1x, double p1z, double p2x, double p2z, double q1x, double q1z, double q2x, double q2z, double rp,
 double rq, double time) {
  Scene scene;
  scene.p1 = {p1x, 0, p1z};
  scene.p2 = {p2x, 0, p2z};
  scene.rp = rp;
  scene.q1 = {q1x, 0, q1z};
  scene.q2 = {q2x, 0, q2z};
  scene.rq = rq;
  const Moving<Sphere> p = scene.p(), q = scene.q();
  const Vector w = p.shape.center - q.shape.center, u = p.displacement - q.displacement;
  tell_meeting(Meeting(p, q, scene.when()));
  tell_roots(p, q, w, u);
  tell("drawn/d", rp + rq);
  tell("drawn/w", w);
  tell("drawn/u", u);
  tell("drawn/p", p.shape.center + time * p.displacement);
  tell("drawn/q", q.shape.center + time * q.displacement);
  tell("drawn/between", w + time * u);
  tell("drawn/distance", norm(w + time * u));
}
