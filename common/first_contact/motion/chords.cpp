#include "first_contact/motion/chords.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

constexpr double most_chords = 1e7;
constexpr int most_halvings = 26;

using Look = std::function<Glance(const Chord&)>;

//! [search]
std::optional<Contact> search(const Bezier& curve, double begin, double end, double allowed,
                              int halvings_left, const Look& look) {
  const double deviation = deviation_of_chord(curve);
  const bool straight_enough = deviation <= allowed || halvings_left == 0;
  const Chord chord{
      curve.control_points().front(), curve.control_points().back(), begin, end, deviation, straight_enough};
  const bool in_reach = deviation <= largest_length / 2 && in_range(chord.to - chord.from);
  if (in_reach) {
    Glance seen = look(chord);
    if (seen.contact) seen.contact->time = lerp(begin, end, seen.contact->time);
    if (straight_enough) return seen.contact;
    if (seen.clear) return std::nullopt;
  }
  const double middle = lerp(begin, end, 0.5);
  const auto first = search(curve.part(0, 0.5), begin, middle, allowed, halvings_left - 1, look);
  return first ? first : search(curve.part(0.5, 1), middle, end, allowed, halvings_left - 1, look);
}
//! [search]

}  // namespace

//! [chords]
std::vector<double> chords(const Curve& curve, double deviation) {
  if (!(deviation > 0) || !std::isfinite(deviation))
    refuse("chords' deviation", deviation, "must be finite and greater than zero");
  const double unit = unit_scale(largest_coordinate(curve));  // C'' is longer than that, by the degree
  const double bend = longest_control_vector(derivative(derivative(scaled(curve, unit))));
  const std::vector<double> joints = breaks(curve);
  std::vector<double> u{0};
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const double span = joints[i] - joints[i - 1];
    const double needed = std::max(1.0, std::ceil(span * std::sqrt(bend / (unit * deviation) / 8)));
    if (!(static_cast<double>(u.size()) + needed <= most_chords))
      refuse("chords' deviation", deviation, "too small for this curve");
    const auto count = static_cast<std::size_t>(needed);
    for (std::size_t k = 1; k < count; ++k)
      u.push_back(joints[i - 1] + span * static_cast<double>(k) / static_cast<double>(count));
    u.push_back(joints[i]);
  }
  return u;
}
//! [chords]

double deviation_of_chord(const Bezier& curve) {
  const std::vector<Point>& p = curve.control_points();
  const auto n = static_cast<double>(curve.degree());
  double longest = 0;  // of the control vectors of C'', but for their factor n (n - 1)
  for (std::size_t i = 2; i < p.size(); ++i)
    longest = std::max(longest, norm((p[i] - p[i - 1]) - (p[i - 1] - p[i - 2])));
  return n * (n - 1) / 8 * longest;
}

std::optional<Contact> first_along(const Bezier& curve, double begin, double end, double allowed,
                                   const Look& look) {
  return search(curve, begin, end, allowed, most_halvings, look);
}

}  // namespace first_contact
