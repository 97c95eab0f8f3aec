#pragma once
#include "first_contact/sweep/sphere_sphere.hpp"

//! [scene]
/// Two spheres and their motions; the paper gives letters, the numbers are ours.
struct Scene {
  first_contact::Point p1{-3.2, 0, 0}, p2{1.8, 0, 0.5};
  double rp = 1.2;
  first_contact::Point q1{1.5, 0, 3.1}, q2{-0.5, 0, 0.6};
  double rq = 0.8;
  Eigen::Vector2d interval{0, 1};

  first_contact::Moving<first_contact::Sphere> p() const { return {{p1, rp}, p2 - p1}; }
  first_contact::Moving<first_contact::Sphere> q() const { return {{q1, rq}, q2 - q1}; }
  first_contact::Interval when() const { return {interval.x(), interval.y()}; }
};
//! [scene]

/// The contact within an interval, where the centres are then, and when the spheres part.
struct Meeting {
  Meeting(const first_contact::Moving<first_contact::Sphere>& a,
          const first_contact::Moving<first_contact::Sphere>& b, const first_contact::Interval& when);

  std::optional<first_contact::Contact> contact;
  first_contact::Point p, q;         ///< the centres, if there is a contact
  std::optional<double> separation;  ///< if the spheres share a point at some time of the interval
};
