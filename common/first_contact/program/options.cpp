// The options of a chapter that are numbers, vectors, planes and words.
#include <charconv>

#include "first_contact/program/numbers.hpp"
#include "first_contact/program/program.hpp"

namespace first_contact::program {

namespace {

void obey(const Program::Rule& rule, double value) {
  const std::string broken = rule ? rule(value) : "";
  if (!broken.empty()) throw Refused(broken);
}

std::string joined(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + readable(number);
  return text;
}

}  // namespace

void Program::option(const std::string& name, double& value, const std::string& letters, const Text& help,
                     const Rule& rule) {
  add(name, letters, help, readable(value), [&value, rule](const std::string& text) {
    const double number = number_of(text);
    obey(rule, number);
    value = number;
  });
}

void Program::option(const std::string& name, long& value, const std::string& letters, const Text& help,
                     const Rule& rule) {
  add(name, letters, help, std::to_string(value), [&value, rule](const std::string& text) {
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) throw Refused("must be a whole number");
    obey(rule, static_cast<double>(number));
    value = number;
  });
}

void Program::option(const std::string& name, Vector& value, const std::string& letters, const Text& help) {
  add(name, letters, help, joined({value.x(), value.y(), value.z()}), [&value](const std::string& text) {
    const auto numbers = numbers_of(text, 3);
    value = {numbers[0], numbers[1], numbers[2]};
  });
}

void Program::option(const std::string& name, Eigen::Vector2d& value, const std::string& letters,
                     const Text& help, const Rule& rule, Range range) {
  add(name, letters, help, joined({value.x(), value.y()}), [&value, rule, range](const std::string& text) {
    const auto numbers = numbers_of(text, 2, range);
    for (const double number : numbers) obey(rule, number);
    value = {numbers[0], numbers[1]};
  });
}

void Program::option(const std::string& name, Plane& value, const std::string& letters, const Text& help) {
  const Homogeneous& e = value.coefficients();
  add(name, letters, help, joined({e.x(), e.y(), e.z(), e.w()}), [&value](const std::string& text) {
    const auto numbers = numbers_of(text, 4);
    value = Plane({numbers[0], numbers[1], numbers[2]}, numbers[3]);
  });
}

void Program::option(const std::string& name, std::string& value, const std::string& letters,
                     const Text& help) {
  add(name, letters, help, value, [&value](const std::string& text) {
    if (text.empty()) throw Refused("must not be empty");
    value = text;
  });
}

}  // namespace first_contact::program
