#include "workbook/sheet.hpp"

#include <cmath>

namespace workbook {
namespace {

constexpr double blur = 1e-7;       // of every number, relative to it or to 1
constexpr double unmoved = 1e-3;    // how far the answer may follow
constexpr std::uint64_t seed = 15;  // of the random probes, and of the blur
constexpr int blurs = 6;

Value blurred(Value value, Chance& chance) {
  if (value.kind == Value::Kind::number)
    value.number += (chance.below(2) == 0 ? -blur : blur) * (1 + std::abs(value.number));
  for (Value& part : value.parts) part = blurred(part, chance);
  return value;
}

}  // namespace

bool is_fair(const Sheet& sheet, const Value& input) {
  if (!sheet.allowed(input)) return false;
  const Value right = sheet.judge(input);
  Sameness loose = sheet.sameness(input);
  loose.tolerance = unmoved;
  Chance chance(seed);
  for (int i = 0; i < blurs; ++i)
    if (!same(right, sheet.judge(blurred(input, chance)), loose)) return false;
  return true;
}

std::vector<Probe> probes_of(const Sheet& sheet, std::size_t random_ones) {
  std::vector<Probe> probes = sheet.chosen;
  for (Probe& probe : probes) probe.right = sheet.judge(probe.input);
  Chance chance(seed);
  const std::size_t wanted = probes.size() + random_ones;
  for (std::size_t tries = 0; tries < 50 * random_ones && probes.size() < wanted; ++tries) {
    const Value input = sheet.random(chance);
    if (is_fair(sheet, input)) probes.push_back({"", input, sheet.judge(input)});
  }
  return probes;
}

std::string told(const Sheet& sheet, const Value& input) {
  std::string text;
  for (std::size_t i = 0; i < sheet.names.size(); ++i)
    text += (i ? ", " : "") + sheet.names[i] + " = " + shown(input.parts.at(i));
  return text;
}

}  // namespace workbook
