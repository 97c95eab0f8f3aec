#include "first_contact/pairs/space_time.hpp"

#include <algorithm>
#include <limits>

namespace first_contact {

namespace {

using Boxes = std::span<SpaceTimeBox>;
using Show = std::function<void(const SpaceTimeBox&, const SpaceTimeBox&)>;

SpaceTimeBox bounds_of(Boxes boxes) {
  SpaceTimeBox all = boxes.front();
  for (const SpaceTimeBox& box : boxes) {
    all.low = all.low.min(box.low);
    all.high = all.high.max(box.high);
  }
  return all;
}

// The axis on which the boxes' middles lie farthest apart, on average, as measured in boxes.
Eigen::Index widest_axis(Boxes boxes) {
  SpaceTimeBox::Corner middle = SpaceTimeBox::Corner::Zero(), size = middle, spread = middle;
  const double share = 1 / static_cast<double>(boxes.size());
  for (const SpaceTimeBox& box : boxes) {
    middle += share * (0.5 * box.low + 0.5 * box.high);
    size += share * (box.high - box.low);
  }
  for (const SpaceTimeBox& box : boxes) spread += share * (0.5 * box.low + 0.5 * box.high - middle).abs();
  Eigen::Index axis = 0;
  (spread / size.max(std::numeric_limits<double>::min())).maxCoeff(&axis);
  return axis;
}

class OverlapSearch {
 public:
  explicit OverlapSearch(const Show& show) : show_(show) {}

  std::size_t tests() const { return tests_; }

  //! [overlaps_within]
  void within(Boxes boxes) {
    if (boxes.size() <= few) return each_with_the_next(boxes);
    const auto [left, right] = halves(boxes);
    between(reaching(left, bounds_of(right)), reaching(right, bounds_of(left)));
    within(left);
    within(right);
  }
  //! [overlaps_within]

 private:
  static constexpr std::size_t few = 8;  // so many are tested one by one

  static std::pair<Boxes, Boxes> halves(Boxes boxes) {
    const Eigen::Index axis = widest_axis(boxes);
    const std::size_t half = boxes.size() / 2;
    std::nth_element(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(half), boxes.end(),
                     [axis](const SpaceTimeBox& a, const SpaceTimeBox& b) {
                       return 0.5 * a.low[axis] + 0.5 * a.high[axis] < 0.5 * b.low[axis] + 0.5 * b.high[axis];
                     });
    return {boxes.first(half), boxes.subspan(half)};
  }

  std::vector<SpaceTimeBox> reaching(Boxes boxes, const SpaceTimeBox& bounds) {
    tests_ += boxes.size();
    std::vector<SpaceTimeBox> found;
    for (const SpaceTimeBox& box : boxes)
      if (overlap(box, bounds)) found.push_back(box);
    return found;
  }

  //! [overlaps_between]
  void between(std::vector<SpaceTimeBox> a, std::vector<SpaceTimeBox> b) {
    if (a.size() < b.size()) std::swap(a, b);
    if (b.empty()) return;
    if (b.size() == 1 || a.size() <= few) return each_with_each(a, b);
    const auto [left, right] = halves(a);
    for (const Boxes half : {left, right}) {
      auto near_half = reaching(b, bounds_of(half));
      if (near_half.empty()) continue;
      const SpaceTimeBox bounds = bounds_of(near_half);
      between(reaching(half, bounds), std::move(near_half));
    }
  }
  //! [overlaps_between]

  void each_with_each(Boxes a, Boxes b) {
    for (const SpaceTimeBox& one : a)
      for (const SpaceTimeBox& other : b) test(one, other);
  }
  void each_with_the_next(Boxes boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j) test(boxes[i], boxes[j]);
  }
  void test(const SpaceTimeBox& a, const SpaceTimeBox& b) {
    ++tests_;
    if (overlap(a, b)) show_(a, b);
  }

  const Show& show_;
  std::size_t tests_ = 0;
};

}  // namespace

std::size_t show_overlaps(Boxes boxes, const Show& show) {
  OverlapSearch search(show);
  search.within(boxes);
  return search.tests();
}

}  // namespace first_contact
