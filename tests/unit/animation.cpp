#include "first_contact/figure/animation.hpp"

#include <cmath>

#include "catch.hpp"

using namespace first_contact::figure;

namespace {

const Diagram diagram{{200, 100}, 0.1, 0.9, 0.2, 0.8, {Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 3)}};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
  return number;
}

}  // namespace

TEST_CASE("A diagram's corners are where its margins are, with y upwards") {
  CHECK((diagram.pixel({0, 0}) - Eigen::Vector2d(20, 80)).norm() < 1e-12);
  CHECK((diagram.pixel({4, 3}) - Eigen::Vector2d(180, 20)).norm() < 1e-12);
  CHECK(diagram.unit_y() == Approx(20));
}

TEST_CASE("A sparse motion keeps its corners and its ends, and is off by the tolerance at most") {
  std::vector<Moment> all;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    all.push_back({t, {t, std::abs(std::cos(7 * t))}});
  }
  const auto kept = sparse(all, 0.01);
  // A chord of width h is off by 49 h^2 / 8 at the most: 25 of them would do, and halving needs no more than
  // twice as many.
  CHECK(kept.size() <= 52);
  CHECK(kept.front().time == 0);
  CHECK(kept.back().time == 1);
  std::size_t next = 1;
  for (const Moment& moment : all) {
    while (kept[next].time < moment.time) ++next;
    const Moment &a = kept[next - 1], &b = kept[next];
    const double part = (moment.time - a.time) / (b.time - a.time);
    CHECK(((1 - part) * a.at + part * b.at - moment.at).norm() <= 0.01);
  }
}

TEST_CASE("A straight motion at constant speed needs its ends alone") {
  CHECK(sparse({{0, {0, 0}}, {1, {1, 2}}, {2, {2, 4}}, {3, {3, 6}}}, 1e-9).size() == 2);
  CHECK(sparse({{0, {0, 0}}}, 1).size() == 1);
}

TEST_CASE("A face that turns has its corners at each of its times, and holds the last ones") {
  Animation animation(diagram, 4, 4);
  animation.area({{0, {{0, 0}, {4, 0}, {4, 3}}}, {2, {{0, 0}, {2, 0}, {2, 3}}}}, colour::orange);
  const std::string svg = animation.over("<svg></svg>\n");
  const std::string first = "20,80 180,80 180,20", last = "20,80 100,80 100,20";
  CHECK(svg.find("values=\"" + first + ";" + last + ";" + last + "\"") != std::string::npos);
  CHECK(svg.find("keyTimes=\"0;0.5;1\"") != std::string::npos);
  CHECK(count(svg, "points=\"" + last + "\"") ==
        2);  // for a viewer that does not move, and for one that must not
  CHECK(svg.find("opacity") == std::string::npos);
}

TEST_CASE("A face that is turned away is not seen, and moves no corner meanwhile") {
  Animation animation(diagram, 2, 2);
  animation.area({{0, {}}, {1, {{0, 0}, {4, 0}, {4, 3}}}, {2, {}}}, colour::orange);
  animation.area({{0, {}}, {2, {}}}, colour::amber);  // one that is never seen is not there
  const std::string svg = animation.over("<svg></svg>\n"), corners = "20,80 180,80 180,20";
  CHECK(svg.find("values=\"" + corners + ";" + corners + ";" + corners + "\"") != std::string::npos);
  CHECK(svg.find("values=\"0;1;0\"") != std::string::npos);
  CHECK(count(svg, "<polygon") == 1);
}

TEST_CASE("What moves is laid over the svg, with a still for readers who asked for less motion") {
  Animation animation(diagram, 2, 4);
  animation.ball({{0, {0, 3}}, {1, {1, 0}}, {2, {2, 3}}}, 0.5, colour::blue);
  animation.trace({{0, {0, 3}}, {1, {1, 0}}, {2, {2, 3}}}, colour::red, 2);
  animation.stamp({1, {1, 0}}, 0.5, colour::blue, 0.3);
  animation.text("hit", {2, 2}, 1, 2, colour::ink, false);
  const std::string svg = animation.over("<svg><rect/></svg>\n");
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(svg.find("prefers-reduced-motion") != std::string::npos);
  CHECK(svg.find("values=\"20,20;60,80;100,20\"") != std::string::npos);
  CHECK(svg.find("keyTimes=\"0;0.5;1\"") != std::string::npos);
  CHECK(count(svg, "dur=\"4s\"") == 4);
  CHECK(count(svg, "<circle") == 4);
}
