// Writes standard output and standard error in whole lines, so that the lines of several programs on one terminal do
// not mix.
#ifndef GEMINGA_SHELL_WHOLE_LINES_HPP
#define GEMINGA_SHELL_WHOLE_LINES_HPP

#include <cstddef>
#include <streambuf>
#include <string>

namespace geminga::shell {

/// The most octets that wait for the end of their line. More are written at once.
inline constexpr std::size_t max_waiting_bytes = 65'536;

/// Collects the output of a stream. Flushing writes all of it in one system call; without flushing, full lines are
/// written when there are many. Where they cannot be written, the stream fails as any other.
class LineBuffer : public std::streambuf {
 public:
  /// With `waits`, lines wait until they are flushed or there are many; without, each is written at its end.
  LineBuffer(int descriptor, bool waits) : descriptor_(descriptor), waits_(waits) {}

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  /// Writes so many octets from the front and drops them. False: not all could be written.
  bool write(std::size_t size);
  bool write_lines();

  int descriptor_;
  bool waits_;
  std::string waiting_;
};

/// Makes std::cout and std::cerr write whole lines for its life. Only one may exist.
class WholeLines {
 public:
  WholeLines();
  ~WholeLines();
  WholeLines(const WholeLines&) = delete;
  WholeLines& operator=(const WholeLines&) = delete;

 private:
  LineBuffer output_;
  LineBuffer errors_;
  std::streambuf* former_output_;
  std::streambuf* former_errors_;
};

}  // namespace geminga::shell

#endif
