#include "first_contact/trees/bsp_tree.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "first_contact/geometry/facet.hpp"

namespace first_contact {

namespace {

// What lies of a polygon in one part of space: convex, as the polygon is.
struct Piece {
  std::uint32_t polygon;
  std::vector<Point> outline;
};

// What a plane makes of pieces.
struct Parts {
  std::vector<Piece> front, back, within;
};

std::vector<Piece> whole(std::span<const Triangle> polygons) {
  std::vector<Piece> pieces;
  pieces.reserve(polygons.size());
  for (std::uint32_t i = 0; i < polygons.size(); ++i)
    pieces.push_back({i, {polygons[i].a, polygons[i].b, polygons[i].c}});
  return pieces;
}

std::optional<Plane> plane_of(const Triangle& polygon) {
  const Facet facet(polygon);
  if (!(facet.length > 0)) return std::nullopt;  // it has no plane
  return Plane::through(facet.corner, facet.unit_normal());
}

struct Position {
  bool in_front, behind;  // both: it must be cut; neither: it is within the plane
};

Position position(const Piece& piece, const Plane& plane, double thickness) {
  Position position{false, false};
  for (const Point& corner : piece.outline) {
    const double distance = plane.signed_distance(corner);
    position.in_front |= distance > thickness;
    position.behind |= distance < -thickness;
  }
  return position;
}

//! [cut]
// Parts a piece along a plane that it crosses; both parts get the very same new corners.
std::pair<Piece, Piece> cut(const Piece& piece, const Plane& plane) {
  Piece front{piece.polygon, {}}, back{piece.polygon, {}};
  const std::size_t n = piece.outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &p = piece.outline[i], &q = piece.outline[(i + 1) % n];
    const double at_p = plane.signed_distance(p), at_q = plane.signed_distance(q);
    if (at_p >= 0) front.outline.push_back(p);
    if (at_p <= 0) back.outline.push_back(p);
    if (!(at_p < 0 && at_q > 0) && !(at_p > 0 && at_q < 0)) continue;  // this side does not cross the plane
    const Point crossing = p + at_p / (at_p - at_q) * (q - p);
    front.outline.push_back(crossing);
    back.outline.push_back(crossing);
  }
  return {std::move(front), std::move(back)};
}
//! [cut]

// What a plane would do to some pieces.
struct Division {
  std::size_t front = 0, back = 0, cut = 0;

  std::size_t larger() const { return std::max(front, back) + cut; }
  // The better of two divisions leaves less in the larger half, and cuts less.
  bool operator<(const Division& other) const {
    return std::pair(larger() + cut, cut) < std::pair(other.larger() + other.cut, other.cut);
  }
};

Division divide(const std::vector<Piece>& pieces, const Plane& plane, double thickness) {
  Division division;
  for (const Piece& piece : pieces) {
    const auto [in_front, behind] = position(piece, plane, thickness);
    division.front += in_front && !behind;
    division.back += behind && !in_front;
    division.cut += in_front && behind;
  }
  return division;
}

}  // namespace

class BspTree::Builder {
 public:
  Builder(BspTree& tree, std::span<const Triangle> polygons, const BspLimits& limits)
      : tree_(tree), polygons_(polygons), limits_(limits) {
    Bounds all;
    for (const Triangle& polygon : polygons) all.extend(bounds_of(polygon));
    thickness_ = thickness * largest_coordinate(all);
  }

  // Makes a node of some pieces, and all below it. With a quota of pieces the tree cannot outgrow its limit:
  // where it is used up, polygons that cross each other stay together in a leaf.
  std::uint32_t build(std::vector<Piece> pieces, std::size_t quota, std::size_t depth) {
    const auto number = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    tree_.depth_ = std::max(tree_.depth_, depth);
    std::optional<Plane> plane;
    if (pieces.size() > limits_.capacity && depth < limits_.depth) plane = best_plane(pieces, quota);
    if (!plane) {
      keep(number, pieces);
      return number;
    }
    Parts parts = part(pieces, *plane);
    pieces.clear();
    keep(number, parts.within);
    quota -= parts.within.size();
    const std::size_t both = parts.front.size() + parts.back.size();
    const std::size_t front_quota = quota / std::max<std::size_t>(1, both) * parts.front.size();
    const std::uint32_t front = build(std::move(parts.front), front_quota, depth + 1);
    const std::uint32_t back = build(std::move(parts.back), quota - front_quota, depth + 1);
    tree_.nodes_[number].plane = plane;
    tree_.nodes_[number].front = front;
    tree_.nodes_[number].back = back;
    return number;
  }

 private:
  //! [best_plane]
  // Of some of the polygons, evenly chosen, the one whose plane divides best; none if none gets further.
  std::optional<Plane> best_plane(const std::vector<Piece>& pieces, std::size_t quota) const {
    std::optional<Plane> best;
    Division least;
    const std::size_t step = (pieces.size() + limits_.candidates - 1) / limits_.candidates;
    for (std::size_t i = 0; i < pieces.size(); i += step) {
      const auto plane = plane_of(polygons_[pieces[i].polygon]);
      if (!plane) continue;
      tree_.work_ += pieces.size();
      const Division division = divide(pieces, *plane, thickness_);
      const bool useful = division.larger() < pieces.size() && pieces.size() + division.cut <= quota;
      if (!useful || (best && !(division < least))) continue;
      best = plane;
      least = division;
    }
    return best;
  }
  //! [best_plane]

  Parts part(const std::vector<Piece>& pieces, const Plane& plane) const {
    Parts parts;
    tree_.work_ += pieces.size();
    for (const Piece& piece : pieces) {
      const auto [in_front, behind] = position(piece, plane, thickness_);
      if (in_front && behind) {
        auto [front, back] = cut(piece, plane);
        parts.front.push_back(std::move(front));
        parts.back.push_back(std::move(back));
      } else {
        (in_front ? parts.front : behind ? parts.back : parts.within).push_back(piece);
      }
    }
    return parts;
  }

  void keep(std::uint32_t node, const std::vector<Piece>& pieces) {
    tree_.nodes_[node].begin = static_cast<std::uint32_t>(tree_.order_.size());
    for (const Piece& piece : pieces) tree_.order_.push_back(piece.polygon);
    tree_.nodes_[node].end = static_cast<std::uint32_t>(tree_.order_.size());
  }

  BspTree& tree_;
  std::span<const Triangle> polygons_;
  BspLimits limits_;
  double thickness_ = 0;
};

BspTree::BspTree(std::span<const Triangle> polygons, const BspLimits& limits) {
  BspLimits within = limits;
  within.depth = std::min(limits.depth, BspLimits().depth);
  within.candidates = std::max<std::size_t>(1, limits.candidates);
  Builder(*this, polygons, within).build(whole(polygons), limits.growth * polygons.size(), 0);
}

void BspTree::search(Search& search) const {
  Shown shown;
  show(0, search, {}, shown, 0);
}

//! [show]
void BspTree::show(std::size_t node, Search& search, const Passage& part, Shown& shown,
                   std::size_t depth) const {
  search.count_node(depth);
  const Node& here = nodes_[node];
  if (here.is_leaf()) return test(here, search, shown);
  const Sides sides = search.sides(*here.plane, part);
  const auto show_front = [&] {
    if (!sides.front.empty()) show(here.front, search, sides.front, shown, depth + 1);
  };
  if (sides.front.enter <= sides.back.enter) show_front();
  if (sides.both()) test(here, search, shown);
  if (!sides.back.empty()) show(here.back, search, sides.back, shown, depth + 1);
  if (sides.front.enter > sides.back.enter) show_front();
}
//! [show]

void BspTree::test(const Node& node, Search& search, Shown& shown) const {
  for (std::uint32_t i = node.begin; i < node.end; ++i)
    if (shown.insert(order_[i]).second) search.test(order_[i]);
}

}  // namespace first_contact
