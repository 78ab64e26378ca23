#include "shell/report.hpp"

#include <iostream>

#include "shell/terminal.hpp"

namespace geminga::shell {

void complain(std::string_view program, std::string_view text) {
  std::cout << std::flush;
  std::cerr << program << ": " << printable(text) << '\n' << std::flush;
}

ExitStatus report(std::string_view program, const ClientError& error) {
  complain(program, error.text);
  switch (error.kind) {
    case ClientError::Kind::wrong_use:
      return ExitStatus::wrong_use;
    case ClientError::Kind::unreachable:
    case ClientError::Kind::closed:
      return ExitStatus::no_daemon;
    case ClientError::Kind::timed_out:
      return ExitStatus::timed_out;
    case ClientError::Kind::refused:
      break;
  }
  if (error.code == ErrorCode::unknown_request) return ExitStatus::nothing;
  if (error.code == ErrorCode::not_ready || error.code == ErrorCode::too_many) return ExitStatus::no_daemon;
  return ExitStatus::wrong_use;
}

ExitStatus written(std::string_view program, ExitStatus status) {
  if (std::cout.flush()) return status;
  std::cout.clear();  // so that complain() can flush it
  complain(program, "standard output cannot be written: is the disk full?");
  return ExitStatus::wrong_use;
}

}  // namespace geminga::shell
