#include "first_contact/response/slide.hpp"

#include <algorithm>
#include <cmath>

namespace first_contact {

//! [slide_target]
Point slide_target(const Point& p2, const Point& q, const Vector& n) { return p2 - (p2 - q).dot(n) * n; }
//! [slide_target]

namespace {

/// The walls that the sphere touches where it is, and those along which it came.
class Walls {
 public:
  void move_on() {
    before_ = std::move(here_);
    here_.clear();
  }

  void add(const Vector& normal) {
    for (Vector& known : here_)
      if (known.cross(normal).norm() < slide_same_wall && known.dot(normal) > 0) {
        known = normal;
        return;
      }
    here_.push_back(normal);
  }

  Vector way_on(const Vector& rest, const Vector& forwards) const;

 private:
  bool leads_into_none(const Vector& way, double length) const {
    return std::all_of(here_.begin(), here_.end(),
                       [&](const Vector& normal) { return way.dot(normal) >= -slide_lean * length; });
  }

  std::vector<Vector> here_, before_;
};

//! [slide_ways]
// What remains of a motion along a wall: P3 - Q, for the motion P2 - Q.
Vector along_wall(const Vector& rest, const Vector& n) { return rest - rest.dot(n) * n; }

// What remains of it along the crease of two walls.
Vector along_crease(const Vector& rest, const Vector& n, const Vector& m) {
  const Vector crease = n.cross(m);
  if (crease.norm() < slide_same_wall) return Vector::Zero();  // parallel walls have none
  const Vector direction = crease.normalized();
  return rest.dot(direction) * direction;
}
//! [slide_ways]

//! [slide_way_on]
// Of all ways along a wall or a crease that lead into no wall and forwards, the longest: as each is a
// projection of the motion wished for, the longest is also the nearest to it.
Vector Walls::way_on(const Vector& rest, const Vector& forwards) const {
  const double length = rest.stableNorm();
  Vector best = Vector::Zero();
  double longest = slide_gap * length;  // what is shorter is but rounding
  const auto consider = [&](const Vector& way, const Vector& outwards) {
    const double size = way.stableNorm();
    if (!(size > longest) || !leads_into_none(way, length) || !(way.dot(forwards) > slide_gap * size)) return;
    longest = size;
    best = way + slide_lean * length * outwards;
  };
  for (std::size_t i = 0; i < here_.size(); ++i) {
    const Vector& n = here_[i];
    consider(along_wall(rest, n), n);
    const auto crease_with = [&](const Vector& m) {
      consider(along_crease(rest, n, m), (n + m) / (1 + n.dot(m)));
    };
    for (std::size_t k = i + 1; k < here_.size(); ++k) crease_with(here_[k]);
    for (const Vector& m : before_) crease_with(m);
  }
  return best;
}
//! [slide_way_on]

double gap_of_scene(const Moving<Sphere>& moving, double extent) {
  const auto& [sphere, wish] = moving;
  const double farthest = sphere.center.lpNorm<Eigen::Infinity>() + wish.lpNorm<Eigen::Infinity>();
  return slide_gap * std::max({farthest, extent, sphere.radius});
}

// The share of a step that ends `gap` before the wall, measured along its normal and not along the path: at a
// shallow angle a gap along the path is next to none.
double share_before(const Contact& contact, const Vector& step, double gap) {
  const double approach = -contact.normal.dot(step);
  return approach > 0 ? std::max(0.0, contact.time - gap / approach) : 0.0;
}

}  // namespace

//! [slide]
Slide slide(const Moving<Sphere>& moving, const SphereSweep& first_contact_of, double extent,
            int most_contacts) {
  const Vector& wish = moving.displacement;
  const Vector forwards = wish.stableNormalized();
  const double gap = gap_of_scene(moving, extent);

  Slide path{{moving.shape.center}, {}, Ending::arrived};
  Walls walls;
  Sphere sphere = moving.shape;
  Vector rest = wish, step = wish;  // the motion that is left, and the part of it that the walls let pass
  double elapsed = 0;
  while (auto contact = first_contact_of({sphere, step})) {
    const double share = share_before(*contact, step, gap);
    contact->time = elapsed + (1 - elapsed) * contact->time;
    path.contacts.push_back(*contact);

    if (share * step.stableNorm() > gap) {  // a new place, with walls of its own
      sphere.center += share * step;
      path.positions.push_back(sphere.center);
      rest = (1 - share) * step;
      elapsed += (1 - elapsed) * share;
      walls.move_on();
    }
    walls.add(contact->normal);
    step = walls.way_on(rest, forwards);
    if (std::ssize(path.contacts) >= most_contacts) path.ending = Ending::exhausted;
    if (step.isZero(0)) path.ending = Ending::cornered;
    if (path.ending != Ending::arrived) return path;
  }
  if (!step.isZero(0)) path.positions.push_back(sphere.center + step);
  return path;
}
//! [slide]

double extent(const Triangle& triangle) {
  return std::max({triangle.a.lpNorm<Eigen::Infinity>(), triangle.b.lpNorm<Eigen::Infinity>(),
                   triangle.c.lpNorm<Eigen::Infinity>()});
}

double extent(const Mesh& mesh) {
  double largest = 0;
  for (const Point& vertex : mesh.vertices()) largest = std::max(largest, vertex.lpNorm<Eigen::Infinity>());
  return largest;
}

}  // namespace first_contact
