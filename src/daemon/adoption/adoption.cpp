#include "daemon/adoption/adoption.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/numbered_folders.hpp"

namespace geminga::daemon {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds between_looks{2};

}  // namespace

std::vector<std::string> adopted_versions(const Adopted& adopted, std::size_t level) {
  std::vector<std::string> folders;
  for (const std::string& publisher : adopted.publishers) {
    const fs::path folder = fs::path(adopted.folder) / publisher;
    const std::vector<std::uint64_t> versions = base::numbered_folders(folder.string());
    if (level >= versions.size()) continue;
    folders.push_back((folder / std::to_string(versions[versions.size() - 1 - level])).string());
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
