// The state of a participant as it is announced on one interface: only addresses and services that are valid there.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_ON_INTERFACE_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_ON_INTERFACE_HPP

#include <span>
#include <string_view>

#include "discovery/announcement/announcement.hpp"
#include "env/env.hpp"

namespace geminga::announcement {

/// Whether a service with this explicit address is announced on `interface`, which is one of `ours`. An empty address
/// (the interface's own) is announced everywhere. A loopback address is announced only on a loopback interface, an
/// address of one of our interfaces only there, one with a zone only on the interface of that name. Any other address,
/// multicast too, is announced everywhere.
[[nodiscard]] bool is_announced_on(std::string_view address, const env::Interface& interface,
                                   std::span<const env::Interface> ours);

/// The state as it goes out on `interface` (paper section 3.5.2): link and addresses are set, zones are removed, and
/// services that are not valid there are moved to `withheld`. Sequence, revision and all else stay as they are.
[[nodiscard]] Announcement on_interface(Announcement state, const env::Interface& interface,
                                        std::span<const env::Interface> ours);

}  // namespace geminga::announcement

#endif
