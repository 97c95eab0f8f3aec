// Chapter 7: tweens, and the fall and rebound of the paper's programs 1 to 3 (paper, 1.1 and 2.4.2).
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bent.hpp"
#include "figures/figures.hpp"
#include "film/run.hpp"
#include "first_contact/program/numbers.hpp"
#include "first_contact/program/program.hpp"
#include "flight.hpp"
#include "mistakes.hpp"
#include "plain_told.hpp"
#include "with_digits.hpp"

using namespace first_contact;
using namespace first_contact::program;
using tween_bounce::Flight;
using tween_bounce::with_digits;

namespace {

//! [scene]
struct Scene {
  double v0 = 50;  // downwards
  double y0 = 25;
  double g = 9.82;
  double dt = 0.01;
  long samples = 2000;
  double restitution = 0.5;
  std::string model = "printed";
  std::string csv;
  std::string curve = "0,0,0.5,4,2,4,8,0";
  double part = 0.4;  // of it

  std::size_t count() const { return static_cast<std::size_t>(samples); }
};
//! [scene]

PrintedMotion run_printed(const Scene& scene, double v0) {
  return run(PrintedBounce{v0, scene.y0, scene.g, scene.dt, scene.count(), scene.restitution});
}

//! [report]
// Program 1: the samples of the tween.
void tell_plan(Program& program, const PrintedMotion& motion) {
  Report& report = program.report();
  const auto tops = apexes(motion);
  const auto hit = [&](std::size_t i) { return std::to_string(motion.hits[i].sample); };
  report.say({"Program 1: the path is planned, dy = v0 dt - g t dT sample by sample",
              "程式 1：規劃移動補間的路徑，逐點計算 dy = vo dt - g t dT"});
  report.row("y(1)", motion.y.front(), {"height at the start", "起始高度"});
  if (motion.y.size() > 1)
    program.row("y(2)", Shown{motion.y[1], with_digits(motion.y[1], 8)}, {"one step later", "下一點的高度"})
        .value("second_height");
  if (!motion.hits.empty())
    report.row("first i, y(i) < 0", hit(0), {"sample number, from 1", "第一次低於地面的取樣編號"});
  if (!tops.empty())
    report.row("max y after it", with_digits(tops.front().height, 9),
               {"top of the rebound, at t = " + readable(tops.front().time),
                "反彈的最高點，t = " + readable(tops.front().time)});
  if (motion.hits.size() > 1)
    report.row("second i, y(i) < 0", hit(1), {"sample number", "第二次低於地面的取樣編號"});
  program
      .row("hits", motion.hits.size(),
           {"in " + std::to_string(motion.y.size()) + " samples: at last every step is one",
            std::to_string(motion.y.size()) + " 點中的碰撞次數：最後每一步都算一次"})
      .value("hits");
}

// Program 2: does the ball follow the plan?
void tell_check(Program& program, const Flight& flight) {
  Report& report = program.report();
  report.say({"Program 2: the path is tested against the plan, a line, a curve and a line",
              "程式 2：測試行進路線是否如規劃的直線與曲線"});
  for (std::size_t i = 0; i < std::min<std::size_t>(2, flight.impacts.size()); ++i) {
    const std::string n = std::to_string(i + 1);
    report.also({"  Hit " + n + " on the ground; after the 3rd it only moves along the ground",
                 "  第" + n + "次碰撞地面; 第3次碰撞地面後,就只在地面移動了"});
  }
  const auto tween = tween_bounce::plan(flight);
  if (!tween)
    return report.also(
        {"  There is no plan of a fall, a rebound and a floor.", "  沒有下降、反彈與地面的規劃"});
  const auto off = tween_bounce::off_plan(flight, *tween);
  program
      .row("off the line", off[0],
           {"at most: the fall is not quite straight", "與直線的最大偏差：下降並非完全直線"})
      .value("off_line");
  program
      .row("off the curve", off[1],
           {"at most: a parabola, drawn as a Bezier curve", "與貝茲曲線（拋物線）的最大偏差"})
      .value("off_curve");
  report.row("off the floor", off[2], {"at most", "與地面的最大偏差"});
  for (std::size_t leg = 0; leg < 2; ++leg)
    if (const auto time = tween_bounce::meets_obstacle(*tween, leg))
      report.row(leg == 0 ? "t, sweep along line" : "t, sweep along curve", *time,
                 {"a ball of radius 1 meets the obstacle's top, y = -1", "半徑 1 的球碰到障礙物上緣 y = -1"});
}

// Program 3: fast down, slow up.
void tell_speeds(Report& report, const Flight& flight) {
  if (flight.impacts.size() < 2) return;
  const double first = flight.impacts[0].time, second = flight.impacts[1].time;
  report.say(
      {"Program 3: the fall is fast, the rebound slow", "程式 3：下降速度較快，碰撞地面反彈後速度變慢"});
  report.row("fall", first, {"time to the first hit", "第 1 次碰撞前的時間"});
  report.row("rebound", second - first,
             {"time from the first hit to the second", "第 1、2 次碰撞之間的時間"});
}

// What is wrong in the programs.
void tell_printed(Report& report, const Scene& scene, const Flight& flight) {
  report.say({"As printed: gravity brakes the fall, and its time counts from the start, not from the bounce",
              "論文原式：重力使下降減速，且時間自起點而非自碰撞起算"});
  if (!flight.impacts.empty()) {
    report.row("t1", flight.impacts[0].time, {"first hit, to within dt", "第 1 次碰撞（誤差至 dt）"});
    report.row("v1", flight.impacts[0].speed,
               {"speed there; it was thrown down with " + readable(scene.v0),
                "當時速度；向下拋出時為 " + readable(scene.v0)});
  }
  const PrintedMotion released = run_printed(scene, 0);
  const std::size_t second =
      std::min(released.y.size() - 1, static_cast<std::size_t>(std::min(1 / scene.dt, 1e9)));
  report.row("y, let go with v0 = 0", released.y[second],
             {"at t = " + readable(released.t[second]) + ": it rises",
              "t = " + readable(released.t[second]) + " 時：球上升"});
  report.row("rebounds", std::to_string(flight.apexes.size()),
             {"then " + std::to_string(flight.impacts.size()) + " hits",
              "共碰撞 " + std::to_string(flight.impacts.size()) + " 次"});
}

void tell_corrected(Program& program, const Scene& scene, const Bounce& bounce) {
  Report& report = program.report();
  report.say(
      {"Corrected: each impact is solved for, y0 - v0 t - g t^2/2 = 0; it leaves e of the speed, e = " +
           readable(scene.restitution),
       "修正：解 y0 - v0 t - g t^2/2 = 0 得碰撞時間；碰撞後速度為 e 倍，e = " + readable(scene.restitution)});
  for (std::size_t n = 1; n <= 3; ++n) {
    const std::string i = std::to_string(n);
    const auto landing = bounce.impact(n);
    if (!landing) break;
    report.row("t" + i + ", v" + i, readable(landing->time) + ", " + readable(landing->speed),
               {"impact " + i + " and its speed", "第 " + i + " 次碰撞及其速度"});
    if (const auto apex = bounce.apex(n))
      report.row(
          "h" + i, apex->height,
          {"top of the rebound, at t = " + readable(apex->time), "反彈最高點，t = " + readable(apex->time)});
  }
  if (const auto rest = bounce.rest_time())
    program
        .row("t1 + (2 v1/g) e/(1 - e)", *rest,
             {"rest: infinitely many impacts before it (Zeno)", "靜止：此前碰撞無窮多次（芝諾悖論）"})
        .value("true_rest");
  else
    report.row("rest", std::string("never"), {"it never comes to rest on the floor", "永不靜止於地面"});
}
//! [report]

//! [notes]
// A curve of four control points, looked at by its parameter and by its length.
void note_curve(Program& program, const Scene& scene) {
  const auto numbers = program.checked("--curve", [&] { return numbers_of(scene.curve, 8); });
  std::vector<Point> control;
  for (std::size_t i = 0; i < numbers.size(); i += 2) control.emplace_back(numbers[i], numbers[i + 1], 0);
  const auto bent =
      program.checked("--curve", [&] { return tween_bounce::bent(Bezier(control), scene.part); });
  program.result("/curve/length", bent.length);
  program.result("/curve/speed", bent.speed);
  program.result("/curve/point", bent.point);
  program.result("/curve/even_parameter", bent.even_parameter);
  program.result("/curve/even_point", bent.even_point);
}

// More numbers that the notes speak of: of the printed fall, the film, and the solved one.
void note(Program& program, const Scene& scene, const PrintedMotion& motion, const Bounce& bounce) {
  program.value("v0", scene.v0);
  program.value("y0", scene.y0);
  program.value("dt", scene.dt);
  program.value("samples", static_cast<double>(motion.y.size()));
  const PrintedMotion released = run_printed(scene, 0);
  program.value("released", released.y[std::min(released.y.size() - 1, std::size_t{100})]);
  program.value("rebound_gravity", 6.0 / 5 * scene.g);
  program.value("rebound_speed", scene.restitution * scene.v0);
  program.value("apex_by_formula", scene.restitution * scene.v0 / (6.0 / 5 * scene.g));
  if (!motion.hits.empty()) {
    const double up = scene.restitution * scene.v0 - 6.0 / 5 * scene.g * motion.hits.front().time;
    program.value("apex_height_by_formula", up * up / (2 * 6.0 / 5 * scene.g));
  }
  tween_bounce::note_plain(program);
  for (std::size_t n = 1; n <= 3; ++n) {
    const auto landing = bounce.impact(n);
    const auto apex = bounce.apex(n);
    if (!landing || !apex) break;
    program.value("true_t" + std::to_string(n), landing->time);
    program.value("true_v" + std::to_string(n), landing->speed);
    program.value("true_h" + std::to_string(n), apex->height);
  }
}
//! [notes]

void give_results(Program& program, const Flight& flight) {
  program.result_list("/impacts");
  for (std::size_t i = 0; i < flight.impacts.size(); ++i) {
    const std::string impact = "/impacts/" + std::to_string(i);
    program.result(impact + "/time", flight.impacts[i].time);
    program.result(impact + "/speed", flight.impacts[i].speed);
  }
  program.result_list("/apexes");
  for (std::size_t i = 0; i < flight.apexes.size(); ++i) {
    const std::string apex = "/apexes/" + std::to_string(i);
    program.result(apex + "/time", flight.apexes[i].time);
    program.result(apex + "/height", flight.apexes[i].height);
  }
  program.result("/rest_time", flight.rest_time);
}

std::string sample_count(double value) {
  return value >= 1 && value <= 1e6 ? "" : "must be from 1 to 1000000";
}

//! [options]
void take_options(Program& program, Scene& scene) {
  program.option("--v0", scene.v0, "v", {"speed at the start, positive downwards", "初速，向下為正"});
  program.option("--y0", scene.y0, "y", {"height at the start; the floor is at 0", "起始高度；地板在 0"},
                 not_negative);
  program.option("--g", scene.g, "g",
                 {"gravity; without it the ball flies straight", "重力加速度；為 0 時球直線飛行"},
                 not_negative);
  program.option("--dt", scene.dt, "dt", {"time from one sample to the next", "相鄰取樣的時間間隔"},
                 positive);
  program.option("--samples", scene.samples, "n", {"number of samples", "取樣數"}, sample_count);
  program.option("--restitution", scene.restitution, "e",
                 {"part of the speed that an impact leaves", "碰撞後保留的速率比例"}, at_most_one);
  program.option("--model", scene.model, std::vector<std::string>{"printed", "physical"},
                 {"of the results, the file and figures 13 to 15", "用於結果、檔案與圖 13 至 15"});
  program.option("--csv", scene.csv, "OUT.csv",
                 {"write the samples there, columns t,y; or a film's pictures",
                  "將取樣寫入該檔，欄位為 t,y；或寫入影片的各格畫面"});
  program.option(
      "--curve", scene.curve, "x0,y0,...,x3,y3",
      {"a Bezier curve's control points, looked at in --json", "貝茲曲線的控制點，結果列於 --json"});
  program.option("--part", scene.part, "s", {"of that curve, from 0 to 1", "該曲線的哪一部分，從 0 到 1"},
                 at_most_one);
}
//! [options]

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("tween_bounce", "07_tween_bounce",
                  {"Tweens, and a ball that falls and rebounds (paper, 2.4.2).",
                   "補間動畫，以及落下反彈的球（論文 2.4.2）。"});
  Scene scene;
  take_options(program, scene);
  const tween_bounce::FilmOptions film(program);
  return program.run(argc, argv, [&] {
    if (tween_bounce::run_film(program, film, scene.csv)) return;
    const std::vector<std::string> thrown{"--v0", "--y0", "--g", "--dt", "--samples", "--restitution"};
    const auto motion = program.checked(thrown, [&] { return run_printed(scene, scene.v0); });
    const auto bounce =
        program.checked(thrown, [&] { return Bounce(scene.y0, scene.v0, scene.g, scene.restitution); });
    const Flight printed = tween_bounce::printed_flight(motion);
    const Flight physical = tween_bounce::physical_flight(bounce, scene.dt, scene.count());
    const Flight& flight = scene.model == "printed" ? printed : physical;

    Report& report = program.report();
    report.title({"A tween bounces: fast down, slow up", "移動補間動畫：下降快、反彈慢"}, "1.1, 2.4.2");
    tell_plan(program, motion);
    tell_check(program, printed);
    tell_speeds(report, printed);
    tell_printed(report, scene, printed);
    tell_corrected(program, scene, bounce);
    tween_bounce::tell_energy(program);
    tween_bounce::tell_tweens(program);
    give_results(program, flight);
    note(program, scene, motion, bounce);
    note_curve(program, scene);
    if (!scene.csv.empty()) program.checked("--csv", [&] { write_file(scene.csv, csv(flight)); });
    if (program.draws()) draw_tween_bounce_figures(program, flight, printed, physical);
  });
}
//! [main]
