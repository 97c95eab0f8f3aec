// Chapter 1: a moving sphere meets a plane (paper, 1.2).
#include "figures/figures.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/plane_error.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "frames.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace {

//! [scene]
struct Scene {
  Plane plane{{0, 0, 1}, 0};
  Point from{-0.9, 0, 2.1};
  Point to{0.75, 0, 0.5};
  double radius = 0.7;
  double length = 2;  // of a normal, in the formula as printed
  long frames = 0;    // at which one looks as well
};
//! [scene]

std::string at_most_a_thousand(double value) {
  return value >= 0 && value <= 1000 ? "" : "must be from 0 to 1000";
}

//! [report]
// Each number is given once: to the reader, and by the rest of its line to --json and to the notes.
void tell(Program& program, const Scene& scene, const Moving<Sphere>& ball,
          const std::optional<Contact>& contact) {
  Report& report = program.report();
  const Vector n = scene.plane.normal();
  program.result("/contact", nullptr);
  report.title({"A moving sphere meets a plane", "球面與平面之間的碰撞"}, "1.2");
  report.say({"The plane, and the sphere above it", "平面與球面"});
  report.row("N", n, {"unit normal of the plane E = [N, D]", "平面 E = [N, D] 的單位法向量"});
  report.row("D", scene.plane.offset(), {"signed distance of the origin", "原點到平面的距離"});
  program.row("r", scene.radius, {"radius of the sphere", "球面半徑"}).value("radius");
  program
      .row("E.S0", scene.plane.signed_distance(scene.from),
           {"distance of the centre at t = 0", "t = 0 時球心的距離"})
      .result("/distance_start");
  program
      .row("E.S1", scene.plane.signed_distance(scene.to),
           {"distance of the centre at t = 1", "t = 1 時球心的距離"})
      .result("/distance_end");
  program
      .row(
          "N.V", n.dot(ball.displacement),
          {"how much the centre rises in one motion; negative: it sinks", "球心沿法向量的位移，負值表示下降"})
      .value("toward");

  if (!contact) return report.say({"No contact within 0 <= t <= 1.", "0 <= t <= 1 之間沒有發生碰撞"});
  report.say({"The first contact: the centre meets the plane moved out by r, E' = [N, D - r]",
              "碰撞：球心位於位移 r 後的平面 E' = [N, D - r]"});
  program.row("t = -(E'.S0)/(E'.V)", contact->time, {"time of impact", "碰撞時間"}).result("/contact/time");
  program
      .row("S(t) = S0 + tV", Point(scene.from + contact->time * ball.displacement),
           {"centre at that time", "碰撞時的球心"})
      .result("/contact/center");
  program.row("C = S(t) - rN", contact->point(), {"point of contact", "碰撞點"}).result("/contact/point");
  program.result("/contact/normal", contact->normal);
}

// What the paper leaves open: the normal must have unit length, and only an approach within 0 <= t <= 1 is a
// collision.
void tell_corrections(Report& report, const Scene& scene, const Moving<Sphere>& ball) {
  const double distance = scene.plane.signed_distance(scene.from);
  const double toward = scene.plane.normal().dot(ball.displacement);
  const auto time = [&](double numerator, double denominator) {
    return denominator != 0 ? readable(numerator / denominator) : std::string("-");
  };
  report.say({"As printed: any N will do, and any N.V but 0 is a collision",
              "論文原式：N 不限單位長，N.V 不為零就會碰撞"});
  report.row("t with N", time(scene.radius - distance, toward), {"N of unit length", "N 為單位向量"});
  const std::string length = readable(scene.length);
  report.row("t with " + length + "N", time(scene.radius - scene.length * distance, scene.length * toward),
             {"the same plane, N " + length + " times as long: another time",
              "同一平面，N 為 " + length + " 倍長：時間不同"});
  report.say(
      {"Corrected: |N| = 1 by construction; a collision only if N.V < 0 on the sphere's side and 0 <= t <= 1",
       "修正：N 恆為單位長；僅當 N.V < 0 且 0 <= t <= 1 才是碰撞"});
  report.row("collision", std::string(sweep(ball, scene.plane) ? "true" : "false"),
             {"in this scene", "此場景"});
}

// What one learns who looks at the frames of a film alone.
void tell_frames(Program& program, const Scene& scene, const Moving<Sphere>& ball) {
  if (scene.frames == 0) return;
  const auto first = first_frame_of_overlap(scene.frames, ball, scene.plane);
  program.report().say({"Asking at the frames of a film alone, and not between them", "只在每一格畫面檢查"});
  program.row("frames", scene.frames, {"after the one at t = 0", "t = 0 之後的格數"});
  program.row("first", first ? readable(*first) : std::string("-"),
              {"frame in which the two overlap", "球面與平面重疊的第一格"});
  program.result("/frames/first_overlap", first);
}
//! [report]

//! [notes]
// More numbers that the notes speak of: the printed formula without a test, and the error bound of `sweep`.
void note(Program& program, const Scene& scene, const Moving<Sphere>& ball,
          const std::optional<Contact>& contact) {
  const double distance = scene.plane.signed_distance(scene.from);
  const double toward = scene.plane.normal().dot(ball.displacement);
  program.value("closing", -toward);
  program.value("gap", distance - scene.radius);
  program.value("gap_end", scene.plane.signed_distance(scene.to) - scene.radius);
  program.value("printed_time", (scene.radius - distance) / toward);
  program.value("scaled_time", (scene.radius - scene.length * distance) / (scene.length * toward));
  for (const double length : {0.5, 2.0}) {  // of a normal that was not made a unit vector
    const std::string name = length < 1 ? "short" : "long";
    program.value(name + "_time", (scene.radius - length * distance) / (length * toward));
    program.value(name + "_height", scene.radius / length);
  }
  program.value("error_bound",
                error_of_time(lengths_of(ball.shape, scene.plane),
                              (contact ? contact->time : 1) * norm(ball.displacement), toward));
}
//! [notes]

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("plane", "01_plane",
                  {"A moving sphere meets a plane (paper, 1.2).", "球面與平面之間的碰撞（論文 1.2）。"});
  Scene scene;
  program.option("--plane", scene.plane, "A,B,C,D",
                 {"the plane Ax + By + Cz + D = 0", "平面 Ax + By + Cz + D = 0"});
  program.option("--from", scene.from, "x,y,z", {"centre of the sphere at t = 0", "球心在 t = 0 時的位置"});
  program.option("--to", scene.to, "x,y,z", {"centre of the sphere at t = 1", "球心在 t = 1 時的位置"});
  program.option("--radius", scene.radius, "r", {"radius of the sphere", "球的半徑"}, not_negative);
  program.option("--length", scene.length, "l",
                 {"of a normal in the formula as printed", "代入論文原式的法向量長度"}, positive);
  program.option(
      "--frames", scene.frames, "n",
      {"look at n frames of the motion as well; 0: at none", "另外觀察移動過程中的 n 個影格；0 表示不觀察"},
      at_most_a_thousand);
  return program.run(argc, argv, [&] {
    const auto ball = program.checked({"--to", "--from", "--radius"}, [&] {
      return Moving<Sphere>{{scene.from, scene.radius}, scene.to - scene.from};
    });
    const auto contact = sweep(ball, scene.plane);
    tell(program, scene, ball, contact);
    tell_corrections(program.report(), scene, ball);
    tell_frames(program, scene, ball);
    note(program, scene, ball, contact);
    if (program.draws()) draw_plane_figures(program, scene.plane, ball, contact);
  });
}
//! [main]
