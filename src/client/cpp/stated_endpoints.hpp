// The endpoints at which the options of a client say that its daemon listens.
#ifndef GEMINGA_CLIENT_CPP_STATED_ENDPOINTS_HPP
#define GEMINGA_CLIENT_CPP_STATED_ENDPOINTS_HPP

#include <cstdlib>
#include <expected>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "client/channels/endpoint.hpp"
#include "geminga/client.hpp"

namespace geminga::client {

/// The endpoint of `connect`, or of GEMINGA_CONNECT if that is empty, or the usual ones. Error: wrong_use.
[[nodiscard]] inline std::expected<std::vector<Endpoint>, ClientError> stated_endpoints(const std::string& connect) {
  std::string text = connect;
  if (text.empty()) {
    const char* variable = std::getenv("GEMINGA_CONNECT");
    if (variable != nullptr) text = variable;
  }
  if (text.empty()) return usual_endpoints();
  const auto place = endpoint(text);
  if (!place) {
    return std::unexpected(ClientError{
        ClientError::Kind::wrong_use,
        base::printable(text) + " is no address of a daemon: write ADDRESS:PORT, [ADDRESS]:PORT or the path of a "
                                "socket"});
  }
  return std::vector{*place};
}

}  // namespace geminga::client

#endif
