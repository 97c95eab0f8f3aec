#include "first_contact/mesh_io/flat_polygon.hpp"

#include <algorithm>
#include <numeric>

#include "first_contact/mesh_io/orientation.hpp"

namespace first_contact {
namespace {

using Eigen::Vector2d;

// Two corners that follow each other.
struct Edge {
  Vector2d a, b;

  double low() const { return std::min(a.x(), b.x()); }
  double high() const { return std::max(a.x(), b.x()); }
};

bool cross(const Edge& e, const Edge& f) {
  if (std::max(e.a.y(), e.b.y()) < std::min(f.a.y(), f.b.y())) return false;
  if (std::max(f.a.y(), f.b.y()) < std::min(e.a.y(), e.b.y())) return false;
  return orientation(e.a, e.b, f.a) * orientation(e.a, e.b, f.b) < 0 &&
         orientation(f.a, f.b, e.a) * orientation(f.a, f.b, e.b) < 0;
}

// In a convex polygon the edges go to the right, then to the left: they change once each way.
std::size_t changes_of_direction(const FlatPolygon& polygon) {
  std::size_t changes = 0;
  int last = 0, first = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double x = polygon[i].x(), next = polygon[(i + 1) % polygon.size()].x();
    const int direction = (next > x) - (next < x);
    if (direction == 0) continue;
    if (first == 0) first = direction;
    changes += last != 0 && direction != last;
    last = direction;
  }
  return changes + (first != last);
}

// The corners that are left, each with those before and after it.
class Ears {
 public:
  explicit Ears(const FlatPolygon& polygon)
      : polygon_(polygon),
        before_(polygon.size()),
        after_(polygon.size()),
        turn_(polygon.size()),
        blocked_(polygon.size()) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      before_[i] = (i + n - 1) % n;
      after_[i] = (i + 1) % n;
    }
    for (std::size_t i = 0; i < n; ++i) measure(i);
  }

  std::vector<std::array<std::size_t, 3>> clip() {
    std::vector<std::array<std::size_t, 3>> triangles;
    std::size_t at = 0;
    for (std::size_t left = polygon_.size(); left > 2; --left) {
      at = next_ear(at, left);
      if (at == polygon_.size()) break;
      triangles.push_back({before_[at], at, after_[at]});
      cut(at);
      at = after_[after_[at]];
    }
    return triangles;
  }

 private:
  void measure(std::size_t i) {
    blocked_[i] = false;
    turn_[i] = orientation(polygon_[before_[i]], polygon_[i], polygon_[after_[i]]);
  }

  void cut(std::size_t i) {
    after_[before_[i]] = after_[i];
    before_[after_[i]] = before_[i];
    measure(before_[i]);
    measure(after_[i]);
  }

  // The next corner whose triangle can be cut off, one with an area if there is any; none: the number of
  // corners.
  std::size_t next_ear(std::size_t at, std::size_t left) {
    const std::size_t none = polygon_.size();
    std::size_t ear = next_free_ear(at, left);
    if (ear == none) {
      std::fill(blocked_.begin(), blocked_.end(), false);
      ear = next_free_ear(at, left);
    }
    for (; ear == none && left > 0; --left, at = after_[at])
      if (turn_[at] == 0) ear = at;
    return ear;
  }

  // A corner that was none stays none until a neighbour is cut off, for no other cut opens a diagonal. Only
  // where the outline touches itself one does: then all are looked at again.
  std::size_t next_free_ear(std::size_t at, std::size_t left) {
    for (; left > 0; --left, at = after_[at]) {
      if (turn_[at] <= 0 || blocked_[at]) continue;
      if (is_empty(at)) return at;
      blocked_[at] = true;
    }
    return polygon_.size();
  }

  // Only corners that are not convex can be within. One at the place of a corner of the triangle is no
  // obstacle: there the outline meets itself.
  bool is_empty(std::size_t ear) const {
    const Vector2d &a = polygon_[before_[ear]], &b = polygon_[ear], &c = polygon_[after_[ear]];
    for (std::size_t i = after_[after_[ear]]; i != before_[ear]; i = after_[i]) {
      const Vector2d& p = polygon_[i];
      if (turn_[i] > 0 || p == a || p == b || p == c) continue;
      if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) return false;
    }
    return true;
  }

  const FlatPolygon& polygon_;
  std::vector<std::size_t> before_, after_;
  std::vector<int> turn_;      // 1: convex; 0: on a straight line; -1: reflex
  std::vector<bool> blocked_;  // convex, but no ear when it was looked at
};

}  // namespace

bool is_strictly_convex(const FlatPolygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) <= 0) return false;
  return changes_of_direction(polygon) == 2;
}

bool crosses_itself(const FlatPolygon& polygon) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.low() < f.low(); });
  for (auto edge = edges.begin(); edge != edges.end(); ++edge)
    for (auto other = edge + 1; other != edges.end() && other->low() <= edge->high(); ++other)
      if (cross(*edge, *other)) return true;
  return false;
}

std::vector<std::array<std::size_t, 3>> clip_ears(const FlatPolygon& polygon) { return Ears(polygon).clip(); }

}  // namespace first_contact
