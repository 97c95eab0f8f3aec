// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_FEATURES) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_FEATURES
#undef FIRST_CONTACT_BVH_KERNELS_FEATURES
#else
#define FIRST_CONTACT_BVH_KERNELS_FEATURES
#endif

#include "first_contact/bvh/kernels/vectors.hpp"
#include "first_contact/bvh/kernels/walker.hpp"

/// \file
/// Which of a triangle's face, edges and vertices may the sphere touch in time? In doubles, three edges and
/// three vertices at once.
///
/// The idea: of a triangle that is touched, as a rule one feature is touched first and six are not. The
/// deciding tests of all seven are long, since they also find point and normal and weigh every rounding; this
/// one asks only what excludes a feature, without square roots where it can, and leaves a margin wider than
/// any rounding of either. It equals calling all seven tests at once.
///
/// The margins. With m from the corner to the centre, e the edge, V the path, and L = |m| + |e| + |V| + r, the
/// deciding distances are exact for a radius that is wrong by less than tol = 2^-48 L (rounding_of_distance).
/// A discriminant a (r^2 - d^2) is therefore compared with r^2 (1 + 2^-38) + 2^-52 (mm + ee + VV): since 2 r
/// tol <= 2^-40 r^2 + 2^40 tol^2, that is more than (r + tol)^2. Products of lengths get 2^-44 of their
/// largest possible value, 2^8 roundings. What is divided by is divided only where it is larger than 2^-20 of
/// that; elsewhere the feature is kept.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

/// Not less than the length, nor more than sqrt 3 times it.
HWY_INLINE Doubles about_length(const Triple<Doubles>& a) {
  return magnitude(a.x) + magnitude(a.y) + magnitude(a.z);
}

constexpr double product_error = 0x1p-44, hardly = 0x1p-20;

/// Three points in three lanes, and the first once more.
HWY_INLINE Doubles in_lanes(double a, double b, double c) {
  const double lanes[4] = {a, b, c, a};
  return read<Doubles>(lanes);
}
HWY_INLINE Triple<Doubles> three(const double* a, const double* b, const double* c) {
  return {in_lanes(a[0], b[0], c[0]), in_lanes(a[1], b[1], c[1]), in_lanes(a[2], b[2], c[2])};
}

/// A triangle as the cast sees it, corner by corner; the fourth lane repeats the first.
struct Outline {
  Triple<Doubles> m, e, back, v;  // from corner to centre; from corner to the next, to the last; the path
  Doubles mm, ee, vv;             // their squares
  Doubles lengths;                // L, about
  Doubles reach2;                 // the square of the radius, and some
};

HWY_INLINE Outline outline(const Question& q, const double* a, const double* b, const double* c) {
  const Triple<Doubles> corner = three(a, b, c);
  Outline s;
  s.m = in_all(q.center) - corner;
  s.e = three(b, c, a) - corner;
  s.back = three(c, a, b) - corner;
  s.v = in_all(q.travel);
  s.mm = dot(s.m, s.m);
  s.ee = dot(s.e, s.e);
  s.vv = dot(s.v, s.v);
  s.lengths = about_length(s.m) + about_length(s.e) + about_length(s.v) + all4(q.radius);
  s.reach2 = fused(s.mm + s.ee + s.vv, all4(0x1p-52), all4(q.radius * q.radius * (1 + 0x1p-38)));
  return s;
}

/// Is the entry, at (-b - sqrt d) / a, later than `latest`? `slack` is what -b - a latest may be wrong by.
HWY_INLINE DoubleMask late(const Doubles& a, const Doubles& b, const Doubles& d, double latest,
                           const Doubles& slack) {
  const Doubles beyond = minus_product(-b, a, all4(latest)) - slack;
  return (beyond > all4(0)) & (beyond * beyond > d * all4(1 + 0x1p-40));
}

/// Of a triangle that the sphere overlaps at the start only the feature nearest to the centre may be touched
/// there: of any other the triangle itself leads nearer (\see among_faces, among_edges). These are the edges
/// and vertices, one bit each as in Found, that are surely overlapped and surely not the nearest; the margin
/// is twice the step that nearest.cpp does not notice.
/// \param thick  is the face not too thin to answer for itself?
HWY_INLINE unsigned hidden(const Question& q, const Outline& s, bool thick) {
  const Doubles inside =
      minus_product(all4(q.radius * q.radius * (1 - 0x1p-30)), s.mm + s.ee + s.vv, all4(0x1p-50));
  const Doubles unnoticed = all4(0x1p-21) * s.lengths;
  const Doubles along_e = unnoticed * about_length(s.e), along_back = unnoticed * about_length(s.back);
  const Doubles me = dot(s.m, s.e), mb = dot(s.m, s.back);
  const unsigned vertices = bits((s.mm < inside) & ((me > along_e) | (mb > along_back)));

  // An edge: is the centre not between its ends, or on the side of its line where the triangle is?
  const Triple<Doubles> h = cross(s.e, s.m), inward = cross(s.e, s.back);
  const DoubleMask overlapped = dot(h, h) < inside * s.ee;
  unsigned edges = bits(overlapped & ((me < -along_e) | (me > s.ee + along_e)));
  if (thick) edges |= bits(overlapped & (dot(h, inward) > s.ee * along_back));
  return (edges & 7) << 1 | (vertices & 7) << 4;
}

/// Times of entry are known to this much of L / |V|, or, of edges, of L / |V| sine of the angle to the path:
/// more than the root of any rounding above.
constexpr double unsure = 0x1p-17;

/// Adds to what was found the lanes in `open`, with their times of entry; in `sure` those that are touched
/// then for certain.
HWY_INLINE void offer(Found& found, unsigned open, unsigned sure, int first_bit, const Doubles& time,
                      const Doubles& margin) {
  double early[4], late[4];
  write(early, time - margin);
  write(late, time + margin);
  found.features |= open << first_bit;
  for (; open; open &= open - 1) {
    const int i = __builtin_ctz(open);
    found.early[first_bit + i] = early[i] > 0 ? early[i] : 0;  // 0 also if it is not a number
    if (sure >> i & 1 && early[i] > 0 && late[i] < found.late) found.late = late[i];
  }
}

/// From what is touched on the way the triangle itself may lead nearer to the centre, where that is then:
/// along a side, from a vertex, or inward, from an edge. Then it is surely not what is touched (\see
/// among_faces, among_edges). A time that may be 0, with its `margin`, says nothing. Not asked of a face that
/// is too thin to answer for itself.
HWY_INLINE unsigned vertices_led_from(const Outline& s, const Doubles& time, const Doubles& margin) {
  const Triple<Doubles> arrival = along(s.m, time, s.v);
  const Doubles off = all4(2) * root(s.vv) * margin;
  const DoubleMask nearer =
      (dot(arrival, s.e) > off * about_length(s.e)) | (dot(arrival, s.back) > off * about_length(s.back));
  return bits((time > margin) & nearer);
}
HWY_INLINE unsigned edges_led_from(const Outline& s, const Doubles& time, const Doubles& margin,
                                   const Doubles& along_edge) {
  const Triple<Doubles> arrival = along(s.m, time, s.v);
  const Doubles off = all4(2) * root(s.vv) * margin;
  const Doubles inward = minus_product(dot(arrival, s.back) * s.ee, along_edge, dot(s.e, s.back));
  return bits((time > margin) & (inward > s.ee * off * about_length(s.back)));
}

HWY_INLINE void vertices_in_time(const Outline& s, double latest, Found& found) {
  const Triple<Doubles> moment = cross(s.m, s.v);
  const Doubles b = dot(s.m, s.v), d = s.vv * s.reach2 - dot(moment, moment);
  const Doubles slack = all4(product_error) * about_length(s.v) * s.lengths;
  unsigned open = 7 & ~bits((d < all4(0)) | (b > slack) | late(s.vv, b, d, latest, slack));
  if (!open) return;
  const Doubles time = (-b - root(d)) / s.vv, margin = all4(unsure) / root(s.vv) * s.lengths;
  open &= ~vertices_led_from(s, time, margin);
  offer(found, open, open, 4, time, margin);
}

HWY_INLINE void edges_in_time(const Outline& s, double latest, bool thick, Found& found) {
  const Doubles zero = all4(0);
  const Triple<Doubles> c = cross(s.e, s.v), h = cross(s.e, s.m);
  const Doubles a = dot(c, c), b = dot(h, c), k = dot(s.m, c);
  const Doubles d = minus_product(fused(s.mm * s.ee * s.vv, all4(0x1p-54), a * s.reach2), k, k);
  const Doubles slack = s.ee * (all4(product_error) * about_length(s.v) * s.lengths);
  const DoubleMask never = (d < zero) | (b > slack) | late(a, b, d * s.ee, latest, slack);
  if ((7 & ~bits(never)) == 0) return;

  // Where along the edge, from the entry until the closest approach? Not asked of paths along the edge.
  const Doubles by_a = all4(1) / a, turn_back = -b * by_a, half = root(most(d * s.ee, zero)) * by_a;
  const Doubles entry = turn_back - half;
  const Doubles first = most(entry, zero), last = least(most(turn_back, zero), all4(latest));
  const Doubles me = dot(s.m, s.e), ve = dot(s.v, s.e), from = fused(first, ve, me), to = fused(last, ve, me);
  const Doubles margin = all4(0x1p-24) * s.lengths * about_length(s.e);
  const DoubleMask across = a > all4(hardly) * s.ee * s.vv;
  const DoubleMask beside = across & ((most(from, to) < -margin) | (least(from, to) > s.ee + margin));
  unsigned open = 7 & ~bits(never | beside);
  if (!open) return;
  const unsigned sure = bits(across & (from > margin) & (from < s.ee - margin));
  const Doubles unknown = all4(unsure) * s.lengths * root(s.ee * by_a);
  const Doubles unsure_by = choose(across, unknown, all4(__builtin_inf()));
  if (thick) open &= ~edges_led_from(s, entry, unsure_by, fused(entry, ve, me));
  offer(found, open, sure, 1, entry, unsure_by);
}

/// Does the sphere at the start reach through the plane of a face by a sixtieth of its radius, and is no
/// length much larger than it? If the centre is then over the face, well within its sides, nothing else of
/// the triangle is ever touched. At the start the face is nearest. And the distance d(t) from a triangle
/// is convex: as long as it is less than r the triangle leads nearer than any feature that is entered; and
/// when it gets to r it grows by at least 2^-6 r / t, which is 2^-16 |V|. What is then nearest but for
/// rounding is in a direction that differs by less than 2^-18 (\see unnoticed_step), so that its distance
/// grows too: it is not entered.
HWY_INLINE bool deep(const Outline& s, double radius, double gap, double length) {
  return gap < -0x1p-6 * radius * length && bits(s.lengths < all4(0x1p10 * radius)) == 15;
}

enum class Face { out_of_time, in_doubt, perhaps, first };

/// The plane of a face, by its unscaled normal.
struct FacePlane {
  double normal[3];
  double square, length;           // of the normal
  double area, longest, farthest;  // products of sides, a side, lengths in play: at least
};
HWY_INLINE FacePlane face_plane(const Outline& s) {
  double x[4], y[4], z[4], sides[4], lengths[4];
  const Triple<Doubles> product = cross(s.e, s.back);
  write(x, product.x);
  write(y, product.y);
  write(z, product.z);
  write(sides, about_length(s.e));
  write(lengths, s.lengths);
  FacePlane p{{x[0], y[0], z[0]}, 0, 0, sides[0] * sides[2], sides[0] + sides[1] + sides[2], 0};
  p.square = x[0] * x[0] + y[0] * y[0] + z[0] * z[0];
  p.length = __builtin_sqrt(p.square);
  p.farthest = lengths[0] + lengths[1] + lengths[2];
  return p;
}

/// The face: is it touched in time, and if so, is it for certain what of the triangle is touched first? Where
/// in doubt, its time is not known.
HWY_INLINE Face face_in_time(const Question& q, const Outline& s, double latest, Found& found, bool& thick) {
  const FacePlane p = face_plane(s);
  thick = p.square > hardly * hardly * p.area * p.area;
  if (!thick) return Face::in_doubt;                                         // too thin to say
  thick = q.radius * p.longest * p.longest * p.longest < 0x1p48 * p.square;  // \see Facet::thin_for

  const Triple<Doubles> normal = in_all(p.normal);
  double heights[4], rises[4];
  write(heights, dot(normal, s.m));
  write(rises, dot(normal, s.v));
  const double height = heights[0], slack = product_error * p.area * p.farthest;
  if (!(__builtin_fabs(height) > slack)) return Face::in_doubt;  // on which side?
  const double side = height < 0 ? -1 : 1, approach = side * rises[0],
               gap = side * height - q.radius * p.length;
  const Doubles margin = all4(0x1p-22 * p.farthest * p.area * p.longest);
  if (thick && deep(s, q.radius, gap, p.length) && (7 & bits(dot(cross(s.e, s.m), normal) > margin)) == 7) {
    if (!(approach > slack)) offer(found, 1, 0, 0, all4(0), all4(0));
    return Face::first;
  }
  if (approach > slack || gap + latest * approach > slack) return Face::out_of_time;  // leaving, or late

  // Where the path meets the face moved out, or, if they overlap, straight below: is it inside all sides?
  const bool apart = gap > slack;
  if (gap > -slack && !(-approach > hardly * p.length * p.farthest)) return Face::in_doubt;
  const double t = gap > 0 ? -gap / approach : 0, out = gap > 0 ? side * q.radius / p.length : 0;
  const Triple<Doubles> landing = along(along(s.m, all4(t), s.v), all4(-out), normal);
  const Doubles inside = dot(cross(s.e, landing), normal);
  if (7 & bits(inside < -margin)) return Face::out_of_time;
  if (!apart || !thick) return Face::in_doubt;
  // Seen along the path, at an angle of 2^-20 or more, twice the areas at the sides are then at least 2^-42
  // lengths longest; weights_where_line_meets rounds 2^-49 of that, and finds the same.
  const bool first = (7 & bits(inside > margin)) == 7;
  offer(found, 1, first, 0, all4(t), all4(-0x1p-24 * p.farthest * p.length / approach));
  return first ? Face::first : Face::perhaps;
}

/// The features of the triangle abc that may be touched by the time `latest`, and when.
static Found features_in_time(const Question& q, const double* a, const double* b, const double* c,
                              double latest, bool overlapping) {
  Found found;
  found.features = 0;
  found.within = false;
  found.late = __builtin_inf();
  const Outline s = outline(q, a, b, c);
  bool thick = false;
  const Face face = face_in_time(q, s, latest, found, thick);
  found.within = face == Face::first;
  if (found.within) return found;  // its edges and vertices are touched later
  if (face == Face::in_doubt) offer(found, 1, 0, 0, all4(0), all4(0));
  edges_in_time(s, latest, thick, found);
  vertices_in_time(s, latest, found);
  if (overlapping && found.features > 1) found.features &= ~hidden(q, s, thick);
  return found;
}

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
