// What judges one exercise. catalogue.hpp is written by the launcher from the files of known answers.
#include "probes.hpp"
#include "task.hpp"
#include "workbook/report.hpp"
#include "workbook/run.hpp"

#define KNOWN(file, space) \
  {file, [](const Value& input) { return answer_of<Signature>(space::EXERCISE_FUNCTION, input); }, {}},
#include "catalogue.hpp"

int main(int argc, char** argv) {
  std::vector<Known> known = catalogue();
  for (Known& each : known) {
    each.words = head_of(each.name);
    each.name = each.name.substr(each.name.rfind('/') + 1);
    each.name.resize(each.name.rfind('.'));
  }
  return run(SheetOf<Signature>::make(exercise()), known, argc, argv);
}
