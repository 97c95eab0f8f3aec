#pragma once
#include "first_contact/geometry/environment.hpp"
#include "first_contact/sweep/first_touch.hpp"

namespace first_contact {

/// An environment, as FirstTouch asks about it: each vertex goes by its lowest number in the mesh.
class KnownEnvironment {
 public:
  /// It must outlive this.
  explicit KnownEnvironment(const Environment& environment) : environment_(environment) {}

  /// The face's corners.
  std::array<std::uint32_t, 3> corners(std::size_t face) const {
    const auto& [a, b, c] = environment_.mesh().faces()[face];
    const MeshEdges& topology = environment_.topology();
    return {topology.representative(a), topology.representative(b), topology.representative(c)};
  }

  ///@{
  /// \see FirstTouch
  const Point& position(std::uint32_t vertex) const { return environment_.mesh().vertices()[vertex]; }
  FacesAround around(const Touch&, std::uint32_t, std::uint32_t) const { return {Lead::in_doubt, 0}; }
  std::vector<FaceAt> faces_at(std::uint32_t from, std::uint32_t to) const {
    std::vector<FaceAt> faces;
    for (const std::uint32_t number : environment_.topology().faces_at(from)) {
      const FaceAt face{number, corners(number), environment_.facet(number)};
      if (face.has(to)) faces.push_back(face);
    }
    return faces;
  }
  template <class Visit>
  void each_near(const std::array<std::uint32_t, 3>& vertices, const Visit& visit) const {
    for (const std::uint32_t vertex : vertices)
      for (const std::uint32_t face : environment_.topology().faces_at(vertex)) visit(face, corners(face));
  }
  ///@}

 private:
  const Environment& environment_;
};

}  // namespace first_contact
