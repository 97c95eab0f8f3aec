#pragma once
#include <filesystem>

namespace first_contact::figure {

/// A new, empty folder among the system's temporary ones, gone with all in it at the end.
class TemporaryFolder {
 public:
  /// \throws std::runtime_error that names TMPDIR and the reason, if there is no place for it.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  /// Where it is.
  const std::filesystem::path& path() const { return path_; }

  /// For who could not write there: tries once more, to learn the reason.
  /// \throws std::runtime_error that names TMPDIR and the reason.
  [[noreturn]] void refuse_writing() const;

 private:
  std::filesystem::path path_;
};

}  // namespace first_contact::figure
