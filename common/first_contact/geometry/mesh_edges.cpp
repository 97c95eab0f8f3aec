#include "first_contact/geometry/mesh_edges.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/weld.hpp"

namespace first_contact {

namespace {

using Index = std::uint32_t;

/// A side of a face on its way to becoming an edge: the two vertices, the lower number first, and whose side
/// it is.
struct HalfEdge {
  Index low, high;
  MeshEdges::Side side;
  auto key() const { return std::make_tuple(low, high, side.face, side.slot); }
  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> half_edges(const Mesh& mesh, const std::vector<Index>& representative) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * mesh.size());
  for (Index face = 0; face < mesh.size(); ++face)
    for (Index slot = 0; slot < 3; ++slot) {
      const Index p = representative[mesh.faces()[face][slot]];
      const Index q = representative[mesh.faces()[face][(slot + 1) % 3]];
      if (p != q) halves.push_back({std::min(p, q), std::max(p, q), {face, slot}});
    }
  std::sort(halves.begin(), halves.end(), [](const auto& a, const auto& b) { return a.key() < b.key(); });
  return halves;
}

/// The numbers of the items at each vertex, in increasing order, from pairs (vertex, item) in any order.
template <class Lists>
void gather(Lists& lists, std::size_t vertices, std::vector<std::pair<Index, Index>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  lists.first.assign(vertices + 1, 0);
  for (const auto& [vertex, item] : pairs) {
    ++lists.first[vertex + 1];
    lists.items.push_back(item);
  }
  std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
}

EdgeKind kind_of(const Mesh& mesh, const std::vector<Index>& representative,
                 std::span<const MeshEdges::Side> sides) {
  if (sides.size() == 1) return EdgeKind::boundary;
  if (sides.size() > 2) return EdgeKind::non_manifold;
  const auto start = [&](const MeshEdges::Side& side) { return mesh.faces()[side.face][side.slot]; };
  const auto end = [&](const MeshEdges::Side& side) { return mesh.faces()[side.face][(side.slot + 1) % 3]; };
  const Vector along = mesh.vertices()[end(sides[0])] - mesh.vertices()[start(sides[0])];
  const bool opposed = representative[start(sides[0])] == representative[end(sides[1])];
  return kind_of(Facet(mesh.triangle(sides[0].face)), Facet(mesh.triangle(sides[1].face)), along, opposed);
}

/// Beyond so many edges at a vertex the search below, cubic in their number, is not worth its time.
constexpr std::size_t most_edges_searched = 32;
/// Two unit edges whose cross product is shorter than this are parallel but for rounding, ...
constexpr double parallel_edges = 8 * std::numeric_limits<double>::epsilon();
/// ... and up to this length its direction is not sure to half the digits: the search gives no answer.
constexpr double nearly_parallel = 1e-7;

//! [buried]
/// Is there no direction w with w.e < 0 for all (unit) edges e? The directions with w.e <= 0 form a cone; its
/// extreme rays are at right angles to two of the edges (or to one, within their plane, if all edges lie in a
/// plane). If the sum of the extreme rays does not lead away from all edges, no direction does.
bool no_way_out(const std::vector<Vector>& edges) {
  const auto leads_away = [&](const Vector& w, double slack) {
    return std::all_of(edges.begin(), edges.end(), [&](const Vector& e) { return dot(w, e) <= slack; });
  };
  Vector inner = Vector::Zero();
  const auto offer = [&](const Vector& w) {
    for (const Vector& ray : {Vector(normalized(w)), Vector(-normalized(w))})
      if (leads_away(ray, parallel_edges / norm(w))) inner += ray;
  };
  for (auto e = edges.begin(); e != edges.end(); ++e)
    for (auto f = edges.begin(); f != e; ++f) {
      const Vector across = e->cross(*f);
      const double sine = norm(across);
      if (sine <= parallel_edges && e->dot(*f) < 0) return true;  // a straight edge goes through the vertex
      if (sine <= nearly_parallel) return false;                  // in doubt
      offer(across);
      offer(across.cross(*e));
      offer(across.cross(*f));
    }
  return edges.size() > 1 && !leads_away(inner, -parallel_edges);
}
//! [buried]

}  // namespace

//! [edge_kind]
EdgeKind kind_of(const Facet& first, const Facet& second, const Vector& along, bool opposed) {
  if (first.length == 0 || second.length == 0)
    return EdgeKind::boundary;  // a degenerate face continues nothing
  const Vector other = opposed ? second.normal : Vector(-second.normal);
  const Vector turn = first.normal.cross(other);  // |n| |n'| sin(angle), along the edge
  const double shape =
      first.longest * first.longest / first.length + second.longest * second.longest / second.length;
  const bool unbent = norm(turn) <= MeshEdges::flat_tolerance * shape * first.length * second.length;
  if (unbent)
    return dot(first.normal, other) > 0 ? EdgeKind::flat : EdgeKind::convex;  // or folded to a knife
  return dot(turn, along) > 0 ? EdgeKind::convex : EdgeKind::concave;
}
//! [edge_kind]

bool buried_by(const std::vector<Vector>& edges) {
  return edges.empty() || (edges.size() <= most_edges_searched && no_way_out(edges));
}

bool comes_before(const Point& p, const Point& q) {
  return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
}

MeshEdges::MeshEdges(const Mesh& mesh) : representative_(welded(mesh.vertices())) {
  collect_edges(mesh);
  collect_surroundings(mesh);
}

void MeshEdges::collect_edges(const Mesh& mesh) {
  const std::vector<HalfEdge> halves = half_edges(mesh, representative_);
  for (auto half = halves.begin(); half != halves.end();) {
    const auto next = std::find_if(half, halves.end(), [&](const auto& h) { return !h.same_edge(*half); });
    const auto first = static_cast<Index>(sides_.size());
    for (auto h = half; h != next; ++h) sides_.push_back(h->side);
    std::array<Index, 2> ends{half->low, half->high};
    if (comes_before(mesh.vertices()[ends[1]], mesh.vertices()[ends[0]])) std::swap(ends[0], ends[1]);
    const auto count = static_cast<Index>(next - half);
    const EdgeKind kind = kind_of(mesh, representative_, std::span(sides_).subspan(first, count));
    edges_.push_back({ends, kind, first, count});
    half = next;
  }
}

void MeshEdges::collect_surroundings(const Mesh& mesh) {
  std::vector<std::pair<Index, Index>> edge_pairs, face_pairs;
  for (Index i = 0; i < edges_.size(); ++i)
    for (const Index vertex : edges_[i].vertices) edge_pairs.emplace_back(vertex, i);
  for (Index i = 0; i < mesh.size(); ++i)
    for (const Index vertex : mesh.faces()[i]) face_pairs.emplace_back(representative_[vertex], i);
  gather(edges_at_, mesh.vertices().size(), std::move(edge_pairs));
  gather(faces_at_, mesh.vertices().size(), std::move(face_pairs));

  buried_.resize(mesh.vertices().size());
  for (Index vertex = 0; vertex < buried_.size(); ++vertex) {
    std::vector<Vector> directions;
    for (const Index edge : edges_at(vertex)) {
      const auto& [p, q] = edges_[edge].vertices;
      directions.push_back(normalized(mesh.vertices()[p == vertex ? q : p] - mesh.vertices()[vertex]));
    }
    // A degenerate mesh may shrink to a point: a vertex with a face but no edge is an obstacle all the same.
    const bool lone = directions.empty() && !faces_at(vertex).empty();
    buried_[vertex] = !lone && buried_by(directions);
  }
}

}  // namespace first_contact
