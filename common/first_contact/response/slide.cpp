#include "first_contact/response/slide.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/products.hpp"

namespace first_contact {

//! [slide_target]
Point slide_target(const Point& p2, const Point& q, const Vector& n) { return p2 - dot(p2 - q, n) * n; }
//! [slide_target]

namespace {

//! [slide_ways]
// What remains of a motion along a wall: P3 - Q, for the motion P2 - Q.
Vector along_wall(const Vector& rest, const Vector& n) { return rest - dot(rest, n) * n; }

// What remains of it along the crease of two walls.
Vector along_crease(const Vector& rest, const Vector& n, const Vector& m) {
  const Vector crease = n.cross(m);
  if (norm(crease) < slide_same_wall) return Vector::Zero();  // parallel walls have none
  const Vector direction = normalized(crease);
  return dot(rest, direction) * direction;
}
//! [slide_ways]

//! [slide_walls]
/// A wall that the sphere has met, and how far to move away from it to stand clear by the gap.
struct Wall {
  Vector normal;
  double lift;
};

/// How a motion goes on: along walls, after a small step away from them.
struct Way {
  Vector along;
  Vector away;
};

// The shortest motion away from two walls, by the lift of each.
Vector away_from(const Wall& a, const Wall& b) {
  const double cosine = dot(a.normal, b.normal), sine_squared = squared_norm(a.normal.cross(b.normal));
  return ((a.lift - cosine * b.lift) * a.normal + (b.lift - cosine * a.lift) * b.normal) / sine_squared;
}

/// The walls that the sphere touches where it is, and those along which it came.
class Walls {
 public:
  explicit Walls(double gap) : gap_(gap) {}
  void move_on();
  void add(const Vector& normal, double distance);
  Way way_on(const Vector& rest, const Vector& forwards) const;

 private:
  bool leads_into_none(const Vector& way, double rounding) const {
    return std::all_of(here_.begin(), here_.end(),
                       [&](const Wall& wall) { return dot(way, wall.normal) >= -rounding; });
  }

  double gap_;
  std::vector<Wall> here_, before_;
};
//! [slide_walls]

// The sphere is at a new place, clear of the walls along which it came.
void Walls::move_on() {
  before_ = std::move(here_);
  here_.clear();
  for (Wall& wall : before_) wall.lift = 0;
}

// A wall that is met again at the same place consists of facets whose normals differ by their rounding, or is
// an edge or a vertex that is only grazed, within the tolerance of the sweep: it is left by more and more,
// until it is passed.
void Walls::add(const Vector& normal, double distance) {
  const auto same = [&](const Wall& wall) {
    return dot(wall.normal, normal) > 0 && norm(wall.normal.cross(normal)) < slide_same_wall;
  };
  const auto known = std::find_if(here_.begin(), here_.end(), same);
  if (known == here_.end())
    here_.push_back({normal, std::max(0.0, gap_ - distance)});
  else
    *known = {normal, 2 * known->lift + gap_};
  std::erase_if(before_, same);
}

//! [slide_way_on]
// Of all ways along a wall or a crease that lead into no wall and forwards, the longest: as each is a
// projection of the motion wished for, the longest is also the nearest to it.
Way Walls::way_on(const Vector& rest, const Vector& forwards) const {
  const double rounding = slide_gap * norm(rest);
  Way best{Vector::Zero(), Vector::Zero()};
  double longest = rounding;  // what is shorter is nothing else
  const auto consider = [&](const Vector& along, const Vector& away) {
    const double length = norm(along);
    if (!(length > longest) || !leads_into_none(along, rounding)) return;
    if (!(dot(along, forwards) > slide_gap * length)) return;
    longest = length;
    best = {along, away};
  };
  for (std::size_t i = 0; i < here_.size(); ++i) {
    const Wall& wall = here_[i];
    consider(along_wall(rest, wall.normal), wall.lift * wall.normal);
    const auto crease_with = [&](const Wall& other) {
      const Vector along = along_crease(rest, wall.normal, other.normal);
      if (!along.isZero(0)) consider(along, away_from(wall, other));
    };
    std::for_each(here_.begin() + static_cast<std::ptrdiff_t>(i) + 1, here_.end(), crease_with);
    std::for_each(before_.begin(), before_.end(), crease_with);
  }
  return best;
}
//! [slide_way_on]

double gap_of_scene(const Moving<Sphere>& moving, double largest_coordinate) {
  const auto& [sphere, wish] = moving;
  const double farthest = sphere.center.lpNorm<Eigen::Infinity>() + wish.lpNorm<Eigen::Infinity>();
  return slide_gap * std::max({farthest, largest_coordinate, sphere.radius});
}

}  // namespace

//! [slide]
Slide slide(const Moving<Sphere>& moving, const SphereSweep& first_contact_of, double largest_coordinate,
            int most_contacts) {
  const Vector& wish = moving.displacement;
  const Vector forwards = normalized(wish);
  const double gap = gap_of_scene(moving, largest_coordinate);

  Slide path{{moving.shape.center}, {}, Ending::arrived};
  Walls walls(gap);
  Sphere sphere = moving.shape;
  Vector rest = wish, step = wish;  // the motion that is left, and the part of it that the walls let pass
  double elapsed = 0;
  while (const auto contact = first_contact_of({sphere, step})) {
    path.contacts.push_back(*contact);
    path.contacts.back().time = elapsed + (1 - elapsed) * contact->time;

    // The gap is kept along the normal: at a shallow angle, a gap along the path would be next to none.
    const double approach = std::max(0.0, -dot(contact->normal, step));  // by the whole step
    const double distance = contact->time * approach;                    // of the sphere from the wall
    const double share = distance > gap ? contact->time - gap / approach : 0;
    if (share * norm(step) > gap) {  // a new place, with walls of its own
      sphere.center += share * step;
      path.positions.push_back(sphere.center);
      rest = (1 - share) * step;
      elapsed += (1 - elapsed) * share;
      walls.move_on();
      walls.add(contact->normal, gap);
    } else {
      walls.add(contact->normal, distance);
    }
    const Way way = walls.way_on(rest, forwards);
    const bool free = way.away.isZero(0) || !first_contact_of({sphere, way.away});
    if (free) sphere.center += way.away;
    step = free ? way.along : Vector(way.along + way.away);
    if (std::ssize(path.contacts) >= most_contacts) path.ending = Ending::exhausted;
    if (step.isZero(0)) path.ending = Ending::cornered;
    if (path.ending != Ending::arrived) return path;
  }
  if (!step.isZero(0)) path.positions.emplace_back(sphere.center + step);
  return path;
}
//! [slide]

}  // namespace first_contact
