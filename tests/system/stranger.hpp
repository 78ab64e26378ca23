// A program on a host of the lab that listens to the team's group and sends any datagram there.
#ifndef GEMINGA_TESTS_SYSTEM_STRANGER_HPP
#define GEMINGA_TESTS_SYSTEM_STRANGER_HPP

#include <netinet/in.h>

#include <optional>
#include <string>

#include "support/lab.hpp"

namespace geminga::system {

/// Needs no rights that other programs lack.
class Stranger {
 public:
  /// `source` is the address that it sends from; the host's own by default.
  Stranger(const Lab& lab, std::size_t host, const std::string& source = "");
  ~Stranger();
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

  /// Sends to the group. False where the system refuses.
  [[nodiscard]] bool send(const std::string& bytes) const;
  /// Sends to one host.
  [[nodiscard]] bool send_to(const std::string& address, std::uint16_t port, const std::string& bytes) const;
  /// The next datagram that another program sends to the group; nothing after a moment without one.
  [[nodiscard]] std::optional<std::string> hear() const;

 private:
  int socket_ = -1;
  int ear_ = -1;
  std::uint16_t own_port_ = 0;
  sockaddr_in group_{};
};

}  // namespace geminga::system

#endif
