// Chapter 5: a sphere slides along what it meets (paper, 2.2).
#include "first_contact/response/slide.hpp"

#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "scene.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace {

Text text_of(Ending ending) {
  switch (ending) {
    case Ending::arrived:
      return {"all of the motion is made", "走完全程"};
    case Ending::cornered:
      return {"no way on: the sphere stands", "無路可滑：停止"};
    default:
      return {"too many contacts: the sphere stands", "碰撞次數過多：停止"};
  }
}

double length_of(const Slide& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.positions.size(); ++i)
    length += (path.positions[i] - path.positions[i - 1]).norm();
  return length;
}

//! [report]
// The first contact, and the paper's one projection.
void tell_projection(Report& report, const Environment& environment, const Moving<Sphere>& ball) {
  const Point p2 = ball.shape.center + ball.displacement;
  report.row("P1", ball.shape.center, {"centre of the sphere at the start", "起點（球心）"});
  report.row("P2", p2, {"where it is sent", "欲行進至的位置"});
  report.row("r", ball.shape.radius, {"radius of the sphere", "球面半徑"});
  const auto contact = sweep(ball, environment);
  if (!contact) return report.say({"It meets nothing on its way.", "途中沒有發生碰撞"});

  const Vector& n = contact->normal;
  const Point q = ball.shape.center + contact->time * ball.displacement, c = contact->point();
  const Point p3 = slide_target(p2, q, n), sunk = slide_target(p2, c, n);
  report.row("t", contact->time, {"time of the first contact", "碰撞時間"});
  report.row("Q = P1 + t(P2 - P1)", q, {"centre of the sphere at contact", "碰撞時的球心"});
  report.row("N", n, {"unit normal of the surface, to the sphere", "表面的單位法向量"});
  report.say({"As printed, the collision is \"at Q\"; with Q the point of the surface",
              "論文所印：「在 Q 會發生碰撞」；若 Q 取表面上的碰撞點"});
  report.row("C", c, {"point of contact", "碰撞點"});
  report.row("P2 - [(P2 - C).N] N", sunk, {"the sphere ends half sunk", "球面陷入表面一半"});
  report.row("(P3 - C).N", (sunk - c).dot(n),
             {"height of the centre above the wall; it should be r", "球心離牆高度；應為 r"});
  report.say({"Corrected: Q is the centre of the sphere", "修正：Q 為球心"});
  report.row("P3 = P2 - [(P2 - Q).N] N", p3, {"where it slides to", "滑行後的新位置"});
  report.row("(P3 - C).N ", (p3 - c).dot(n), {"height of the centre above the wall", "球心離牆高度"});
  report.row("|P3 - Q|", (p3 - q).norm(), {"distance that it slides", "滑行距離"});
}

// The whole slide: each corner of the path.
void tell_path(Report& report, const Slide& path, const Moving<Sphere>& ball) {
  report.say({"The slide, each motion swept: " + text_of(path.ending).english,
              "滑行的路徑（每段皆作碰撞偵測）：" + text_of(path.ending).chinese});
  report.row("contacts", static_cast<double>(path.contacts.size()),
             {"how often it meets a wall", "碰撞次數"});
  for (std::size_t i = 0; i < path.positions.size(); ++i)
    report.row("position " + std::to_string(i), path.positions[i],
               i == 0                           ? Text{"start", "起點"}
               : i + 1 == path.positions.size() ? Text{"end", "終點"}
                                                : Text{"it meets a wall", "碰撞"});
  report.row("length", length_of(path), {"of the path; never more than asked", "路徑長；不大於原距離"});
  report.row("|P2 - P1|", ball.displacement.norm(), {"asked", "原距離"});
}

// One projection alone leads into the next wall; the loop does not.
void tell_second_wall(Report& report, const std::vector<Rectangle>& room, const Moving<Sphere>& ball,
                      const Text& heading) {
  const Environment environment(walls(room));
  const Slide path = slide(ball, environment);
  const Contact& first = path.contacts[0];
  const Point p2 = ball.shape.center + ball.displacement;
  const Point q = ball.shape.center + first.time * ball.displacement;
  report.say(heading);
  report.row("P3", slide_target(p2, q, first.normal),
             {"after the first wall alone: beyond the second", "只算第一面牆：穿過第二面"});
  report.row("end", path.end(), text_of(path.ending));
}

// What is left of a gap that is laid back along the path, by the angle of approach.
void tell_gap(Report& report) {
  report.say({"The gap before the wall, laid back along the path by g or kept along the normal",
              "與牆的間隙 g：沿路徑或沿法向量"});
  for (const double degrees : {90.0, 10.0, 1.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Plane level({0, 0, 1}, 0);
    const Moving<Sphere> ball{{{0, 0, 2}, 1}, {2 / std::tan(angle), 0, -2}};
    const double gap = slide_gap * (2 + std::max(2.0, 2 / std::tan(angle)));
    const double kept = (slide(ball, level).positions[1].z() - 1) / gap;
    report.row("at " + readable(degrees) + " degrees",
               readable(std::sin(angle)) + " g, " + readable(std::round(kept * 100) / 100) + " g",
               {"height above the wall: along the path, along the normal", "離牆高度：沿路徑、沿法向量"});
  }
}
//! [report]

Json results(const Slide& path) {
  Json json;
  json["positions"] = Json::array();
  for (const Point& position : path.positions) json["positions"].push_back(to_json(position));
  json["contacts"] = Json::array();
  for (const Contact& contact : path.contacts)
    json["contacts"].push_back({{"time", contact.time},
                                {"point", to_json(contact.point())},
                                {"normal", to_json(contact.normal)},
                                {"feature", to_string(contact.feature)},
                                {"triangle", contact.triangle}});
  json["end"] = to_json(path.end());
  return json;
}

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("slide", "05_slide", "A sphere slides along what it meets (paper, 2.2).");
  Scene scene;
  program.option("--mesh", scene.mesh, "FILE", "the surface: .obj, .off, .ply or .stl; a level wall if none");
  program.option("--from", scene.from, "x,y,z", "P1, centre of the sphere at the start");
  program.option("--to", scene.to, "x,y,z", "P2, where it is sent");
  program.option("--radius", scene.radius, "r", "radius of the sphere", not_negative);
  return program.run(argc, argv, [&] {
    const auto environment = program.checked("--mesh", [&] { return scene.environment(); });
    const auto ball = program.checked("--to", [&] { return scene.ball(); });
    const Slide path = slide(ball, environment);
    Report& report = program.report();
    report.title({"A sphere slides along what it meets", "碰撞後的滑行距離"}, "2.2");
    tell_projection(report, environment, ball);
    tell_path(report, path, ball);
    tell_second_wall(report, crease, into_crease,
                     {"A second wall: the sphere goes on along the crease", "第二面牆：沿兩牆的交線滑行"});
    tell_second_wall(report, corner, into_corner,
                     {"A third wall: the sphere stops in the corner", "第三面牆：停在角落"});
    tell_gap(report);
    program.json() = results(path);
    if (program.draws()) draw_slide_figures(program, environment, ball, path);
  });
}
//! [main]
