#include "first_contact/pairs/first_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "first_contact/pairs/space_time.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

namespace first_contact {

namespace {

using Spheres = std::span<const Moving<Sphere>>;

bool contact_earlier(const PairContact& a, const PairContact& b) {
  return std::tie(a.contact.time, a.first, a.second) < std::tie(b.contact.time, b.first, b.second);
}

double travel(const Moving<Sphere>& sphere) { return sphere.displacement.cwiseAbs().maxCoeff(); }

// How wide the spheres lie at the start, without the outermost quarter: one that is far away is no measure.
double extent(Spheres spheres) {
  const std::size_t eighth = spheres.size() / 8;
  std::vector<double> places(spheres.size());
  double widest = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::transform(spheres.begin(), spheres.end(), places.begin(),
                   [axis](const Moving<Sphere>& sphere) { return sphere.shape.center[axis]; });
    const auto place = [&](std::size_t rank) {
      const auto at = places.begin() + static_cast<std::ptrdiff_t>(rank);
      std::nth_element(places.begin(), at, places.end());
      return *at;
    };
    widest = std::max(widest, place(spheres.size() - 1 - eighth) - place(eighth));
  }
  return widest;
}

//! [length_of_pieces]
// Pieces shorter than the way to the next sphere gain nothing. And the mean motion is cut into eight or less:
// as the number of pieces of one is rounded up to a power of two, there are never more than 17 times as many
// as spheres.
double length_of_pieces(Spheres spheres) {
  const auto count = static_cast<double>(spheres.size());
  double mean_travel = 0;
  for (const auto& sphere : spheres) mean_travel += travel(sphere) / count;
  return std::max(extent(spheres) / std::cbrt(count), mean_travel / 8);
}
//! [length_of_pieces]

//! [piece]
// Where the sphere is from time k / n to (k + 1) / n.
SpaceTimeBox piece(const Moving<Sphere>& sphere, std::size_t owner, double k, double n) {
  const auto& [center, radius] = sphere.shape;
  const double margin = box_margin * (center.cwiseAbs().maxCoeff() + travel(sphere) + radius) + 0x1p-1070;
  const Point begin = center + k / n * sphere.displacement, end = center + (k + 1) / n * sphere.displacement;
  SpaceTimeBox box;
  box.low << begin.cwiseMin(end).array() - (radius + margin), k / n;
  box.high << begin.cwiseMax(end).array() + (radius + margin), (k + 1) / n;
  box.owner = owner;
  return box;
}
//! [piece]

std::vector<SpaceTimeBox> pieces(Spheres spheres) {
  std::vector<SpaceTimeBox> all;
  all.reserve(spheres.size());
  const double length = length_of_pieces(spheres);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double longest = std::max(length, 2 * spheres[i].shape.radius);
    double n = 1;  // a power of two: the times are exact
    while (travel(spheres[i]) > n * longest) n *= 2;
    for (double k = 0; k < n; ++k) all.push_back(piece(spheres[i], i, k, n));
  }
  return all;
}

// Is the time within the piece's? Its beginning belongs to it, its end to the next one, if there is one.
bool happens_in(const SpaceTimeBox& piece, double time) {
  return piece.low[3] <= time && (time < piece.high[3] || piece.high[3] == 1);
}

//! [each_contact]
// Hands each pair of spheres that meet to `take`, once. Spheres that could only meet later than `latest` are
// not swept.
template <class Take>
void each_contact(Spheres spheres, const double& latest, PairStatistics* counted, const Take& take) {
  if (spheres.empty()) return;
  std::vector<SpaceTimeBox> boxes = pieces(spheres);
  PairStatistics did{boxes.size(), 0, 0};
  did.boxes = show_overlaps(boxes, [&](const SpaceTimeBox& a, const SpaceTimeBox& b) {
    if (std::max(a.low[3], b.low[3]) > latest) return;
    const auto [i, j] = std::minmax(a.owner, b.owner);
    ++did.sweeps;
    auto contact = sweep(spheres[i], spheres[j]);
    if (contact && happens_in(a, contact->time) && happens_in(b, contact->time))
      take(PairContact{i, j, std::move(*contact)});
  });
  if (counted) *counted = did;
}
//! [each_contact]

}  // namespace

//! [one_by_one]
std::vector<PairContact> first_contacts_one_by_one(Spheres spheres) {
  std::vector<PairContact> found;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j)
      if (auto contact = sweep(spheres[i], spheres[j])) found.push_back({i, j, std::move(*contact)});
  std::sort(found.begin(), found.end(), contact_earlier);
  return found;
}
//! [one_by_one]

//! [first_contacts]
std::vector<PairContact> first_contacts(Spheres spheres, PairStatistics* counted) {
  std::vector<PairContact> found;
  each_contact(spheres, 1.0, counted, [&](PairContact&& pair) { found.push_back(std::move(pair)); });
  std::sort(found.begin(), found.end(), contact_earlier);
  return found;
}

std::optional<PairContact> earliest_contact(Spheres spheres, PairStatistics* counted) {
  std::optional<PairContact> first;
  double latest = 1;
  each_contact(spheres, latest, counted, [&](PairContact&& pair) {
    if (first && !contact_earlier(pair, *first)) return;
    first = std::move(pair);
    latest = first->contact.time;
  });
  return first;
}
//! [first_contacts]

}  // namespace first_contact
