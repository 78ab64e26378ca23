#include "daemon/log/log_writer.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>

namespace geminga::daemon {

LogWriter::LogWriter(int descriptor) : descriptor_(descriptor) {
  struct stat status{};
  if (::fstat(descriptor, &status) != 0 || S_ISREG(status.st_mode)) return;
  if (S_ISSOCK(status.st_mode)) {
    method_ = Method::socket;
    return;
  }
  // Opened again, because O_NONBLOCK on the given description would hold for every process that shares it.
  const std::string path = "/proc/self/fd/" + std::to_string(descriptor);
  const int own = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  method_ = own < 0 ? Method::polled : Method::non_blocking;
  if (own >= 0) descriptor_ = own;
}

LogWriter::~LogWriter() {
  if (method_ == Method::non_blocking) ::close(descriptor_);
}

bool LogWriter::write(std::string_view line) {
  const std::size_t taken = finish_begun() ? put(line) : 0;
  if (taken == 0) return false;
  begun_ = line.substr(taken);
  return true;
}

bool LogWriter::finish_begun() {
  if (!begun_.empty()) begun_.erase(0, put(begun_));
  return begun_.empty();
}

std::size_t LogWriter::put(std::string_view bytes) const {
  ssize_t count = 0;
  do {
    if (method_ == Method::socket) {
      count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    } else {
      if (method_ == Method::polled) {
        // A pipe that poll() finds writable has room for PIPE_BUF octets.
        bytes = bytes.substr(0, PIPE_BUF);
        pollfd room{descriptor_, POLLOUT, 0};
        if (::poll(&room, 1, 0) != 1 || (room.revents & POLLOUT) == 0) return 0;
      }
      count = ::write(descriptor_, bytes.data(), bytes.size());
    }
  } while (count < 0 && errno == EINTR);
  return static_cast<std::size_t>(std::max<ssize_t>(count, 0));
}

}  // namespace geminga::daemon
