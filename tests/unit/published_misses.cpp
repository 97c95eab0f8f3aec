// Hits that other engines and tutorials missed or invented, from their public bug reports; each names its
// source. The answers are those of our contract, the times computed with 80 digits.
#include <fstream>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "places.hpp"

using namespace first_contact;
using nlohmann::json;

namespace {

json published_misses() {
  std::ifstream file(std::string(first_contact::places::source) + "/tests/data/published-misses.json");
  REQUIRE(file);
  return json::parse(file);
}

Vector vector_from(const json& numbers, std::size_t at = 0) {
  return {numbers[at].get<double>(), numbers[at + 1].get<double>(), numbers[at + 2].get<double>()};
}

Mesh mesh_from(const json& triangles) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const json& corners : triangles) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const std::size_t at : {0U, 3U, 6U}) vertices.push_back(vector_from(corners, at));
    faces.push_back({first, first + 1, first + 2});
  }
  return {std::move(vertices), std::move(faces)};
}

void check_answer(const std::optional<Contact>& contact, const json& expected) {
  REQUIRE(contact.has_value() == expected["hit"].get<bool>());
  if (!contact) return;
  CHECK(contact->time == Approx(expected["time"].get<double>()).epsilon(1e-14).margin(1e-15));
  CHECK((contact->normal - vector_from(expected["normal"])).norm() < 1e-13);
  CHECK(std::string(to_string(contact->feature)) == expected["feature"].get<std::string>());
}

}  // namespace

TEST_CASE("What others have missed, or seen where nothing was, is answered by the contract") {
  for (const json& miss : published_misses()) {
    INFO(miss["id"] << ", reported in " << miss["source"]);
    const Sphere sphere{vector_from(miss["start"]), miss["radius"].get<double>()};
    const Vector displacement = vector_from(miss["displacement"]);
    const Mesh mesh = mesh_from(miss["triangles"]);
    const json& expected = miss["expect"];

    const auto contact = sweep(Moving<Sphere>{sphere, displacement}, Environment(mesh));
    check_answer(contact, expected);
    if (contact) CHECK(contact->triangle == expected["triangle"].get<std::size_t>());

    check_answer(sweep(Moving<Sphere>{sphere, displacement}, Bvh(mesh)), expected);
    if (mesh.size() == 1)
      check_answer(sweep(Moving<Sphere>{sphere, displacement}, mesh.triangle(0)), expected);
    if (mesh.size() == 1 && sphere.radius == 0)
      check_answer(sweep(Moving<Point>{sphere.center, displacement}, mesh.triangle(0)), expected);
  }
}
