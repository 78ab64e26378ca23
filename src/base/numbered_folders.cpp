#include "base/numbered_folders.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/text.hpp"

namespace geminga::base {

std::vector<std::uint64_t> numbered_folders(const std::string& folder) {
  namespace fs = std::filesystem;
  std::vector<std::uint64_t> numbers;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    const auto number = parse_number<std::uint64_t>(name);
    if (number && std::to_string(*number) == name && fs::is_directory(entry->symlink_status(ignored)))
      numbers.push_back(*number);
  }
  std::ranges::sort(numbers);
  return numbers;
}

}  // namespace geminga::base
