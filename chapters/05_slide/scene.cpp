#include "scene.hpp"

#include "first_contact/program/mesh_loading.hpp"
#include "first_contact/program/terrain.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"

using namespace first_contact;

Environment Scene::environment() const {
  if (!mesh.empty()) return Environment(program::load_mesh(mesh));
  if (terrain > 0) return Environment(program::terrain(static_cast<std::uint32_t>(terrain)));
  return Environment(walls(ground_with_wall(wall)));
}
