#include "workbook/shrink.hpp"

#include <cmath>

namespace workbook {
namespace {

constexpr int most_tries = 2000;

// Plainer numbers, from the plainest on: each has fewer digits or is nearer to 0.
std::vector<double> plainer(double number) {
  std::vector<double> plain{0, 1, -1};
  for (const double step : {8.0, 1.0, 0.5, 0.25}) plain.push_back(std::trunc(number / step) * step);
  std::vector<double> less;
  for (const double each : plain) {
    if (each == number) break;
    if (std::abs(each) <= std::abs(number) || std::abs(number) < 1) less.push_back(each);
  }
  return less;
}

class Shrinking {
 public:
  Shrinking(Value input, const std::function<bool(const Value&)>& fails)
      : whole_(std::move(input)), fails_(fails) {}

  Value run() {
    do again_ = false, visit(whole_);
    while (again_ && tries_ < most_tries);
    return whole_;
  }

 private:
  // Keeps a change that still fails.
  bool keep(Value& place, Value changed) {
    if (++tries_ > most_tries) return false;
    std::swap(place, changed);
    if (fails_(whole_)) return again_ = true;
    std::swap(place, changed);
    return false;
  }

  void visit(Value& value) {
    if (value.kind == Value::Kind::list) shorten(value);
    if (value.kind == Value::Kind::number || value.kind == Value::Kind::whole)
      for (const double number : plainer(value.number))
        if (keep(value, {value.kind, number, {}})) break;
    for (Value& part : value.parts) visit(part);
  }

  void shorten(Value& list) {
    for (std::size_t i = list.parts.size(); i-- > 0;) {
      Value shorter = list;
      shorter.parts.erase(shorter.parts.begin() + static_cast<std::ptrdiff_t>(i));
      keep(list, shorter);
    }
  }

  Value whole_;
  const std::function<bool(const Value&)>& fails_;
  bool again_ = false;
  int tries_ = 0;
};

}  // namespace

Value shrunk(Value input, const std::function<bool(const Value&)>& fails) {
  return Shrinking(std::move(input), fails).run();
}

}  // namespace workbook
