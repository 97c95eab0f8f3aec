// Chapter 6: two moving spheres meet, and part again (paper, 2.3).
#include <cmath>
#include <limits>

#include "far_away.hpp"
#include "figures/figures.hpp"
#include "first_contact/program/counted.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "growth.hpp"
#include "nearly_touching.hpp"
#include "scene.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace {

//! [report]
// The distance of the centres, and when they are d = rP + rQ apart. Each number is given once: to the reader,
// and by the rest of its line to --json and to the notes.
void tell_roots(Program& program, const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const Vector w = p.shape.center - q.shape.center, u = p.displacement - q.displacement;
  Report& report = program.report();
  report.say({"As seen from Q: P moves with u, and they touch when their centres are d apart",
              "由 Q 看 P：以相對速度 u 移動，球心距離為 d 時相接觸"});
  report.row("w = P1 - Q1", w, {"from centre to centre at t = 0", "t = 0 時兩球心的差"});
  report.row("u = VP - VQ", u, {"difference of the velocities", "速度差"});
  program.row("d = rP + rQ", p.shape.radius + q.shape.radius, {"sum of the radii", "半徑和"}).value("d");
  const auto times = contact_interval(p, q);
  if (u.squaredNorm() > 0) {
    program.row("-w.u/u^2", -w.dot(u) / u.squaredNorm(), {"time of the closest approach", "最接近的時間"})
        .value("closest_time");
    program
        .row("|w x u|/|u|", accurate_cross(w, u).norm() / u.norm(),
             {"distance of the centres then; they meet if it is at most d",
              "最接近時的球心距離；不大於 d 才會碰撞"})
        .value("closest_distance");
  }
  if (!times)
    return report.say({"The spheres never touch, or never part: no real root.", "沒有實根：沒有發生碰撞"});
  program.row("t1", times->begin, {"the smaller root: contact begins", "較小的根：碰撞開始"}).value("t1");
  program.row("t2", times->end, {"the larger root: the spheres part", "較大的根：分離開始"}).value("t2");
}

void tell_contact(Program& program, const Meeting& meeting, const Interval& when) {
  Report& report = program.report();
  program.result("/contact", nullptr);
  program.result("/separation_time", meeting.separation);
  const std::string within = readable(when.first) + " <= t <= " + readable(when.last);
  if (!meeting.contact) {
    report.say({"No contact within " + within + ".", within + " 之間沒有發生碰撞"});
    if (meeting.separation)
      report.also({"They overlap at the beginning, but come no nearer: free to part.",
                   "起初已重疊，但不再靠近：任其分離"});
    return;
  }
  const Contact& contact = *meeting.contact;
  report.say({"The contact within " + within, within + " 之間發生碰撞"});
  program.row("t", contact.time, {"time of contact", "碰撞時間"}).result("/contact/time");
  program.row("P(t) = P1 + t VP", meeting.p, {"centre of P", "P 的球心"}).result("/contact/p");
  program.row("Q(t) = Q1 + t VQ", meeting.q, {"centre of Q", "Q 的球心"}).result("/contact/q");
  report.row("N = (Q - P)/|Q - P|", Vector(-contact.normal),
             {"the paper's normal, from P to Q; our contact's is its opposite", "法向量，由 P 至 Q"});
  program.row("C = P(t) + rP N", contact.point(), {"point of contact", "碰撞點"}).result("/contact/point");
  program.result("/contact/normal", contact.normal);
}

// The printed root and the stable one, from far away, in the arithmetic of most games.
void tell_errors(Report& report) {
  const auto digits = [](double value, const char* unit) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1e%s", value, unit);
    return std::string(text);
  };
  const auto printed = measure<float>(Formula::textbook), stable = measure<float>(Formula::closest_approach);
  const auto tell = [&](const std::vector<program::Accuracy>& results) {
    for (const std::size_t i : {4U, 6U, 8U}) {
      const std::string from = readable(results[i].distance), lost = readable(100 * results[i].lost) + "%";
      report.row("from " + from + " d", digits(results[i].error, " d"),
                 {"how far off the contact is (median); hits lost: " + lost,
                  "碰撞位置的誤差（中位數）；漏失的碰撞：" + lost});
    }
  };
  report.say(
      {"As printed, in single precision: (w.u)^2 - u^2 (w^2 - d^2) cancels if the spheres come from far away",
       "論文原式（單精度）：距離遠時 (w.u)^2 - u^2 (w^2 - d^2) 幾乎相消"});
  tell(printed);
  report.say({"Corrected: the same root as u^2 d^2 - |w x u|^2, by the closest approach",
              "修正：改以最接近距離計算，根號內為 u^2 d^2 - |w x u|^2"});
  tell(stable);
}

// Of many spheres, every two may meet.
void tell_crowd(Program& program) {
  const Work alike = work(10000, Crowd::alike), uneven = work(10000, Crowd::uneven);
  Report& report = program.report();
  report.say({"Among 10000 spheres, every two may meet: boxes in space and time, halved again and again",
              "10000 個球，每兩個都可能相碰：時空中的匣面，反覆對分"});
  program.row("n(n - 1)/2", alike.every_pair, {"pairs", "成對的球"}).value("crowd_pairs");
  program.row("along x", alike.one_axis, {"pairs that overlap along x", "沿 x 方向重疊的成對的球"})
      .value("crowd_one_axis");
  program.row("boxes", alike.boxes, {"tests of boxes", "匣面的測試數"}).value("crowd_boxes");
  report.row("sweeps", alike.sweeps, {"pairs that are swept", "精確計算的成對的球"});
  program.row("contacts", alike.contacts, {"pairs that meet", "發生碰撞的成對的球"}).value("crowd_contacts");
  report.row("boxes, uneven", uneven.boxes,
             {"one sphere as large as all of space, one in a hundred ten times as fast",
              "其一與全空間等大，百分之一快十倍"});
  const auto count = [](std::size_t n) { return static_cast<double>(n); };
  program.value("crowd", count(alike.spheres));
  program.value("crowd_boxes_each", count(alike.boxes) / count(alike.spheres));
  program.value("crowd_boxes_uneven_each", count(uneven.boxes) / count(uneven.spheres));
  program.value("crowd_sweeps_each", count(alike.sweeps) / count(alike.spheres));
}
//! [report]

//! [notes]
// Results that a scene of an extreme size need not have.
void result_if_finite(Program& program, const std::string& place, double number) {
  if (std::isfinite(number)) program.result(place, number);
}

// More numbers that the notes speak of: those of the quadratic equation, and what is lost far away.
void note_roots(Program& program, const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const Vector w = p.shape.center - q.shape.center, u = p.displacement - q.displacement;
  const double d = p.shape.radius + q.shape.radius;
  program.value("w2", w.squaredNorm());
  program.value("u2", u.squaredNorm());
  program.value("wu", w.dot(u));
  program.value("d2", d * d);
  program.value("discriminant", discriminant(u, accurate_cross(w, u), d));
  result_if_finite(program, "/discriminant", discriminant(u, accurate_cross(w, u), d));
  result_if_finite(program, "/closest_time", -w.dot(u) / u.squaredNorm());
  result_if_finite(program, "/closest_distance", accurate_cross(w, u).norm() / u.norm());
  if (const auto times = contact_interval(p, q)) {
    result_if_finite(program, "/t1", times->begin);
    result_if_finite(program, "/t2", times->end);
  }
  program.value("distance_begin", w.norm());
  program.value("distance_end", (w + u).norm());
}

template <class Scalar>
void note_far_away(Program& program, const std::string& precision) {
  const auto printed = measure<Scalar>(Formula::textbook),
             stable = measure<Scalar>(Formula::closest_approach);
  for (std::size_t decade = 1; 2 * decade < printed.size(); ++decade) {
    const std::string name = precision + "_1e" + std::to_string(decade) + "_";
    program.value(name + "printed", printed[2 * decade].error);
    program.value(name + "stable", stable[2 * decade].error);
    program.value(name + "printed_lost", printed[2 * decade].lost);
    program.value(name + "stable_lost", stable[2 * decade].lost);
  }
  program.value(precision + "_limit", 1 / std::sqrt(std::numeric_limits<Scalar>::epsilon()));
}

// ... when the two nearly touch already, and what the two times cost, counted.
void note_near_and_cost(Program& program) {
  const auto [by_difference, by_product] = nearly_touching(1e-4);
  program.value("near_by_difference", by_difference);
  program.value("near_by_product", by_product);
  using program::Counted;
  const Vector3<Counted> w(-3, 1, 0), u(2, 0, 1);
  const program::Operations done = Counted::in([&] { return contact_times<Counted>(w, u, 2); });
  program.value("cost.multiplications", done.multiplications);
  program.value("cost.additions", done.additions);
  program.value("cost.divisions", done.divisions);
  program.value("cost.roots", done.roots);
}
//! [notes]

//! [studies]
void tell_studies(Program& program) {
  tell_errors(program.report());
  tell_crowd(program);
  note_far_away<float>(program, "single");
  note_far_away<double>(program, "double");
  note_near_and_cost(program);
}
//! [studies]

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program(
      "moving_spheres", "06_moving_spheres",
      {"Two moving spheres meet, and part again (paper, 2.3).", "兩個移動球面的碰撞與分離（論文 2.3）。"});
  Scene scene;
  program.option("--p1", scene.p1, "x,y,z",
                 {"centre of the sphere P at t = 0", "球 P 的球心在 t = 0 時的位置"});
  program.option("--p2", scene.p2, "x,y,z", {"centre of P at t = 1", "P 的球心在 t = 1 時的位置"});
  program.option("--rp", scene.rp, "r", {"radius of P", "P 的半徑"}, not_negative);
  program.option("--q1", scene.q1, "x,y,z",
                 {"centre of the sphere Q at t = 0", "球 Q 的球心在 t = 0 時的位置"});
  program.option("--q2", scene.q2, "x,y,z", {"centre of Q at t = 1", "Q 的球心在 t = 1 時的位置"});
  program.option("--rq", scene.rq, "r", {"radius of Q", "Q 的半徑"}, not_negative);
  program.option("--interval", scene.interval, "a,b",
                 {"the times between which a contact counts", "只計入此時間範圍內的接觸"});
  return program.run(argc, argv, [&] {
    const auto p = program.checked({"--p2", "--p1", "--rp"}, [&] { return scene.p(); });
    const auto q = program.checked({"--q2", "--q1", "--rq"}, [&] { return scene.q(); });
    const auto when = program.checked("--interval", [&] { return scene.when(); });
    const Meeting meeting(p, q, when);
    program.report().title({"Two moving spheres", "兩個移動球面的碰撞"}, "2.3");
    tell_roots(program, p, q);
    tell_contact(program, meeting, when);
    note_roots(program, p, q);
    if (!program.results_alone()) tell_studies(program);
    if (program.draws()) draw_moving_spheres_figures(program, p, q);
  });
}
//! [main]
