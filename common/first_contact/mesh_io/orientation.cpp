#include "first_contact/mesh_io/orientation.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace first_contact {
namespace {

using Eigen::Vector2d;

int sign(double value) { return (value > 0) - (value < 0); }

// A sum of doubles without rounding: each is smaller than the last bit of the next, so that the last that is
// not 0 has the sign of all.
class Sum {
 public:
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  int sign() const {
    for (std::size_t i = size_; i-- > 0;)
      if (parts_[i] != 0) return first_contact::sign(parts_[i]);
    return 0;
  }

 private:
  void add(double carried) {
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = carried + parts_[i], added = sum - carried;
      parts_[i] = (carried - (sum - added)) + (parts_[i] - added);
      carried = sum;
    }
    parts_[size_++] = carried;
  }

  std::array<double, 12> parts_{};
  std::size_t size_ = 0;
};

int exact_orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  Sum sum;
  sum.add_product(a.x(), b.y());
  sum.add_product(-a.y(), b.x());
  sum.add_product(b.x(), c.y());
  sum.add_product(-b.y(), c.x());
  sum.add_product(c.x(), a.y());
  sum.add_product(-c.y(), a.x());
  return sum.sign();
}

}  // namespace

int orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  // Two differences, a product and a difference of products: 3 eps + 16 eps^2 of the products' size, eps =
  // 2^-53.
  constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
  const double left = (a.x() - c.x()) * (b.y() - c.y()), right = (a.y() - c.y()) * (b.x() - c.x());
  const double area = left - right;
  return std::abs(area) > rounding * (std::abs(left) + std::abs(right)) ? sign(area)
                                                                        : exact_orientation(a, b, c);
}

}  // namespace first_contact
