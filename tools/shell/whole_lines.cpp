#include "shell/whole_lines.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>

namespace geminga::shell {

LineBuffer::int_type LineBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  const char one = traits_type::to_char_type(c);
  return xsputn(&one, 1) == 1 ? c : traits_type::eof();
}

std::streamsize LineBuffer::xsputn(const char* text, std::streamsize size) {
  waiting_.append(text, static_cast<std::size_t>(size));
  const bool is_due = waits_ ? waiting_.size() >= max_waiting_bytes
                             : std::string_view(text, static_cast<std::size_t>(size)).contains('\n');
  return !is_due || write_lines() ? size : 0;
}

int LineBuffer::sync() { return write(waiting_.size()) ? 0 : -1; }

bool LineBuffer::write_lines() {
  const std::size_t end = waiting_.rfind('\n');
  if (end != std::string::npos) return write(end + 1);
  return waiting_.size() < max_waiting_bytes || write(waiting_.size());
}

bool LineBuffer::write(std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t written = ::write(descriptor_, waiting_.data() + done, size - done);
    if (written >= 0) {
      done += static_cast<std::size_t>(written);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      pollfd room{.fd = descriptor_, .events = POLLOUT, .revents = 0};
      ::poll(&room, 1, -1);  // another program has made the terminal non-blocking
    } else if (errno != EINTR) {
      waiting_.erase(0, size);
      return false;
    }
  }
  waiting_.erase(0, size);
  return true;
}

WholeLines::WholeLines()
    : output_(STDOUT_FILENO, true),
      errors_(STDERR_FILENO, false),
      former_output_(std::cout.rdbuf(&output_)),
      former_errors_(std::cerr.rdbuf(&errors_)) {
  std::cerr.unsetf(std::ios::unitbuf);
}

WholeLines::~WholeLines() {
  std::cout.flush();
  std::cerr.flush();
  std::cout.rdbuf(former_output_);
  std::cerr.rdbuf(former_errors_);
  std::cerr.setf(std::ios::unitbuf);
}

}  // namespace geminga::shell
