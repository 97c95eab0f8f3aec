#include "verify/judge.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdio>
#include <limits>
#include <vector>

#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "first_contact/trees/plain_bvh.hpp"
#include "verify/surfaces.hpp"
#include "verify/truth.hpp"

namespace judge {

namespace {

using FiftyDigits = boost::multiprecision::cpp_bin_float_50;

/// What rounding may take from or add to the radius, for one triangle.
/// \see bvh.hpp
double bound(const Triangle& t, const Moving<Sphere>& moving) {
  const auto& [s, r] = moving.shape;
  const double corner = std::max({(t.a - s).norm(), (t.b - s).norm(), (t.c - s).norm()});
  const double side = std::max({(t.b - t.a).norm(), (t.c - t.b).norm(), (t.a - t.c).norm()});
  return 16 * std::numeric_limits<double>::epsilon() * (corner + side + moving.displacement.norm() + r);
}

/// A triangle that the sphere comes near, and all that the judgement asks of it.
template <class Real>
struct Witness {
  Triangle triangle;
  truth::Approach<Real> approach;
  Real bound;
  bool overlaps;  // at the start, or nearly so
};

template <class Real>
std::vector<Witness<Real>> witnesses(const Mesh& mesh, const Moving<Sphere>& moving) {
  std::vector<Witness<Real>> result;
  const auto& [s, r] = moving.shape;
  const Vector& v = moving.displacement;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const double size = std::max((t.b - t.a).norm(), (t.c - t.a).norm());
    const double k = v.isZero(0) ? 0 : std::clamp((t.a - s).dot(v) / v.squaredNorm(), 0.0, 1.0);
    if ((s + k * v - t.a).norm() > 1.000001 * (r + size)) continue;  // out of reach by far
    const Real delta = bound(t, moving);
    truth::Approach<Real> approach(t, s, v);
    const bool overlaps = approach.distance(Real(0)) <= Real(r) + delta;
    result.push_back({t, approach, delta, overlaps});
  }
  return result;
}

bool has(const Triangle& t, const Point& p) { return t.a == p || t.b == p || t.c == p; }

/// A triangle is around a vertex that it has, and around an edge of which it has both ends.
template <class Real>
bool is_around(const truth::Vec<Real>& point, const Triangle& with_it, const Triangle& other,
               const Real& near) {
  const std::array<Point, 3> corner{with_it.a, with_it.b, with_it.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &p = corner[i], &q = corner[(i + 1) % 3];
    if (!has(other, p)) continue;
    if (norm(point - truth::exact<Real>(p)) <= near) return true;
    if (has(other, q) && norm(truth::Triangle<Real>(Triangle(p, q, q)).from(point)) <= near) return true;
  }
  return false;
}

enum class Answer { no, perhaps, yes };

/// May rounding take the nearest point of a triangle off its border, to where the other one is not? It may if
/// a little way inside the distance is all but the same.
template <class Real>
bool may_leave(const Witness<Real>& one, const Triangle& other, const Real& t, const Real& step) {
  const truth::Vec<Real> point = one.approach.point(t), to_center = Real(-1) * one.approach.offset(t);
  const Triangle& own = one.triangle;
  for (const Point& target : {own.a, own.b, own.c, Point((own.a + own.b + own.c) / 3)}) {
    const truth::Vec<Real> way = truth::exact<Real>(target) - point;
    const Real length = norm(way);
    if (!(length > step)) continue;
    const truth::Vec<Real> inside = (step / length) * way;
    const Real farther = norm(to_center - inside) - norm(to_center);
    if (farther <= one.bound && norm(truth::Triangle<Real>(other).from(point + inside)) > one.bound)
      return true;
  }
  return false;
}

/// Is the nearest point of a triangle nearer to the centre than the surface around it? A neighbour that holds
/// the point leads nearer if and only if it is nearer itself, since it is convex.
template <class Real>
Answer nearest_around(const Witness<Real>& one, const std::vector<Witness<Real>>& all, const Real& t) {
  const Real near = 4 * one.bound, hardly_near = 4000 * one.bound, tiny = one.bound / 1000;
  const Real distance = one.approach.distance(t);
  const truth::Vec<Real> point = one.approach.point(t);
  Answer answer = distance > 1000 * one.bound ? Answer::yes : Answer::perhaps;
  for (const Witness<Real>& other : all) {
    const Real nearer = distance - other.approach.distance(t);
    if (&other == &one || !(nearer > tiny) || !is_around(point, one.triangle, other.triangle, hardly_near))
      continue;
    answer = Answer::perhaps;
    if (nearer > near && is_around(point, one.triangle, other.triangle, near) &&
        !may_leave(one, other.triangle, t, Real(4 * near)))
      return Answer::no;
  }
  return answer;
}

/// Does the sphere go deeper into what it overlaps? In doubt within the angle in which a step along the
/// tangent is not noticed.
template <class Real>
Answer going_deeper(const Witness<Real>& one, const Moving<Sphere>& moving) {
  using std::sqrt;
  const truth::Vec<Real> down = one.approach.offset(Real(0));
  const Real distance = norm(down), travel = moving.displacement.norm();
  if (!(distance > 1000 * one.bound)) return Answer::perhaps;
  const Real cosine = dot(down, truth::exact<Real>(moving.displacement)) / (distance * travel);
  const Real doubt = 4 * sqrt(one.bound / distance);
  return cosine > doubt ? Answer::yes : cosine > -doubt ? Answer::perhaps : Answer::no;
}

/// When a contact may be at the earliest and must be at the latest; never, if none may or must be.
template <class Real>
struct Window {
  std::optional<Real> earliest, latest;
};

template <class Real>
void keep(std::optional<Real>& first, const std::optional<Real>& other) {
  if (other && (!first || *other < *first)) first = other;
}

/// The path of a point, and on which side of things it passes.
template <class Real>
class Path {
 public:
  explicit Path(const Moving<Sphere>& moving)
      : start_(truth::exact<Real>(moving.shape.center)), travel_(truth::exact<Real>(moving.displacement)) {}

  /// How far to the left of p to q it passes, seen along the path; 0 where the two are parallel.
  Real left_of(const Point& p, const Point& q) const {
    const truth::Vec<Real> a = truth::exact<Real>(p), across = cross(truth::exact<Real>(q) - a, travel_);
    const Real length = norm(across);
    return length > 0 ? Real(dot(start_ - a, across) / length) : Real(0);
  }
  /// When it is behind the plane of three points by more than `depth`, having been before it by as much.
  std::optional<Real> passes(const Point& p, const Point& q, const Point& s, const Real& depth) const {
    const truth::Vec<Real> a = truth::exact<Real>(p);
    const truth::Vec<Real> n = cross(truth::exact<Real>(q) - a, truth::exact<Real>(s) - a);
    const Real length = norm(n);
    if (!(length > 0)) return std::nullopt;
    const Real begin = dot(start_ - a, n) / length, end = begin + dot(travel_, n) / length;
    const Real before = begin < 0 ? Real(-begin) : begin, behind = begin < 0 ? end : Real(-end);
    if (!(before > depth && behind > depth)) return std::nullopt;
    return (before + depth) / (before + behind);
  }

 private:
  truth::Vec<Real> start_, travel_;
};

/// A point cannot be nearer to a face than its radius, which is 0; but where it goes through, it must hit:
/// if its path, seen from its start, has all sides of the face on the same hand, and none within the bound.
template <class Real>
std::optional<Real> goes_through(const Witness<Real>& one, const Path<Real>& path) {
  const auto& [a, b, c] = one.triangle;
  const Real ab = path.left_of(a, b), bc = path.left_of(b, c), ca = path.left_of(c, a);
  const Real least = std::min({ab, bc, ca}), most = std::max({ab, bc, ca});
  if (!(least > one.bound || -most > one.bound)) return std::nullopt;
  return path.passes(a, b, c, one.bound);
}

/// ... as it must where it goes through two faces with a side in common, on that side or beside it: through
/// their outline.
template <class Real>
std::optional<Real> goes_through_seam(const Witness<Real>& one, const Witness<Real>& other,
                                      const Path<Real>& path) {
  const Real bound = std::max(one.bound, other.bound);
  const std::array<Point, 3> corner{one.triangle.a, one.triangle.b, one.triangle.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = corner[i], &b = corner[(i + 1) % 3], &c = corner[(i + 2) % 3];
    const auto& [p, q, s] = other.triangle;
    if (!has(other.triangle, a) || !has(other.triangle, b)) continue;
    const Point& d = p != a && p != b ? p : q != a && q != b ? q : s;
    const std::array<Real, 4> sides{path.left_of(b, c), path.left_of(c, a), path.left_of(a, d),
                                    path.left_of(d, b)};
    const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
    if (!(*least > bound || -*most > bound)) continue;
    const auto first = path.passes(a, b, c, bound), second = path.passes(b, a, d, bound);
    if (first && second) return std::max(*first, *second);
  }
  return std::nullopt;
}

/// Of a sphere that is apart at the start, the first touch of any triangle counts.
template <class Real>
Window<Real> from_apart(const std::vector<Witness<Real>>& all, const Moving<Sphere>& moving) {
  Window<Real> window;
  const Real r = moving.shape.radius;
  for (const Witness<Real>& one : all) {
    keep(window.earliest, one.approach.first_time(r + one.bound));
    keep(window.latest, one.approach.first_time(r - one.bound));
  }
  if (moving.shape.radius > 0) return window;
  const Path<Real> path(moving);
  for (const Witness<Real>& one : all) {
    keep(window.latest, goes_through(one, path));
    for (const Witness<Real>& other : all)
      if (&other != &one) keep(window.latest, goes_through_seam(one, other, path));
  }
  return window;
}

/// Of one that overlaps, each touch counts of what is nearest to the centre in its surroundings; it must be
/// seen if it is so for any radius within the bound. What it gets free of may hide an edge from it until it
/// is over the face beyond: then it is in that face without having come to it.
template <class Real>
Window<Real> from_overlap(const std::vector<Witness<Real>>& all, const Moving<Sphere>& moving) {
  Window<Real> window;
  const Real r = moving.shape.radius;
  for (const Witness<Real>& one : all) {
    const Answer deeper = one.overlaps ? going_deeper(one, moving) : Answer::yes;
    if (deeper == Answer::no) continue;
    const auto first = one.approach.first_time(r + one.bound), last = one.approach.first_time(r - one.bound);
    const Answer nearest = first ? nearest_around(one, all, *first) : Answer::no;
    if (first && nearest != Answer::no) keep(window.earliest, first);
    if (last && deeper == Answer::yes && (nearest == Answer::yes || *first == 0) &&
        nearest_around(one, all, *last) == Answer::yes)
      keep(window.latest, last);
  }
  return window;
}

template <class Real>
Tally tally_of(const Mesh& mesh, const Moving<Sphere>& moving, const std::optional<Contact>& contact) {
  Tally tally;
  tally.hits = contact.has_value();
  const auto all = witnesses<Real>(mesh, moving);
  const Real r = moving.shape.radius;
  bool overlaps = false;
  for (const Witness<Real>& one : all) overlaps |= one.overlaps;
  const auto [earliest, latest] = overlaps ? from_overlap(all, moving) : from_apart(all, moving);
  tally.overlaps = overlaps;
  tally.grazes = earliest && !latest;
  tally.missed = latest && !contact;
  tally.false_hits = !earliest && contact;
  if (!contact || !earliest) return tally;
  const Real t = contact->time;
  tally.inexact = t < *earliest || (latest && t > *latest);
  if (overlaps) return tally;
  Real least = std::numeric_limits<Real>::infinity();
  for (const Witness<Real>& one : all) {
    const Real error = abs(one.approach.distance(t) - r) / one.bound;
    if (error < least) least = error;
  }
  tally.worst = static_cast<double>(least);
  tally.inexact |= least > 1;
  return tally;
}

}  // namespace

void Tally::add(const Tally& t) {
  casts += t.casts;
  hits += t.hits;
  overlaps += t.overlaps;
  grazes += t.grazes;
  disputed += t.disputed;
  missed += t.missed;
  false_hits += t.false_hits;
  inexact += t.inexact;
  unlike += t.unlike;
  worst = std::max(worst, t.worst);
}

/// 64 bits may acquit the answer for a sphere: their distances are right to 2^-60 L, and how a distance of r
/// changes is then known as well. They may not for a point: near to 0 nothing is known of that.
void add(Tally& tally, const Mesh& mesh, const Moving<Sphere>& moving,
         const std::optional<Contact>& contact) {
  const bool sphere = moving.shape.radius > 0;
  Tally one;
  if (sphere) one = tally_of<long double>(mesh, moving, contact);
  if (!sphere || !one.good()) {
    one = tally_of<FiftyDigits>(mesh, moving, contact);
    one.disputed = sphere;
  }
  one.casts = 1;
  tally.add(one);
}

bool same(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->time == b->time && a->points == b->points && a->normal == b->normal && a->feature == b->feature &&
         a->triangle == b->triangle;
}

void verify(std::uint64_t seed, int kind, int count, Tally* tallies) {
  surfaces::Random random(seed);
  const Mesh mesh = surfaces::placed(surfaces::surface(kind, random), random);
  const Bvh fast(mesh);
  const PlainBvh plain(mesh);
  static const auto walkers = bvh::all_walkers();
  std::vector<Moving<Sphere>> casts;
  for (int i = 0; i < count; ++i) casts.push_back(surfaces::cast(mesh, i % surfaces::aims, random));
  std::vector<std::optional<Contact>> together(casts.size());
  sweep(casts, fast, together);
  for (std::size_t i = 0; i < casts.size(); ++i) {
    Tally& tally = tallies[i % surfaces::aims];
    const auto contact = sweep(casts[i], fast);
    const bool all_walk_alike = std::all_of(walkers.begin(), walkers.end(), [&](const bvh::Walker* walker) {
      return same(contact, bvh::sweep(casts[i], fast.parts(), *walker));
    });
    if (!all_walk_alike || !same(contact, together[i]) || !same(contact, sweep(casts[i], plain)))
      ++tally.unlike;
    const Tally before = tally;
    add(tally, mesh, casts[i], contact);
    if (before.good() && !tally.good())
      std::fprintf(stderr, "wrong: %s, seed %llu, cast %zu\n", surfaces::name(kind),
                   static_cast<unsigned long long>(seed), i);
  }
}

}  // namespace judge
