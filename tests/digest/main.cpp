// The answers of every verb to questions that are made to be hard, as one number for each verb: the same on
// every machine. `digest` prints them, `digest FILE` compares them with a file, `digest --show VERB` prints
// each answer.
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <string>

#include "record.hpp"

namespace {

using namespace digest;

std::vector<Verb> all_verbs() {
  std::vector<Verb> all;
  for (const auto& verbs : {shape_verbs(), sweep_verbs(), box_verbs(), surface_verbs(), motion_verbs()})
    all.insert(all.end(), verbs.begin(), verbs.end());
  return all;
}

std::string line_of(const Verb& verb) {
  Record record(false);
  verb.ask(record);
  char line[128];
  std::snprintf(line, sizeof line, "%-28s %6zu %016" PRIx64, verb.name, record.answers(), record.hash());
  return line;
}

int show(const char* name) {
  Record record(true);
  for (const Verb& verb : all_verbs())
    if (std::strcmp(verb.name, name) == 0) return verb.ask(record), 0;
  std::fprintf(stderr, "digest: '%s': must be the name of a verb\n", name);
  return 2;
}

std::vector<std::string> lines_of(const char* path) {
  std::vector<std::string> lines;
  std::FILE* file = std::fopen(path, "r");
  if (!file) return lines;
  char line[256];
  while (std::fgets(line, sizeof line, file)) lines.emplace_back(line, std::strcspn(line, "\r\n"));
  std::fclose(file);
  return lines;
}

int compare(const char* path) {
  const std::vector<std::string> expected = lines_of(path);
  const std::vector<Verb> verbs = all_verbs();
  if (expected.size() != verbs.size()) {
    std::fprintf(stderr, "digest: '%s': must have %zu lines, one a verb\n", path, verbs.size());
    return 2;
  }
  int unequal = 0;
  for (std::size_t i = 0; i < verbs.size(); ++i) {
    const std::string line = line_of(verbs[i]);
    if (line == expected[i]) continue;
    std::printf("differs: %s\n    not: %s\n", line.c_str(), expected[i].c_str());
    ++unequal;
  }
  std::printf("%zu verbs, %d differ\n", verbs.size(), unequal);
  return unequal > 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 3 && std::strcmp(arguments[1], "--show") == 0) return show(arguments[2]);
  if (count == 2) return compare(arguments[1]);
  for (const Verb& verb : all_verbs()) std::printf("%s\n", line_of(verb).c_str());
}
