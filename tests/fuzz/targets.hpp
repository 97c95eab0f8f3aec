#pragma once
#include <string>
#include <vector>

/// What is fed with bytes of any kind: the readers of mesh files, that of options and that of films.

/// Something that reads, and what must be true of it whatever it reads.
struct Target {
  std::string name;
  /// Throws std::logic_error if what must be true is not.
  void (*feed)(const std::string& bytes);
};

/// All of them.
const std::vector<Target>& all_targets();
