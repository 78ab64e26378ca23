// Standard error as the log writes it: a line is written whole, at once, or not at all.
#ifndef GEMINGA_DAEMON_LOG_WRITER_HPP
#define GEMINGA_DAEMON_LOG_WRITER_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace geminga::daemon {

/// Never waits for whoever reads: a pipe that nobody empties, a terminal that was stopped with Ctrl-S, a socket of a
/// journal that hangs. What finds no room is dropped. The kernel's buffer of the pipe is the only queue, so
/// that what was written survives the end of this process.
class LogWriter {
 public:
  /// Writes to this descriptor, which it borrows and leaves as it is: others may share its flags.
  explicit LogWriter(int descriptor);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /// Writes a line, its end included. False: there was no room, and it is dropped as a whole.
  [[nodiscard]] bool write(std::string_view line);
  /// Writes what is left of a line that was begun. False: it is still not whole.
  bool finish_begun();

 private:
  enum class Way : std::uint8_t {
    plain,         ///< a file or nothing at all: no reader can hold it up
    non_blocking,  ///< a description of our own, which does not wait
    socket,
    polled,  ///< one that we may not open again: written to while it says that there is room
  };

  /// How many octets were taken; 0 where there is no room, or an error.
  [[nodiscard]] std::size_t put(std::string_view bytes) const;

  int descriptor_;
  Way way_ = Way::plain;
  std::string begun_;  ///< the rest of a line of which the beginning is out
};

}  // namespace geminga::daemon

#endif
