// Writes lines to standard error without waiting: whole, or not at all.
#ifndef GEMINGA_DAEMON_LOG_LOG_WRITER_HPP
#define GEMINGA_DAEMON_LOG_LOG_WRITER_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace geminga::daemon {

/// Never waits for the reader: a pipe that is not read, a terminal that was stopped with Ctrl-S, a socket of a journal
/// that hangs. A line that finds no room is dropped. The kernel's buffer is the only queue, so that written lines
/// survive the end of this process.
class LogWriter {
 public:
  /// Writes to this descriptor. It is borrowed, and its flags stay as they are: other processes may share them.
  explicit LogWriter(int descriptor);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /// Writes a line with its line end. False: there was no room, and the whole line is dropped.
  [[nodiscard]] bool write(std::string_view line);
  /// Writes the rest of a line that was begun. False: some of it is left.
  bool finish_begun();

 private:
  enum class Method : std::uint8_t {
    plain,         ///< a file or nothing at all: no reader can hold it up
    non_blocking,  ///< a pipe or terminal that was opened again with O_NONBLOCK
    socket,
    polled,  ///< a pipe or terminal that cannot be opened again: written to while poll() says that there is room
  };

  /// Writes octets. Returns the number of them that were taken; 0 where there is no room, or an error.
  [[nodiscard]] std::size_t put(std::string_view bytes) const;

  int descriptor_;
  Method method_ = Method::plain;
  std::string begun_;  ///< the rest of a line whose beginning is written
};

}  // namespace geminga::daemon

#endif
