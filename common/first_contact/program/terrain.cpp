#include "first_contact/program/terrain.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "first_contact/program/random.hpp"

namespace first_contact::program {

std::vector<Mesh::Face> grid_faces(std::uint32_t n) {
  std::vector<Mesh::Face> faces;
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      faces.push_back({a, b, d});
      faces.push_back({a, d, c});
    }
  return faces;
}

Mesh height_field(std::uint32_t n, double side, const std::function<double(double, double)>& height) {
  std::vector<Point> vertices;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = side * i / n, y = side * j / n;
      vertices.emplace_back(x, y, height(x, y));
    }
  return {std::move(vertices), grid_faces(n)};
}

Mesh terrain(std::uint32_t n, std::uint64_t seed) {
  constexpr double side = 64;
  Random random(seed);
  double phase[6];
  for (double& p : phase) p = random.number(0, 2 * std::numbers::pi);
  return height_field(n, side, [&](double x, double y) {
    const double rough = 0.1 * side / n * random.number(-1, 1);
    const double height = 1.5 * std::sin(0.21 * x + phase[0]) * std::cos(0.17 * y + phase[1]) +
                          0.5 * std::sin(0.9 * x + phase[2]) * std::sin(1.1 * y + phase[3]) +
                          0.1 * std::sin(3.1 * x + phase[4]) * std::sin(2.7 * y + phase[5]) + rough;
    return std::ldexp(std::round(std::ldexp(height, 30)),
                      -30);  // the sines' last bits differ between C libraries
  });
}

}  // namespace first_contact::program
