#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/sweep/first_touch.hpp"

namespace first_contact::bvh {

/// What one cast knows of the surface: the triangles that it has considered, and, when asked, what lies around
/// an edge or a vertex. \see FirstTouch
class KnownSurface {
 public:
  /// \param r  the sphere's radius
  KnownSurface(const Parts& parts, double r) : parts_(parts), radius_(r) {}

  /// Notes that a triangle is considered. As a rule they are few, and need no memory of their own.
  void note(const LeafFace& face) {
    if (count_ < first_.size())
      first_[count_++] = face;
    else
      more_.push_back(face);
  }
  /// Begins once more.
  void forget() {
    count_ = 0;
    more_.clear();
  }

  Facet facet(const LeafFace& face) const {
    const auto& [a, b, c] = face.corner;
    return Facet({position(a), position(b), position(c)});
  }
  ///@{
  /// \see FirstTouch
  const Point& position(std::uint32_t vertex) const { return parts_.mesh.vertices()[vertex]; }
  FacesAround around(const Touch& touch, std::uint32_t from, std::uint32_t to) const;
  std::vector<FaceAt> faces_at(std::uint32_t from, std::uint32_t to) const;
  /// All faces that reach what is touched were considered.
  template <class Visit>
  void each_near(const std::array<std::uint32_t, 3>&, const Visit& visit) const {
    const auto show = [&](const LeafFace& face) { visit(face.number, face.corner); };
    std::for_each_n(first_.begin(), count_, show);
    std::for_each(more_.begin(), more_.end(), show);
  }
  ///@}

 private:
  template <class Visit>
  void each_face_at(std::uint32_t from, std::uint32_t to, const Visit& visit) const;

  const Parts& parts_;
  double radius_;
  std::array<LeafFace, 16> first_;
  std::size_t count_ = 0;
  std::vector<LeafFace> more_;
};

}  // namespace first_contact::bvh
