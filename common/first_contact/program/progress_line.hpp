#pragma once
#include <string>

namespace first_contact::program {

/// A line on standard error that tells how far a long work is, written again and again and wiped at the end.
/// Where standard error is no terminal nothing is written.
class ProgressLine {
 public:
  /// \param name  of the work
  explicit ProgressLine(std::string name);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// \param part  that is done, from 0 to 1
  void show(double part) const;

 private:
  std::string name_;
  bool seen_;
};

}  // namespace first_contact::program
