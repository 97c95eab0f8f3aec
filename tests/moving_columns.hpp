#pragma once
#include <array>
#include <vector>

#include "first_contact/batch/batch.hpp"

/// Moving spheres or boxes, spread over columns of their own.
class MovingColumns {
 public:
  explicit MovingColumns(const std::vector<first_contact::Moving<first_contact::Sphere>>& spheres)
      : columns_(7) {
    for (const auto& sphere : spheres) {
      append(0, sphere.shape.center);
      columns_[3].push_back(sphere.shape.radius);
      append(4, sphere.displacement);
    }
  }
  explicit MovingColumns(const std::vector<first_contact::Moving<first_contact::Box>>& boxes) : columns_(15) {
    for (const auto& box : boxes) {
      append(0, box.shape.center);
      append(3, box.shape.r);
      append(6, box.shape.s);
      append(9, box.shape.t);
      append(12, box.displacement);
    }
  }

  first_contact::MovingSpheres spheres() const { return {at(0), columns_[3], at(4)}; }
  first_contact::MovingBoxes boxes() const { return {at(0), {at(3), at(6), at(9)}, at(12)}; }
  /// Three columns, from that one on.
  first_contact::Columns at(std::size_t first) const {
    return {columns_[first], columns_[first + 1], columns_[first + 2]};
  }
  std::vector<double>& column(std::size_t number) { return columns_[number]; }

 private:
  void append(std::size_t first, const first_contact::Vector& v) {
    for (std::size_t k = 0; k < 3; ++k) columns_[first + k].push_back(v[static_cast<Eigen::Index>(k)]);
  }

  std::vector<std::vector<double>> columns_;
};
