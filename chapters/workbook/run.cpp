#include "workbook/run.hpp"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>

#include "workbook/drawing.hpp"
#include "workbook/report.hpp"
#include "workbook/student.hpp"

namespace workbook {
namespace {

struct Options {
  std::string figure;
  bool brief = false;
  double seconds = 5;
  std::vector<std::string> command;
};

Options options_of(int argc, char** argv) {
  Options options;
  int i = 1;
  for (; i < argc && std::strncmp(argv[i], "--", 2) == 0; ++i) {
    const std::string option = argv[i];
    if (option == "--brief")
      options.brief = true;
    else if (option == "--figure")
      options.figure = argv[++i];
    else if (option == "--seconds")
      options.seconds = std::atof(argv[++i]);
  }
  options.command.assign(argv + i, argv + argc);
  return options;
}

// The words that the catalogue tells of wrong answers alone.
std::vector<Known> wrong_ones(const std::vector<Known>& known) {
  std::vector<Known> wrong;
  for (const Known& each : known)
    if (each.words.contains("Looks like")) wrong.push_back(each);
  return wrong;
}

int check(const Sheet& sheet, const std::vector<Known>& known, const Options& options) {
  Student student(options.command, options.seconds);
  const Ask ask = [&](const Value& input) { return student.ask(input); };
  const std::vector<Known> wrong = wrong_ones(known);
  const Verdict verdict = examine(sheet, wrong, ask);
  if (options.brief)
    std::cout << word_for(verdict) << '\n';
  else
    tell(std::cout, sheet, verdict);
  const bool right = verdict.kind == Verdict::Kind::right;
  if (!options.figure.empty())
    draw(sheet, right ? sheet.chosen.front().input : verdict.probe.input, ask, options.figure);
  return right ? 0 : 1;
}

}  // namespace

int prove(const Sheet& sheet, const std::vector<Known>& known) {
  int faults = 0;
  const std::vector<Known> wrong = wrong_ones(known);
  for (const Known& each : known) {
    const Verdict verdict = examine(sheet, wrong, [&](const Value& input) {
      return Reply{Reply::Kind::answer, each.give(input), ""};
    });
    const std::string expected = each.words.contains("Looks like") ? "known:" + each.name
                                 : each.name == "answer"           ? "constant"
                                                                   : "right";
    if (word_for(verdict) == expected) continue;
    ++faults;
    std::cout << each.name << ": must be " << expected << ", but is " << word_for(verdict) << '\n';
    tell(std::cout, sheet, verdict);
  }
  std::cout << known.size() << " answers asked, " << wrong.size() << " wrong ones known, " << faults
            << " faults\n";
  return faults;
}

int run(const Sheet& sheet, const std::vector<Known>& known, int argc, char** argv) try {
  if (argc > 1 && std::strcmp(argv[1], "--prove") == 0) return prove(sheet, known) > 0 ? 1 : 0;
  return check(sheet, known, options_of(argc, argv));
} catch (const std::exception& error) {
  std::cerr << "judge: " << error.what() << '\n';
  return 3;
}

}  // namespace workbook
