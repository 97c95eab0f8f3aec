#pragma once
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/mesh_io/mesh_bytes.hpp"
#include "first_contact/mesh_io/polygons.hpp"

/// \file
/// The readers of the mesh formats. Programs include read_mesh.hpp instead.

namespace first_contact {

/// What a reader finds: vertices, and faces that name them.
struct RawMesh {
  std::vector<Point> vertices;  ///< all of them finite
  Polygons faces;               ///< each vertex that they name is there
};

/// Wavefront OBJ.
/// \throws MeshFileError
RawMesh read_obj(const MeshBytes& file);
/// OFF.
/// \throws MeshFileError
RawMesh read_off(const MeshBytes& file);
/// PLY, in ASCII or binary.
/// \throws MeshFileError
RawMesh read_ply(const MeshBytes& file);
/// STL, in ASCII or binary.
/// \throws MeshFileError
RawMesh read_stl(const MeshBytes& file);

/// The mesh in a file, whose format its name tells, with its faces cut into triangles.
/// \param notes  if given, it is told what had to be decided
/// \throws MeshFileError
Mesh read_mesh(const MeshBytes& file, ReadingNotes* notes);

}  // namespace first_contact
