#include "workbook/drawing.hpp"

#include <fstream>
#include <ostream>

namespace workbook {
namespace {

constexpr int steps = 160;

// One curve as a data block; where there is no such number, a gap.
void curve(std::ostream& out, const char* name, const Sheet& sheet, const Value& input, const Give& give) {
  const auto& [label, from, to, put, number] = sheet.curve;
  out << '$' << name << " << EOD\n";
  for (int i = 0; i <= steps; ++i) {
    const double at = from + (to - from) * i / steps;
    const Value changed = put(input, at);
    const auto numbers = sheet.allowed(changed) ? numbers_in(give(changed)) : std::vector<double>{};
    if (number < numbers.size())
      out << at << ' ' << numbers[number] << '\n';
    else
      out << '\n';
  }
  out << "EOD\n";
}

}  // namespace

void draw(const Sheet& sheet, const Value& input, const Ask& ask, const std::string& file) {
  std::ofstream out(file);
  const std::string picture = file.substr(0, file.rfind('.')) + ".svg";
  bool alive = true;
  curve(out, "right", sheet, input, sheet.judge);
  curve(out, "yours", sheet, input, [&](const Value& each) {
    const Reply reply = alive ? ask(each) : Reply{Reply::Kind::ended, {}, ""};
    alive = alive && reply.kind == Reply::Kind::answer;
    return reply.value;
  });
  out << "set terminal svg size 640,360 font 'DejaVu Sans,13' background '#FFFFFF'\n"
      << "set output '" << picture
      << "'\nset encoding utf8\nset border 3 lc rgb '#222222'\nset tics nomirror\n"
      << "set key top right reverse Left\nset offsets 0, 0, graph 0.08, graph 0.08\n"
      << "set xlabel \"" << sheet.curve.name << "\"\nset ylabel 'answer'\n"
      << "set xrange [" << sheet.curve.from << ':' << sheet.curve.to << "]\n"
      << "plot $right with lines lw 5 lc rgb '#56B4E9' title 'right', "
      << "$yours with lines lw 1.8 dt 2 lc rgb '#D55E00' title 'yours'\n";
}

}  // namespace workbook
