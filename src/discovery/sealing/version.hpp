// The version of sealed datagrams; CONTRIBUTING.md says what it promises.
#ifndef GEMINGA_DISCOVERY_SEALING_VERSION_HPP
#define GEMINGA_DISCOVERY_SEALING_VERSION_HPP

#include <cstdint>

namespace geminga::sealing {

/// In the upper four bits of the second octet. A receiver refuses another one.
inline constexpr std::uint8_t envelope_version = 1;

}  // namespace geminga::sealing

#endif
