#include "first_contact/program/accuracy.hpp"

#include <algorithm>

namespace first_contact::program {

Accuracy accuracy(double distance, std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  const auto lost = static_cast<double>(std::count(errors.begin(), errors.end(), lost_shot));
  return {distance, errors[errors.size() / 2], lost / static_cast<double>(errors.size())};
}

}  // namespace first_contact::program
