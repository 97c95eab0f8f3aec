#include "nearly_touching.hpp"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "first_contact/program/accuracy.hpp"
#include "first_contact/program/random.hpp"
#include "first_contact/sweep/contact_times.hpp"

using namespace first_contact;
using program::uniform, program::unit_vector;

namespace {

double median(std::vector<double> errors) { return program::accuracy(0, std::move(errors)).error; }

}  // namespace

//! [nearly_touching]
NearErrors nearly_touching(double gap) {
  std::mt19937 random(4);
  std::vector<double> by_difference, by_product;
  while (by_difference.size() < 10000) {
    const Vector3<float> w = ((1 + gap) * unit_vector(random)).cast<float>();  // d is 1
    const Vector3<float> u = unit_vector(random).cast<float>();
    const auto truth = contact_times<double>(w.cast<double>(), u.cast<double>(), 1);
    if (!truth || !(w.dot(u) < -0.5F) || !(truth->begin > 0)) continue;
    const float b = w.dot(u), D = discriminant(u, accurate_cross(w, u), 1.0F), root = std::sqrt(D);
    const auto error = [&](float t) { return std::abs(static_cast<double>(t) / truth->begin - 1); };
    by_difference.push_back(error((-b - root) / u.squaredNorm()));
    by_product.push_back(error((w.squaredNorm() - 1) / (-b + root)));
  }
  return {median(std::move(by_difference)), median(std::move(by_product))};
}
//! [nearly_touching]
