#include "scene.hpp"

#include "first_contact/program/mesh_loading.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"

using namespace first_contact;

Environment Scene::environment() const {
  return Environment(mesh.empty() ? walls(ground_with_wall(wall)) : program::load_mesh(mesh));
}
