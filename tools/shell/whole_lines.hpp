// Writes standard output and standard error in whole lines, so that those of several programs on one terminal do not
// mix.
#ifndef GEMINGA_SHELL_WHOLE_LINES_HPP
#define GEMINGA_SHELL_WHOLE_LINES_HPP

#include <cstddef>
#include <ostream>
#include <streambuf>
#include <string>

namespace geminga::shell {

/// What waits for the end of its line, of standard output: more is written without waiting further.
inline constexpr std::size_t max_waiting_bytes = 65'536;

/// Collects what a stream is given. Flushing writes it all in one call of the system, and so does what comes when
/// enough has come, up to the end of a line. Where it cannot be written, the stream fails as any other.
class LineBuffer : public std::streambuf {
 public:
  /// With `waits`, lines wait until they are flushed or are many; without, each is written at its end.
  LineBuffer(int descriptor, bool waits) : descriptor_(descriptor), waits_(waits) {}

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  /// So many octets from the front. False: not all could be written; then nothing is kept of them.
  bool write(std::size_t size);
  bool write_lines();

  int descriptor_;
  bool waits_;
  std::string waiting_;
};

/// Has std::cout and std::cerr write whole lines for as long as it lives. One at a time.
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
