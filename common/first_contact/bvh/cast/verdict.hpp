#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "first_contact/bvh/cast/known_surface.hpp"

namespace first_contact::bvh {

/// Decides, in doubles, about the triangles that a walk could not exclude.
///
/// The idea: it asks what the plain sweep asks (first_touch.hpp), but only of the faces, edges and vertices
/// that come near, and works out what lies around them when it must. So the answer is that of the plain sweep,
/// bit for bit.
class Verdict {
 public:
  Verdict(const Parts& parts, const Moving<Sphere>& sphere)
      : known_(parts, sphere.shape.radius), first_(known_, sphere) {}
  Verdict(const Verdict&) = delete;
  Verdict& operator=(const Verdict&) = delete;

  /// Considers a face, its edges and its vertices, those with a bit here: the face, the edges ab, bc, ca, the
  /// vertices a, b, c. Triangles of which no feature is in time are worth a mention too: they may be touched
  /// where another one is.
  /// \param within_face  \see touch_face
  void consider(const LeafFace& face, unsigned features, bool within_face = false);
  /// Begins once more, as if nothing had been considered.
  void forget();
  /// The time of the first contact so far; 2 if there is none.
  double latest() const { return first_.latest(); }
  std::optional<Contact> contact() const { return first_.contact(); }

 private:
  /// Remembers some features that were considered, since neighbouring triangles share them.
  template <class Key>
  struct Recent {
    std::array<Key, 32> key;  // + 1, so that 0 is none; each has a place, where the last one that came stays
    bool filled = false;      // most casts ask for nothing here, and need no zeros
    bool seen(const Key& k);
  };

  void consider_edge(std::uint32_t p, std::uint32_t q);

  KnownSurface known_;
  FirstTouch<KnownSurface> first_;
  Recent<std::uint64_t> edges_;
  Recent<std::uint32_t> vertices_;
};

}  // namespace first_contact::bvh
