#pragma once
#include <filesystem>

namespace first_contact::figure {

/// A new, empty folder among the system's temporary ones, gone with all in it at the end.
class TemporaryFolder {
 public:
  /// \throws std::filesystem::filesystem_error if there is no place for it.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  /// Where it is.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace first_contact::figure
