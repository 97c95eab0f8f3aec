// The laws of an impact, on random bodies.

#include "catch.hpp"
// after Catch
#include <rapidcheck.h>
#include <rapidcheck/catch.h>

#include <cmath>

#include "08_angle_demo/printed_impact.hpp"
#include "first_contact/response/impact.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;

namespace {

double real(double low, double high) {
  return low + (high - low) * *rc::gen::map(rc::gen::inRange(0, 1000001), [](int i) { return i * 1e-6; });
}

template <int Dimension>
Eigen::Matrix<double, Dimension, 1> vector() {
  Eigen::Matrix<double, Dimension, 1> v;
  for (double& coordinate : v) coordinate = real(-10, 10);
  return v;
}

template <int Dimension>
Body<Dimension> body() {
  return {std::pow(10, real(-3, 3)), vector<Dimension>()};
}

template <int Dimension>
double energy(double mp, const Eigen::Matrix<double, Dimension, 1>& vp, double mq,
              const Eigen::Matrix<double, Dimension, 1>& vq) {
  return (mp * vp.squaredNorm() + mq * vq.squaredNorm()) / 2;
}

template <int Dimension>
void check_laws() {
  const auto p = body<Dimension>(), q = body<Dimension>();
  const auto direction = vector<Dimension>();
  RC_PRE(direction.norm() > 0.1);
  const auto n = direction.normalized().eval();
  const double e = real(0, 1);
  const auto after = impact<Dimension>(p, q, n, e);
  const double speed = (p.velocity - q.velocity).dot(n),
               speed_after = (after.velocity_p - after.velocity_q).dot(n);
  if (speed >= 0) {
    RC_ASSERT(after.velocity_p == p.velocity);
    RC_ASSERT(after.velocity_q == q.velocity);
    return;
  }

  const auto momentum = (p.mass * p.velocity + q.mass * q.velocity).eval();
  const auto momentum_after = (p.mass * after.velocity_p + q.mass * after.velocity_q).eval();
  const double scale = p.mass * p.velocity.norm() + q.mass * q.velocity.norm();
  RC_ASSERT((momentum - momentum_after).norm() <= 1e-14 * scale);

  RC_ASSERT(std::abs(speed_after + e * speed) <= 1e-13 * (1 + p.velocity.norm() + q.velocity.norm()));

  const auto across = [&n](const auto& v) { return (v - v.dot(n) * n).eval(); };
  RC_ASSERT((across(after.velocity_p) - across(p.velocity)).norm() <= 1e-13 * (1 + after.velocity_p.norm()));
  RC_ASSERT((across(after.velocity_q) - across(q.velocity)).norm() <= 1e-13 * (1 + after.velocity_q.norm()));

  const double before = energy<Dimension>(p.mass, p.velocity, q.mass, q.velocity);
  const double left = energy<Dimension>(p.mass, after.velocity_p, q.mass, after.velocity_q);
  const double lost = (1 - e * e) * speed * speed / (1 / p.mass + 1 / q.mass) / 2;
  RC_ASSERT(std::abs(before - lost - left) <= 1e-13 * before);
}

}  // namespace

TEST_CASE("An impact keeps momentum and what is across the normal, and loses the energy that it should",
          "[property][impact]") {
  rc::prop("in the plane", check_laws<2>);
  rc::prop("in space", check_laws<3>);
}

TEST_CASE("After an impact, bodies do not approach any more", "[property][impact]") {
  rc::prop("a second impact with the same normal changes nothing to speak of", [] {
    const auto p = body<3>(), q = body<3>();
    const auto n = vector<3>();
    RC_PRE(n.norm() > 0.1);
    const double e = real(0, 1);
    const auto once = impact<3>(p, q, n, e);
    const auto twice = impact<3>({p.mass, once.velocity_p}, {q.mass, once.velocity_q}, n, e);
    RC_ASSERT((twice.velocity_p - once.velocity_p).norm() <= 1e-12 * (1 + once.velocity_p.norm()));
    RC_ASSERT((twice.velocity_q - once.velocity_q).norm() <= 1e-12 * (1 + once.velocity_q.norm()));
  });
}

TEST_CASE("Program 4 with r = 1 is an elastic impact with the normal at the start", "[property][impact]") {
  rc::prop("for bodies in the plane", [] {
    const auto p = body<2>(), q = body<2>();
    const auto at_p = vector<2>(), at_q = vector<2>();
    RC_PRE(std::abs(at_p.x() - at_q.x()) > 0.1);
    const auto printed = printed_impact({p.mass, at_p, p.velocity}, {q.mass, at_q, q.velocity}, 1);
    const auto exact = impact<2>(p, q, at_p - at_q, 1);
    RC_ASSERT((printed.velocity[0] - exact.velocity_p).norm() <= 1e-9 * (1 + exact.velocity_p.norm()));
    RC_ASSERT((printed.velocity[1] - exact.velocity_q).norm() <= 1e-9 * (1 + exact.velocity_q.norm()));
  });
}

TEST_CASE("Exchanging two spheres turns the normal and keeps the time", "[property][sphere_sphere]") {
  rc::prop("for spheres that start anywhere", [] {
    const Moving<Sphere> p{{vector<3>(), real(0, 3)}, vector<3>()}, q{{vector<3>(), real(0, 3)}, vector<3>()};
    RC_PRE(p.shape.center != q.shape.center);
    const auto one = sweep(p, q), other = sweep(q, p);
    RC_ASSERT(one.has_value() == other.has_value());
    if (!one) return;
    RC_ASSERT(one->time == other->time);
    RC_ASSERT(one->normal == -other->normal);
    if (one->time > 0) RC_ASSERT((one->point() - other->point()).norm() <= 1e-11);
  });
}

TEST_CASE("Only relative motion counts: a common velocity changes no contact", "[property][sphere_sphere]") {
  rc::prop("for small whole velocities, where nothing is rounded", [] {
    const auto whole = [] {
      return Vector(*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10));
    };
    const Sphere p{vector<3>(), real(0, 3)}, q{vector<3>(), real(0, 3)};
    const Vector vp = whole(), vq = whole(), common = whole();
    const auto one = sweep(Moving<Sphere>{p, vp}, Moving<Sphere>{q, vq});
    const auto other = sweep(Moving<Sphere>{p, vp + common}, Moving<Sphere>{q, vq + common});
    RC_ASSERT(one.has_value() == other.has_value());
    if (!one) return;
    RC_ASSERT(one->time == other->time);
    RC_ASSERT(one->normal == other->normal);
  });
}

TEST_CASE("At the time of a contact the spheres touch, and they approach", "[property][sphere_sphere]") {
  rc::prop("for spheres that start apart", [] {
    const Moving<Sphere> p{{vector<3>(), real(0, 3)}, vector<3>()}, q{{vector<3>(), real(0, 3)}, vector<3>()};
    RC_PRE(!overlap(p.shape, q.shape));
    const auto contact = sweep(p, q);
    if (!contact) return;
    const Point at_p = p.shape.center + contact->time * p.displacement;
    const Point at_q = q.shape.center + contact->time * q.displacement;
    RC_ASSERT(std::abs((at_p - at_q).norm() - (p.shape.radius + q.shape.radius)) <= 1e-12);
    RC_ASSERT(contact->normal.dot(p.displacement - q.displacement) <= 1e-12);
    RC_ASSERT(std::abs((contact->point() - at_q).norm() - q.shape.radius) <= 1e-7);
  });
}
