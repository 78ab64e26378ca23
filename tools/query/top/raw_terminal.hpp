// A terminal that gives each key at once and shows one screen, as long as the program is there.
#ifndef GEMINGA_QUERY_TOP_RAW_TERMINAL_HPP
#define GEMINGA_QUERY_TOP_RAW_TERMINAL_HPP

#include <string>
#include <string_view>

#include "query/top/screen.hpp"

namespace geminga::query::top {

/// Takes the terminal of standard input and output for its life: no echo, no lines, the other screen (xterm's 1049), no
/// cursor. Gives it back as it was on every way out: its destructor, Ctrl-Z until the program goes on, and the signals
/// that end a program by a fault or an abort. Only SIGKILL leaves it as it is. At most one may exist.
class RawTerminal {
 public:
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

  /// Whether standard input and output are one that can be used so; TERM=dumb is none.
  [[nodiscard]] static bool is_there();
  [[nodiscard]] static Size size();

  /// A descriptor that is readable when the size has changed, or when the program goes on behind Ctrl-Z. Owned by this
  /// object.
  [[nodiscard]] int changes() const { return changes_; }
  /// Whether that has happened since the last call. Then nothing of what was written may be there any more.
  [[nodiscard]] bool take_change() const;

  /// The octets of the keys that wait; never waits. False: the terminal is gone.
  [[nodiscard]] bool read(std::string& octets) const;
  /// False: the terminal is gone.
  [[nodiscard]] bool write(std::string_view octets) const;

 private:
  int changes_ = -1;
};

}  // namespace geminga::query::top

#endif
