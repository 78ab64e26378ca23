// Paths that do not depend on the current folder.
#include "reasoning/owl/source_paths.hpp"

#include <filesystem>
#include <system_error>

namespace geminga::owl {
namespace {

namespace fs = std::filesystem;

/// Absolute, without `.` and `..`. Links are kept, unless a `..` behind a link leads elsewhere than the text says.
fs::path plain(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  if (error) return path;
  fs::path normal = whole.lexically_normal();
  if (!normal.has_filename() && normal.has_relative_path()) normal = normal.parent_path();  // "/ws/" is "/ws"
  if (normal == whole || fs::equivalent(normal, whole, error)) return normal;
  fs::path canonical = fs::weakly_canonical(whole, error);
  return error ? normal : canonical;
}

}  // namespace

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return plain(folder.empty() ? fs::path(".") : folder).string();
}

std::string seen_from_folder(const std::string& folder, const std::string& path) {
  const fs::path relative = plain(path).lexically_relative(folder);
  return relative.empty() ? path : relative.string();
}

std::string seen_from_here(const std::string& folder, const std::string& path) {
  if (folder.empty() || path.empty() || fs::path(path).is_absolute()) return path;
  return (fs::path(folder) / path).lexically_normal().string();
}

}  // namespace geminga::owl
