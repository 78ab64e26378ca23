// The words of the reasons for which a datagram is refused.
#include <array>
#include <utility>

#include "discovery/announcement/codec.hpp"

namespace geminga::announcement {

std::string_view to_string(DecodeError error) {
  static constexpr std::array<std::string_view, decode_error_count> words = {
      "too-large",   "not-protobuf", "not-geminga",   "other-version", "bad-kind",      "bad-identifier",
      "bad-name",    "bad-interval", "bad-part",      "bad-address",   "bad-table",     "bad-identity",
      "bad-mode",    "bad-degree",   "bad-port",      "bad-protocol",  "bad-attribute", "bad-filter",
      "bad-witness", "bad-change",   "bad-diagnosis", "bad-relayed",
  };
  return words.at(std::to_underlying(error));
}

}  // namespace geminga::announcement
