// Chapter 8: where two bodies go after an impact (paper, 2.4.2 (iii), 3.1.2, program 4).
#include <cmath>
#include <cstdio>

#include "encounter.hpp"
#include "figures/figures.hpp"
#include "first_contact/program/program.hpp"

using namespace first_contact;
using namespace first_contact::program;
using Eigen::Vector2d;

namespace {

std::string formatted(const char* form, double value) {
  char text[40];
  std::snprintf(text, sizeof text, form, value == 0 ? 0.0 : value);
  return text;
}

std::string degrees(double angle) { return formatted("%.7g", angle); }

std::string pair_of(const Vector2d& v) { return "(" + readable(v.x()) + ", " + readable(v.y()) + ")"; }

// A number as the paper's interpreter prints it where a whole one was expected: 135, or 7.156505e+001.
std::string as_paper_prints(double value) {
  if (value == std::round(value)) return readable(value);
  const std::string text = formatted("%.6e", value);
  const std::size_t exponent = text.size() - 2;
  return text.substr(0, exponent) + (text[exponent - 2] == 'e' ? "0" : "") + text.substr(exponent);
}

// A pair as the paper's interpreter shows it: with four decimals if one of them is not whole.
std::string as_paper_shows(const Vector2d& v) {
  const bool whole = v == v.array().round().matrix();
  return formatted(whole ? "%g" : "%.4f", v.x()) + " " + formatted(whole ? "%g" : "%.4f", v.y());
}

//! [paper]
// What the paper prints for one of its cases; empty where it prints no number of its own.
struct Printed {
  Text heading;
  Text situation;
  std::vector<std::string> shown;  // "V1 = 1 1"
  std::array<std::string, 2> angles;
};

std::vector<Printed> paper_output() {
  const auto cases = paper_cases();
  const auto shown = [](const char* name, const Vector2d& v) {
    return std::string(name) + " = " + as_paper_shows(v);
  };
  const Text fixed{"===== The bodies have fixed places and the same radius =====",
                   "===== 以下兩物件的出發位置分別固定且半徑相同 ====="};
  const Text other{"===== Other places, masses (5:1) and velocities; only the radius is the same =====",
                   "===== 以下兩物件的出發位置已改變, 質量比不同(5:1), 速度向量也不同; 只有半徑相同 ====="};
  const Text still{"===== The same places =====", "===== 出發位置相同 ====="};
  return {{fixed,
           {"Case 1: masses 5:1, the bodies move with (1 1) and (-1 1), at 45 degrees up to the right and to "
            "the left",
            "狀況1: 質量5:1, 兩物件分別以速度向量(1 1)與(-1 1)各自朝右上45度/左上45度移動"},
           {"r = 1", shown("MassCouple1", cases[0].mass), shown("P1", cases[0].p1), shown("P2", cases[0].p2),
            shown("V1", cases[0].v1), shown("V2", cases[0].v2)},
           {"7.156505e+001", "2.319859e+001"}},
          {still,
           {"Case 2: masses 1:1, the velocities of case 1", "狀況2: 質量比已改變成1:1, 速度向量與狀況1相同"},
           {shown("MassCouple2", cases[1].mass)},
           {"135", "45"}},
          {still,
           {"Case 3: the masses of case 2 (1:1), both bodies move up with (0 1)",
            "狀況3: 質量比與狀況2相同(即1:1), 但兩物件分別以速度向量(0 1)與(0 1)(皆)向上移動"},
           {shown("V3", cases[2].v1), shown("V4", cases[2].v2)},
           {"90", "90"}},
          {other,
           {"Case 4: masses 5:1 from other places, the bodies move with (3 -1) and (-1 2)",
            "狀況4: 兩物件分別以速度向量(3 -1)與(-1 2)的大小與方向移動"},
           {shown("P5", cases[3].p1), shown("P6", cases[3].p2), shown("V5", cases[3].v1),
            shown("V6", cases[3].v2)},
           {"1.205147e+000", "-1.026519e+002"}}};
}
//! [paper]

//! [report]
void tell_collision(Report& report, const Outcome& outcome, int number) {
  const std::string first = std::to_string(2 * number - 1), second = std::to_string(2 * number);
  report.also(outcome.collides ? Text{"----- collision -----", "----- 發生碰撞 -----"}
                               : Text{"----- no collision -----", "----- 沒有發生碰撞 -----"});
  report.also({"Bodies " + first + " and " + second + " go off at " + degrees(outcome.angle[0]) + " and " +
                   degrees(outcome.angle[1]) + " degrees",
               "物件" + first + "及" + second + "的行進角度分別為" + as_paper_prints(outcome.angle[0]) +
                   "度與" + as_paper_prints(outcome.angle[1]) + "度"});
}

// Do the discs meet at all, and when?
void tell_meeting(Report& report, const Encounter& encounter, const Outcome& outcome) {
  const auto [p, q] = in_space(encounter);
  const bool overlapping = overlap(p.shape, q.shape);
  const Closest closest = closest_approach(encounter);
  const std::string nearest = readable(closest.distance), when = readable(closest.time);
  const std::string radii = readable(encounter.radius) + " + " + readable(encounter.radius);
  if (overlapping)
    report.row("|P1 P2|", readable((encounter.p2 - encounter.p1).norm()),
               {"they overlap from the start: their radii are " + radii, "起初即重疊：半徑為 " + radii});
  if (outcome.time)
    report.row("t", *outcome.time,
               overlapping ? Text{"at once, for they go deeper", "立即碰撞，因為更加靠近"}
                           : Text{"the discs meet", "兩圓相碰的時間"});
  else if (overlapping)
    report.row("t", std::string("none"), {"they come no nearer: no impact", "不再靠近：沒有碰撞"});
  else
    report.row("t", std::string("none"),
               {"they never meet: at the nearest, t = " + when + ", the centres are " + nearest + " apart",
                "兩圓不相碰：最接近時 t = " + when + "，球心距離 " + nearest});
}

void tell_outcome(Report& report, const Encounter& encounter, const Outcome& outcome) {
  report.row("collides", std::string(outcome.collides ? "true" : "false"), {"in this model", "依此模型"});
  report.row("v1", pair_of(outcome.velocity[0]), {"velocity of body 1 afterwards", "物件1碰撞後的速度"});
  report.row("v2", pair_of(outcome.velocity[1]), {"velocity of body 2 afterwards", "物件2碰撞後的速度"});
  report.row("theta1", degrees(outcome.angle[0]), {"its direction in degrees", "行進角度"});
  report.row("theta2", degrees(outcome.angle[1]), {"its direction in degrees", "行進角度"});
  report.row("energy before", energy(encounter, {encounter.v1, encounter.v2}),
             {"1/2 (m1 v1^2 + m2 v2^2)", "動能"});
  report.row("energy after", energy(encounter, outcome.velocity), {"the same, afterwards", "碰撞後的動能"});
}

// One of the paper's cases: what it prints, our run of it as printed, and the corrected one.
void tell_case(Report& report, const Encounter& encounter, const Printed& paper, int number) {
  const Outcome printed = as_printed(encounter), corrected = at_contact(encounter);
  report.say(paper.heading);
  for (const std::string& line : paper.shown) report.also({line, line});
  report.also(paper.situation);
  tell_collision(report, printed, number);
  for (const std::size_t i : {0U, 1U})
    report.row("theta" + std::to_string(i + 1), degrees(printed.angle[i]), {"as printed", "論文原式"},
               paper.angles[i]);
  tell_meeting(report, encounter, corrected);
  for (const std::size_t i : {0U, 1U})
    report.row("theta" + std::to_string(i + 1), degrees(corrected.angle[i]),
               corrected.collides ? Text{"corrected: the normal at contact", "修正：以碰撞時的法向量計算"}
                                  : Text{"corrected: straight on", "修正：方向不變"});
}
//! [report]

//! [faults]
// Where program 4 goes wrong even if the bodies do meet.
void tell_faults(Report& report) {
  const Encounter aimed = aimed_beside();
  report.say({"As printed, the normal is that at the start; here (-5, 1) with (5, 0) meets (0, 0) at rest",
              "論文原式：以出發位置的法向量計算；此處 (-5, 1) 以 (5, 0) 碰撞靜止的 (0, 0)"});
  report.row("theta2", degrees(as_printed(aimed).angle[1]), {"as printed", "論文原式"});
  report.row(
      "theta2", degrees(at_contact(aimed).angle[1]),
      {"corrected: the struck disc goes along the normal at contact", "修正：被撞物件沿碰撞時的法向量移動"});

  Encounter soft;
  soft.v2 = {-1, -1};
  soft.mass = {1, 1};
  soft.restitution = 0.5;
  report.say(
      {"As printed, r is called the radius, but acts as the restitution, and across the normal as well; here "
       "0.5",
       "論文原式：r 名為半徑，實為恢復係數，且連切線速度一併縮小；此處為 0.5"});
  report.row("v1", pair_of(as_printed(soft).velocity[0]),
             {"as printed: (1, 1) loses speed both ways", "論文原式：兩分量皆縮小"});
  report.row("v1", pair_of(at_contact(soft).velocity[0]),
             {"corrected: only along the normal, here x", "修正：只改變法向量（x）的分量"});
}
//! [faults]

void give_results(Program& program, const Outcome& outcome, const std::string& place = "") {
  program.result(place + "/collides", outcome.collides);
  program.result(place + "/time", outcome.time);
  program.result(place + "/angles_deg", std::vector{outcome.angle[0], outcome.angle[1]});
  for (const std::size_t i : {0U, 1U})
    program.result(place + "/velocities/" + std::to_string(i),
                   std::vector{outcome.velocity[i].x(), outcome.velocity[i].y()});
}

// Both models of one scene, and what each makes of energy and momentum. Of a wall program 4 knows nothing.
void give_both(Program& program, const Encounter& encounter) {
  if (!encounter.mass.allFinite()) return;
  const auto give = [&](const std::string& place, const std::array<Vector2d, 2>& velocity) {
    program.result(place + "/energy", energy(encounter, velocity));
    const Vector2d sum = momentum(encounter, velocity);
    program.result(place + "/momentum", std::vector{sum.x(), sum.y()});
  };
  give("/before", {encounter.v1, encounter.v2});
  for (const bool printed : {true, false}) {
    const Outcome outcome = printed ? as_printed(encounter) : at_contact(encounter);
    const std::string place = printed ? "/printed" : "/contact";
    give_results(program, outcome, place);
    give(place, outcome.velocity);
  }
}

//! [notes]
// Numbers that the notes speak of: of two discs, by both models.
void note(Program& program, const std::string& name, const Encounter& encounter) {
  if (!encounter.mass.allFinite()) return;  // of a wall program 4 knows nothing
  const Outcome printed = as_printed(encounter), corrected = at_contact(encounter);
  const Closest closest = closest_approach(encounter);
  program.value(name + "_closest_time", closest.time);
  program.value(name + "_closest_distance", closest.distance);
  program.value(name + "_start_distance", (encounter.p2 - encounter.p1).norm());
  program.value(name + "_energy_before", energy(encounter, {encounter.v1, encounter.v2}));
  program.value(name + "_printed_energy", energy(encounter, printed.velocity));
  program.value(name + "_energy", energy(encounter, corrected.velocity));
  if (corrected.time) program.value(name + "_time", *corrected.time);
  for (const std::size_t i : {0U, 1U}) {
    const std::string number = std::to_string(i + 1);
    program.value(name + "_printed_angle" + number, printed.angle[i]);
    program.value(name + "_angle" + number, corrected.angle[i]);
    program.value(name + "_printed_v" + number + "y", printed.velocity[i].y());
    program.value(name + "_v" + number + "y", corrected.velocity[i].y());
  }
}
//! [notes]

void show_paper_cases(Program& program) {
  const auto cases = paper_cases();
  const auto paper = paper_output();
  give_results(program, as_printed(cases[0]));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    tell_case(program.report(), cases[i], paper[i], static_cast<int>(i) + 1);
    const std::string place = "/cases/" + std::to_string(i);
    give_results(program, as_printed(cases[i]), place + "/printed");
    give_results(program, at_contact(cases[i]), place + "/contact");
  }
  tell_faults(program.report());
  for (std::size_t i = 0; i < cases.size(); ++i) note(program, "case" + std::to_string(i + 1), cases[i]);
  note(program, "aimed", aimed_beside());
  note(program, "soft", soft_and_aslant());
  if (program.draws()) draw_paper_cases(program);
}

void show_one(Program& program, const Encounter& encounter, bool printed) {
  if (printed && !encounter.mass.allFinite())
    program.checked("--mass", []() -> void {
      throw Refused("must be finite for program 4 (--model contact allows a wall)");
    });
  const Outcome outcome = printed ? as_printed(encounter) : at_contact(encounter);
  program.report().say(printed ? Text{"As printed: program 4", "論文原式：程式4"}
                               : Text{"Corrected: do they meet, and with which normal?",
                                      "修正：是否相碰，以及碰撞時的法向量"});
  tell_outcome(program.report(), encounter, outcome);
  program.report().say({"The discs of this scene", "此場景的兩圓"});
  tell_meeting(program.report(), encounter, at_contact(encounter));
  give_results(program, outcome);
  give_both(program, encounter);
  note(program, "this", encounter);
  if (program.draws()) draw_encounter(program, "encounter", encounter, printed, !printed);
}

}  // namespace

//! [main]
int main(int argc, char** argv) {
  Program program("angle_demo", "08_angle_demo",
                  {"Where two bodies go after an impact (paper, 2.4.2 (iii), program 4).",
                   "兩物體碰撞後的去向（論文 2.4.2 (iii)、程式4）。"});
  Encounter scene;
  std::string model = "printed";
  program.option("--mass", scene.mass, "m1,m2",
                 {"masses of the two bodies; inf for a wall", "兩物體的質量；inf 表示牆"}, positive,
                 Range::infinite_too);
  program.option("--p1", scene.p1, "x,y", {"where body 1 starts", "物體 1 的起點"});
  program.option("--p2", scene.p2, "x,y", {"where body 2 starts", "物體 2 的起點"});
  program.option("--v1", scene.v1, "x,y", {"velocity of body 1", "物體 1 的速度"});
  program.option("--v2", scene.v2, "x,y", {"velocity of body 2", "物體 2 的速度"});
  program.option("--restitution", scene.restitution, "e",
                 {"coefficient of restitution; program 4's r", "恢復係數；即程式4 的 r"}, at_most_one);
  program.option("--radius", scene.radius, "r", {"radius of both discs", "兩圓盤的半徑"}, not_negative);
  program.option(
      "--model", model, std::vector<std::string>{"printed", "contact"},
      {"program 4 as printed, or with the normal at contact", "論文的程式4，或改用接觸時的法向量"});
  return program.run(argc, argv, [&] {
    program.report().title({"Angles after an impact", "碰撞後的行進角度"}, "2.4.2 (iii), 3.1.2");
    bool given = false;
    for (const char* option :
         {"--mass", "--p1", "--p2", "--v1", "--v2", "--restitution", "--radius", "--model"})
      given = given || program.given(option);
    if (given)
      show_one(program, scene, model == "printed");
    else
      show_paper_cases(program);  // without options of its own: the paper's four cases, both ways
  });
}
//! [main]
