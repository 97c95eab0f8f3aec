#include "walk_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "first_contact/program/progress_line.hpp"
#include "first_contact/response/slide.hpp"

using namespace first_contact;
using namespace first_contact::program;

namespace {

// One digit, rounded up: so it is true, and the same where the last bits differ.
std::string at_most(double value) {
  if (value == 0) return "0";
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))));
  char text[32];
  std::snprintf(text, sizeof text, "%.0e", std::ceil(value / unit) * unit);
  return text;
}

// A row of the table, or its head: the cells after the first end where the head's do.
std::string table_row(const std::string& name, const std::vector<std::string>& cells,
                      const std::vector<std::string>& head) {
  std::string row = "  " + padded(name, 17);
  for (std::size_t i = 0; i < cells.size(); ++i)
    row += std::string(columns(head[i]) + 2 - columns(cells[i]), ' ') + cells[i];
  return row;
}

}  // namespace

//! [walks]
std::vector<walks::Walk> tell_walks(Program& program, const std::vector<walks::Ground>& grounds,
                                    long frames) {
  Report& report = program.report();
  report.say({"Frame after frame over whole surfaces: the worst that happened in any frame",
              "在整個表面上逐影格滑行：所有影格中最差者"});
  std::vector<std::string> head;
  for (const Text& text :
       {Text{"triangles", "三角形數"}, Text{"   frames", "  影格數"}, Text{"penetration", "最大穿透深度"},
        Text{"tunnelled", "穿牆次數"}, Text{"reversed", "後退次數"}, Text{"drift", "漂移"}})
    head.push_back(program.say(text));
  report.also(Text{table_row("", head, head), table_row("", head, head)});
  std::vector<walks::Walk> all;
  const ProgressLine progress("walks");
  for (const walks::Ground& ground : grounds) {
    progress.show(static_cast<double>(all.size()) / static_cast<double>(grounds.size()));
    const walks::Walk& walk = all.emplace_back(walks::walk(ground, frames, 1));
    const std::string row =
        table_row(program.say(ground.name),
                  {std::to_string(ground.mesh.size()), std::to_string(walk.frames), at_most(walk.depth),
                   std::to_string(walk.tunnelled), std::to_string(walk.reversed),
                   ground.still.isZero() ? "-" : at_most(walk.drift)},
                  head);
    report.also({row, row});
  }
  report.also(
      {"Lengths as parts of the largest coordinate; a penetration below 0 is a gap, here 16 eps = 3.6e-15",
       "長度以最大座標為單位；穿透深度小於 0 即為間隙，此處 16 eps = 3.6e-15"});
  return all;
}
//! [walks]

void note_walks(Program& program, const std::vector<walks::Ground>& grounds,
                const std::vector<walks::Walk>& all) {
  program.value("terrain_triangles", static_cast<double>(grounds.front().mesh.size()));
  walks::Walk worst;
  for (const walks::Walk& walk : all) {
    worst.frames += walk.frames;
    worst.contacts += walk.contacts;
    worst.tunnelled += walk.tunnelled;
    worst.reversed += walk.reversed;
    worst.depth = std::max(worst.depth, walk.depth);
    worst.drift = std::max(worst.drift, walk.drift);
  }
  program.value("walk_frames", static_cast<double>(worst.frames));
  program.value("walk_frames_each", static_cast<double>(all.front().frames));
  program.value("walk_contacts", static_cast<double>(worst.contacts));
  program.value("walk_tunnelled", static_cast<double>(worst.tunnelled));
  program.value("walk_reversed", static_cast<double>(worst.reversed));
  program.value("walk_gap", -worst.depth);
  program.value("walk_drift", worst.drift);
  program.value("gap_eps", slide_gap);
}
