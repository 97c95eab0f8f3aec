#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "first_contact/bvh/build/surface.hpp"
#include "first_contact/sweep/first_touch.hpp"

namespace first_contact::bvh {

/// What one cast knows of the surface: the triangles that it has considered, and, when asked, what lies around
/// an edge or a vertex. \see FirstTouch
class KnownSurface {
 public:
  /// \param r  the sphere's radius
  KnownSurface(const Surface& surface, double r) : surface_(surface), radius_(r) {}

  /// Notes that a triangle is considered. As a rule they are few, and need no memory of their own.
  void note(const Place& place) {
    if (count_ < first_.size())
      first_[count_++] = &place;
    else
      more_.push_back(&place);
  }
  /// Begins once more.
  void forget() {
    count_ = 0;
    more_.clear();
  }

  ///@{
  /// \see FirstTouch
  const Point& position(std::uint32_t vertex) const { return surface_.position(vertex); }
  std::uint32_t mesh_number(std::uint32_t vertex) const { return surface_.number(vertex); }
  Lead lead(const Touch& touch, std::uint32_t from, std::uint32_t to) const;
  std::vector<FaceAt> faces_at(std::uint32_t from, std::uint32_t to) const;
  std::uint32_t lowest_face_at(std::uint32_t from, std::uint32_t to) const;
  /// All faces that reach what is touched were considered.
  template <class Visit>
  void each_near(const std::array<std::uint32_t, 3>&, const Visit& visit) const {
    const auto show = [&](const Place* place) { visit(place->number, place->corner); };
    std::for_each_n(first_.begin(), count_, show);
    std::for_each(more_.begin(), more_.end(), show);
  }
  ///@}

 private:
  const Surface& surface_;
  double radius_;
  std::array<const Place*, 16> first_;
  std::size_t count_ = 0;
  std::vector<const Place*> more_;
};

}  // namespace first_contact::bvh
