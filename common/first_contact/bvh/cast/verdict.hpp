#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "first_contact/bvh/build/surface.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/moved_out.hpp"

namespace first_contact::bvh {

/// Decides, in doubles, about the triangles that a walk could not exclude.
///
/// The idea: it asks what the plain sweep asks (sphere_mesh.cpp), by the same functions and in the same order
/// of precedence, but only of the faces, edges and vertices that come near, and works out what lies around
/// them when it must. So the answer is that of the plain sweep, bit for bit.
class Verdict {
 public:
  Verdict(const Surface& surface, const Moving<Sphere>& sphere) : surface_(surface), moving_(sphere) {}

  /// Considers a face, its edges and its vertices, or only those with a bit here: the face, the edges ab, bc,
  /// ca, the vertices a, b, c. Triangles of which no feature is in time are worth a mention too: they may be
  /// touched where another one is.
  /// \param within_face  \see touch_face
  void consider(const Place& place, unsigned features, bool within_face = false);
  /// All of them.
  void consider(const Place& place) { consider(place, 127); }
  /// Begins once more, as if nothing had been considered.
  void forget();
  /// The time of the first contact so far; 2 if there is none.
  double latest() const { return first_ ? first_->time : 2; }
  std::optional<Contact> contact() const;

 private:
  using Vertices = std::array<std::uint32_t, 3>;

  /// Remembers some features that were considered, since neighbouring triangles share them.
  template <class Key>
  struct Recent {
    std::array<Key, 32> key;  // + 1, so that 0 is none; each has a place, where the last one that came stays
    bool filled = false;      // most casts ask for nothing here, and need no zeros
    bool seen(const Key& k);
  };

  /// The triangles that were considered. As a rule they are few, and need no memory of their own.
  struct Places {
    std::array<const Place*, 16> first;
    std::size_t count = 0;
    std::vector<const Place*> more;
    void add(const Place& place) {
      if (count < first.size())
        first[count++] = &place;
      else
        more.push_back(&place);
    }
  };

  bool too_late(const std::optional<Touch>& touch) const { return !touch || touch->time > latest(); }
  const Point& position(std::uint32_t vertex) const { return surface_.position(vertex); }
  void consider_edge(std::uint32_t p, std::uint32_t q);
  void consider_vertex(std::uint32_t vertex);
  enum class Surroundings { lead_away, lead_nearer, in_doubt };
  Surroundings surroundings(const Touch& touch, std::uint32_t from, std::uint32_t to) const;
  std::uint32_t first_face(std::uint32_t from, std::uint32_t to) const;
  bool is_seam(const std::vector<Facet>& facets, const std::vector<Vector>& along) const;
  void keep(const std::optional<Touch>& touch, const Vertices& vertices, std::uint32_t face);
  void keep_edge(const Touch& touch, std::uint32_t from, std::uint32_t to);
  void keep_vertex(const Touch& touch, std::uint32_t vertex);
  std::uint32_t lowest_triangle() const;
  bool comes_first(const Vertices& vertices, std::uint32_t face) const;
  bool reaches(const Place& place, double tolerance) const;

  const Surface& surface_;
  const Moving<Sphere>& moving_;
  std::optional<Touch> first_;
  Vertices vertices_{};     // of the feature that is touched first, some of them twice
  std::uint32_t face_ = 0;  // one that has this feature
  Places considered_;
  Recent<std::uint64_t> edges_;
  Recent<std::uint32_t> vertices_seen_;
};

}  // namespace first_contact::bvh
