// Feeds each target with its corpus, and with what becomes of it by changes at random: the part of fuzzing
// that any compiler can do in seconds. What fails is printed, as text that C++ reads.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <random>

#include "first_contact/files/input.hpp"
#include "first_contact/files/printable.hpp"
#include "targets.hpp"

namespace fs = std::filesystem;

namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) { return random() % std::max<std::size_t>(count, 1); }

// One change: a byte, a bit, a piece left out, twice, or from another file, or a word that has made trouble
// elsewhere.
std::string changed(std::string bytes, const std::vector<std::string>& corpus, Random& random) {
  static const std::vector<std::string> words{
      "0",  "-1",   "1e-400", "1e999", "nan", "inf",          "4294967295",         "9223372036854775808",
      "\n", "\\\n", " ",      "/",     "+-",  "\xEF\xBB\xBF", std::string(1, '\0'), "\x1b["};
  const std::size_t at = below(random, bytes.size() + 1), length = below(random, 20);
  switch (below(random, 6)) {
    case 0:
      if (at < bytes.size()) bytes[at] = static_cast<char>(random());
      break;
    case 1:
      if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8)));
      break;
    case 2:
      bytes.erase(at, length);
      break;
    case 3:
      bytes.insert(at, bytes.substr(at, length));
      break;
    case 4:
      bytes.insert(at, words[below(random, words.size())]);
      break;
    default: {
      const std::string& other = corpus[below(random, corpus.size())];
      bytes = bytes.substr(0, at) + other.substr(below(random, other.size() + 1));
    }
  }
  return bytes;
}

bool fails(const Target& target, const std::string& bytes) {
  try {
    target.feed(bytes);
    return false;
  } catch (const std::exception& error) {
    std::cerr << target.name << ": " << error.what() << "\n  when fed with \""
              << first_contact::printable(bytes, 4096) << "\"\n";
    return true;
  }
}

std::vector<std::string> corpus_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> corpus;
  for (const fs::path& file : files) corpus.push_back(first_contact::read_file(file));
  return corpus;
}

int replay(const Target& target, const fs::path& folder, int changes) {
  const std::vector<std::string> corpus = corpus_of(folder / target.name);
  int failures = 0;
  for (const std::string& bytes : corpus) failures += fails(target, bytes);
  Random random(20240501);
  for (int i = 0; i < changes && failures < 10; ++i) {
    std::string bytes = corpus[below(random, corpus.size())];
    for (std::size_t left = 1 + below(random, 4); left > 0; --left) bytes = changed(bytes, corpus, random);
    failures += fails(target, bytes);
  }
  std::cout << target.name << ": " << corpus.size() << " files and " << changes << " changed ones, "
            << failures << " failures\n";
  return failures;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: fuzz_replay CORPUS CHANGES\n";
    return 2;
  }
  int failures = 0;
  for (const Target& target : all_targets()) failures += replay(target, argv[1], std::stoi(argv[2]));
  return failures > 0;
}
