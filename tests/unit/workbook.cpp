// What the workbook's judge is made of: values, the smallest input, fairness, verdicts.
#include <limits>

#include "catch.hpp"
#include "workbook/convert.hpp"
#include "workbook/sheet_of.hpp"
#include "workbook/shrink.hpp"
#include "workbook/verdict.hpp"

using namespace workbook;

namespace {

enum class Colour { red, green };
struct Things {
  std::vector<Plane> planes;
  std::optional<double> time;
  std::pair<int, bool> pair;
  Colour colour = Colour::red;
};

/// How far x is from 2.
double distance(double x) { return x < 2 ? 2 - x : x - 2; }

Sheet distance_sheet() {
  Exercise<double(double)> exercise;
  exercise.names = {"x"};
  exercise.chosen = {{"left of 2", {1}}};
  exercise.random = [](Chance& chance) { return std::tuple{chance.number(-8, 8)}; };
  exercise.judge = distance;
  exercise.along = {"x", 0, 1, [](auto& input, double at) { std::get<0>(input) = at; }, 0};
  return SheetOf<double(double)>::make(exercise);
}

Verdict verdict_on(double (*answer)(double), const std::vector<Known>& known = {}) {
  return examine(distance_sheet(), known, [&](const Value& input) {
    return Reply{Reply::Kind::answer, answer_of(answer, input), ""};
  });
}

}  // namespace

TEST_CASE("Whatever goes into an exercise comes back from its line, to the last bit") {
  const Things things{{{{0.1, -0.0, 1e-310}, 3}, {}}, 1.0 / 3, {-7, true}, Colour::green};
  Things back;
  from_value(read_value(written(to_value(things))), back);
  CHECK(written(to_value(back)) == written(to_value(things)));
  CHECK(back.planes.size() == 2);
  CHECK(back.planes[0].N.x == 0.1);
  CHECK(std::signbit(back.planes[0].N.y));
  CHECK(back.time == 1.0 / 3);
  CHECK(back.pair == std::pair{-7, true});
  CHECK(back.colour == Colour::green);
  CHECK(written(to_value(std::optional<double>{})) == "-");
  CHECK(has_nan(read_value(written(to_value(std::nan(""))))));
}

TEST_CASE("Answers are the same to within a tolerance relative to the larger, or to the unit") {
  const auto alike = [](double a, double b, double unit) {
    return same(to_value(a), to_value(b), {1e-9, unit, false});
  };
  CHECK(alike(1e6, 1e6 + 1e-4, 1));
  CHECK_FALSE(alike(1e6, 1e6 + 1e-2, 1));
  CHECK(alike(0, 5e-10, 1));
  CHECK_FALSE(alike(0, 5e-10, 1e-3));
  CHECK_FALSE(alike(std::numeric_limits<double>::infinity(), 1e300, 1));
  CHECK_FALSE(same(to_value(std::optional<double>{}), to_value(0.0), {1e-9, 1, false}));
}

TEST_CASE("A list in any order has each part as often as the other") {
  const auto alike = [](const std::vector<int>& a, const std::vector<int>& b) {
    return same(to_value(a), to_value(b), {0, 1, true});
  };
  CHECK(alike({1, 2, 2}, {2, 1, 2}));
  CHECK_FALSE(alike({1, 2, 2}, {2, 1, 1}));
  CHECK_FALSE(alike({1, 2}, {1, 2, 2}));
}

TEST_CASE("An input that fails is made smaller until nothing smaller fails") {
  const auto smallest = [](const std::vector<double>& list, auto fails) {
    std::vector<double> result;
    from_value(shrunk(to_value(list), [&](const Value& value) { return fails(numbers_in(value)); }), result);
    return result;
  };
  const auto some_above_3 = [](const std::vector<double>& x) {
    return std::any_of(x.begin(), x.end(), [](double each) { return each > 3; });
  };
  CHECK(smallest({0.3, 7.61, -5, 9.22}, some_above_3) == std::vector<double>{7});
  const auto two_or_more = [](const std::vector<double>& x) { return x.size() >= 2; };
  CHECK(smallest({0.3, 7.61, -5, 9.22}, two_or_more) == std::vector<double>{0, 0});
}

TEST_CASE("An input whose answer rounding could decide is not asked") {
  Sheet sheet = distance_sheet();
  CHECK(is_fair(sheet, to_value(std::tuple{1.0})));
  sheet.judge = [](const Value& input) { return to_value(input.parts[0].number < 2); };
  CHECK(is_fair(sheet, to_value(std::tuple{1.0})));
  CHECK_FALSE(is_fair(sheet, to_value(std::tuple{2.0})));
}

TEST_CASE("A verdict: right, constant, known by all its answers, nearly right, or the smallest input") {
  using Kind = Verdict::Kind;
  CHECK(verdict_on([](double x) { return std::abs(x - 2); }).kind == Kind::right);
  CHECK(verdict_on([](double) { return 1.0; }).kind == Kind::constant);
  CHECK(verdict_on([](double x) { return std::abs(x - 2) * (1 + 1e-6); }).nearly);

  double (*const no_sign)(double) = [](double x) { return 2 - x; };
  const Known known{"no_sign", [&](const Value& input) { return answer_of(no_sign, input); }, {}};
  CHECK(verdict_on(no_sign, {known}).known->name == "no_sign");

  const Verdict other = verdict_on([](double x) { return x > 5 ? 2 - x : distance(x); }, {known});
  CHECK(other.kind == Kind::wrong);
  CHECK_FALSE(other.nearly);
  CHECK(other.probe.input.parts[0].number > 5);
  CHECK(other.probe.input.parts[0].number <= 8);
  CHECK(std::floor(other.probe.input.parts[0].number) == other.probe.input.parts[0].number);
}
