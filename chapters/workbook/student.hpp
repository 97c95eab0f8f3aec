#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

#include "workbook/verdict.hpp"

namespace workbook {

/// A student's program: started when it is asked, started again after it has died, stopped when it takes too
/// long. Its
/// memory and the size of what it writes are limited.
class Student {
 public:
  /// \param command  the program with its arguments
  /// \param seconds  for one answer
  Student(std::vector<std::string> command, double seconds);
  ~Student();
  Student(const Student&) = delete;
  Student& operator=(const Student&) = delete;

  Reply ask(const Value& input);

 private:
  void start();
  void stop();
  bool send(const std::string& line) const;
  bool receive(std::string& line);
  Reply died();

  std::vector<std::string> command_;
  double seconds_;
  pid_t process_ = -1;
  int asks_ = -1, answers_ = -1, words_ = -1;  // files: to the program, from it, and what it prints
  std::string unread_;
};

}  // namespace workbook
