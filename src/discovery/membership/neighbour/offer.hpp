// A service of another participant as it was announced, which nobody changes, so that all who know it may share it.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_OFFER_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_OFFER_HPP

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/shared_values.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// A publication or a subscription, and the name of its peer.
struct Offer {
  std::variant<Publication, Subscription> service;
  std::string peer_name;
};
/// Null: a service that is not there.
using SharedOffer = std::shared_ptr<const Offer>;

/// Whether an offer is of this service of this peer.
template <typename Service>
[[nodiscard]] bool is_of(const Offer& offer, const Service& service, const std::string& peer_name) {
  const auto* same = std::get_if<Service>(&offer.service);
  return same != nullptr && *same == service && offer.peer_name == peer_name;
}

/// The offers that the tables of several participants in one process know, each once. What is learned from a table
/// does not depend on it: an offer is given for an equal one only.
class Offers {
 public:
  /// The offer of this service of this peer, which was announced under this key. O(log n).
  template <typename Service>
  [[nodiscard]] SharedOffer share(const ServiceKey& key, const Service& service, const std::string& peer_name) {
    return values_.share(
        {key, std::is_same_v<Service, Publication>},
        [&](const Offer& known) { return is_of(known, service, peer_name); },
        [&] { return Offer{service, peer_name}; });
  }

 private:
  base::SharedValues<std::pair<ServiceKey, bool>, Offer> values_;
};

}  // namespace geminga::membership

#endif
