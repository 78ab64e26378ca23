#include "manual/describe.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "manual/bash_completion.hpp"
#include "manual/fish_completion.hpp"
#include "manual/man_page.hpp"
#include "manual/outline.hpp"
#include "manual/zsh_completion.hpp"

namespace geminga::manual {
namespace {

/// The day of $SOURCE_DATE_EPOCH, so that two builds of a package are the same (reproducible-builds.org); else today.
std::string date() {
  using namespace std::chrono;
  auto instant = system_clock::now();
  if (const char* const told = std::getenv("SOURCE_DATE_EPOCH"); told != nullptr) {
    const std::string_view text(told);
    std::int64_t count = 0;
    std::from_chars(text.data(), text.data() + text.size(), count);
    constexpr std::int64_t last = 9'214'646'400;  // in the year 2261, near the last that nanoseconds can count
    instant = system_clock::time_point(seconds(std::min(std::max<std::int64_t>(count, 0), last)));
  }
  const year_month_day day(floor<days>(instant));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(day.year()),
                static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
  return text.data();
}

}  // namespace

std::optional<std::string> described(const CLI::App& app, int argc, const char* const* argv, int section) {
  if (argc != 3 || std::string_view(argv[1]) != "--describe") return std::nullopt;
  const std::string_view form = argv[2];
  if (form == "man") return man_page(outline_of(app), section, date());
  if (form == "bash") return bash_completion(outline_of(app));
  if (form == "zsh") return zsh_completion(outline_of(app));
  if (form == "fish") return fish_completion(outline_of(app));
  return std::nullopt;
}

}  // namespace geminga::manual
