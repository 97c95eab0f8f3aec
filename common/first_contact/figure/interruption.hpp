#pragma once
#include <stdexcept>

namespace first_contact::figure {

/// The user, or the system, wants the program to end: the signal is still to be obeyed.
class Interrupted : public std::runtime_error {
 public:
  /// By that signal.
  explicit Interrupted(int signal) : std::runtime_error("interrupted"), signal_(signal) {}
  /// SIGINT, SIGTERM or SIGHUP.
  int signal() const { return signal_; }

 private:
  int signal_;
};

/// While it lives, a signal that would end the program is only taken down, so that what runs can be ended in
/// order and what is aside be removed. Signals that are ignored stay ignored. One at a time.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// \throws Interrupted if a signal has come.
  void check() const;
};

}  // namespace first_contact::figure
