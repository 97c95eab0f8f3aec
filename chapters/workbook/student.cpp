#include "workbook/student.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace workbook {
namespace {

constexpr rlim_t memory = rlim_t{1} << 30, file_size = rlim_t{1} << 20, processor_seconds = 60;
constexpr std::size_t longest_answer = std::size_t{1} << 20;
constexpr int child_asks = 3, child_answers = 4;

void limit(int what, rlim_t most) {
  const rlimit limits{most, most};
  setrlimit(static_cast<decltype(RLIMIT_CPU)>(what), &limits);
}

// A pipe whose two ends no other program inherits.
void open_pipe(int (&ends)[2]) {
  if (pipe(ends) != 0) throw std::runtime_error("no pipe can be opened");
  for (int& end : ends) {
    const int high = fcntl(end, F_DUPFD_CLOEXEC, 10);
    close(end);
    end = high;
  }
}

[[noreturn]] void become(const std::vector<std::string>& command, int asks, int answers, int words) {
  setpgid(0, 0);
  dup2(asks, child_asks);
  dup2(answers, child_answers);
  dup2(words, 1);
  dup2(words, 2);
  std::signal(SIGXFSZ, SIG_IGN);  // who prints too much goes on, unheard
  limit(RLIMIT_AS, memory);
  limit(RLIMIT_FSIZE, file_size);
  limit(RLIMIT_CPU, processor_seconds);
  limit(RLIMIT_CORE, 0);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

std::string last_line(const std::string& text) {
  const auto end = text.find_last_not_of("\r\n");
  if (end == std::string::npos) return "";
  const auto begin = text.find_last_of('\n', end);
  return text.substr(begin + 1, end - begin);
}

// What was printed so far; the program writes to the end of the file.
std::string read_all(int file) {
  std::string text(longest_answer, ' ');
  const ssize_t n = pread(file, text.data(), text.size(), 0);
  text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return text;
}

std::size_t size_of(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  return size > 0 ? std::min(static_cast<std::size_t>(size), longest_answer) : 0;
}

// What failed assertions say of themselves begins with where they stand in the compiler's library.
std::string without_place(const std::string& said) {
  const auto assertion = said.find("Assertion");
  return assertion == std::string::npos ? said : said.substr(assertion);
}

int open_words() {
  std::FILE* const file = std::tmpfile();
  if (!file) throw std::runtime_error("no temporary file can be opened");
  const int words = fcntl(fileno(file), F_DUPFD_CLOEXEC, 10);
  std::fclose(file);
  fcntl(words, F_SETFL, O_APPEND);
  return words;
}

}  // namespace

Student::Student(std::vector<std::string> command, double seconds)
    : command_(std::move(command)), seconds_(seconds) {
  std::signal(SIGPIPE, SIG_IGN);
}

Student::~Student() { stop(); }

void Student::start() {
  int asks[2], answers[2];
  open_pipe(asks), open_pipe(answers);
  words_ = open_words();
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no process can be started");
  if (process_ == 0) become(command_, asks[0], answers[1], words_);
  setpgid(process_, process_);
  close(asks[0]), close(answers[1]);
  asks_ = asks[1], answers_ = answers[0];
  unread_.clear();
}

void Student::stop() {
  if (process_ < 0) return;
  kill(-process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = -1;
  close(asks_), close(answers_), close(words_);
}

bool Student::send(const std::string& line) const {
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t n = write(asks_, line.data() + sent, line.size() - sent);
    if (n <= 0) return false;
    sent += static_cast<std::size_t>(n);
  }
  return true;
}

// False when time is over (`line` is then "endless"), or when there is nobody left to answer.
bool Student::receive(std::string& line) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds_);
  line.clear();
  while (unread_.find('\n') == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd waiting{answers_, POLLIN, 0};
    if (left <= 0 || unread_.size() > longest_answer || poll(&waiting, 1, static_cast<int>(left)) == 0)
      return line = "endless", false;
    char part[4096];
    const ssize_t n = read(answers_, part, sizeof part);
    if (n <= 0) return false;
    unread_.append(part, static_cast<std::size_t>(n));
  }
  line = unread_.substr(0, unread_.find('\n'));
  unread_.erase(0, line.size() + 1);
  return true;
}

// By a signal, or by its own will.
Reply Student::died() {
  int status = 0;
  pollfd waiting{answers_, 0, 0};
  poll(&waiting, 1, 100);
  kill(-process_, SIGKILL);
  waitpid(process_, &status, 0);
  const std::string said = without_place(last_line(read_all(words_)));
  process_ = -1;
  close(asks_), close(answers_), close(words_);
  if (!WIFSIGNALED(status))
    return {Reply::Kind::ended,
            {},
            "status " + std::to_string(WEXITSTATUS(status)) + (said.empty() ? "" : ": " + said)};
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) return {Reply::Kind::endless, {}, ""};
  return {Reply::Kind::crashed, {}, strsignal(signal) + (said.empty() ? "" : ": " + said)};
}

Reply Student::ask(const Value& input) {
  if (process_ < 0) start();
  const std::size_t before = size_of(words_);
  std::string line;
  if (!send(written(input) + "\n") || !receive(line)) {
    if (line != "endless") return died();
    stop();
    return {Reply::Kind::endless, {}, ""};
  }
  const std::string printed = size_of(words_) > before ? read_all(words_).substr(before) : "";
  if (line[0] == 'm') return {Reply::Kind::out_of_memory, {}, ""};
  if (line[0] == '!') return {Reply::Kind::threw, {}, line.substr(2)};
  try {
    return {Reply::Kind::answer, read_value(line.substr(1)), printed};
  } catch (const std::exception& error) {
    return {Reply::Kind::ended, {}, error.what()};
  }
}

}  // namespace workbook
