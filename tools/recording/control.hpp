// The words by which a user moves a replay while it runs.
#ifndef GEMINGA_RECORDING_CONTROL_HPP
#define GEMINGA_RECORDING_CONTROL_HPP

#include <chrono>
#include <expected>
#include <string>
#include <string_view>
#include <variant>

#include "recording/moment.hpp"

namespace geminga::recording {

struct Toggle {};  ///< pauses what plays, and plays what stands
struct Pause {};
struct Play {};
struct SetSpeed {
  double speed = 1;
};
struct Seek {
  Moment moment;
};
/// Seeks so long ahead, or back.
struct Skip {
  std::chrono::milliseconds time{};
};
using Control = std::variant<Toggle, Pause, Play, SetSpeed, Seek, Skip>;

/// Reads a line: empty, `pause`, `play`, `speed X`, `seek TIME` (as --from), `+SECONDS` or `-SECONDS`; the first
/// letters of a word do. The error is one line that names the words.
[[nodiscard]] std::expected<Control, std::string> read_control(std::string_view line);

}  // namespace geminga::recording

#endif
