#include "shell/timestamp.hpp"

#include <array>
#include <cstdio>

namespace geminga::shell {

std::string timestamp(std::chrono::system_clock::time_point instant) {
  using namespace std::chrono;
  const auto whole = floor<milliseconds>(instant);
  const auto day = floor<days>(whole);
  const year_month_day date(day);
  const hh_mm_ss time(whole - day);
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                static_cast<int>(time.seconds().count()), static_cast<int>(time.subseconds().count()));
  return text.data();
}

std::string timestamp() { return timestamp(std::chrono::system_clock::now()); }

}  // namespace geminga::shell
