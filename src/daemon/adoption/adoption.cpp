#include "daemon/adoption/adoption.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/text.hpp"

namespace geminga::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds between_looks{2};

/// The folders of a publisher's versions, the newest first.
std::vector<std::pair<std::uint64_t, std::string>> versions_in(const fs::path& folder) {
  std::vector<std::pair<std::uint64_t, std::string>> versions;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    const auto number = base::parse_number<std::uint64_t>(name);
    if (!number || std::to_string(*number) != name || !fs::is_directory(entry->symlink_status(ignored))) continue;
    versions.emplace_back(*number, entry->path().string());
  }
  std::ranges::sort(versions, std::ranges::greater());
  return versions;
}

}  // namespace

std::vector<std::string> adopted_versions(const Adopted& adopted, std::size_t level) {
  std::vector<std::string> folders;
  for (const std::string& publisher : adopted.publishers) {
    auto versions = versions_in(fs::path(adopted.folder) / publisher);
    if (level < versions.size()) folders.push_back(std::move(versions[level].second));
  }
  return folders;
}

AdoptionWatch::AdoptionWatch(boost::asio::io_context& context, std::function<void()> changed)
    : timer_(context), changed_(std::move(changed)) {}

void AdoptionWatch::watch(const Adopted& adopted) {
  timer_.cancel();
  adopted_ = adopted;
  if (adopted_.publishers.empty()) return;
  seen_ = adopted_versions(adopted_, 0);
  look_later();
}

void AdoptionWatch::look_later() {
  timer_.expires_after(between_looks);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (error) return;
    look_later();
    auto newest = adopted_versions(adopted_, 0);
    if (newest == seen_) return;
    seen_ = std::move(newest);
    changed_();
  });
}

}  // namespace geminga::daemon
