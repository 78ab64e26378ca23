// Publications and subscriptions by the names that a peer uses, before an ontology has turned them into IRIs.
#ifndef GEMINGA_NAMED_HPP
#define GEMINGA_NAMED_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geminga/identity.hpp"
#include "geminga/match.hpp"
#include "geminga/service.hpp"

namespace geminga {

/// A concept and a representation as a user writes them: `prefix:Name`, `<IRI>`, or a label where it is unambiguous.
struct ConceptNames {
  std::string concept_name;
  std::string representation_name;  ///< empty: unstated in a publication, any in a subscription
  friend bool operator==(const ConceptNames&, const ConceptNames&) = default;
};

/// The IDENTITY of GCNP: `id=N`, `text=NAME`, or `concept=C [representation=R]`.
using NamedIdentity = std::variant<NumericIdentity, TextIdentity, ConceptNames>;

/// A publication whose identity is stated by name. The fields mean what they mean in Publication.
struct NamedPublication {
  NamedIdentity identity;
  ChannelMode mode = ChannelMode::one_to_one;
  std::string address;
  std::uint16_t port = 0;  ///< 1 to 65535
  std::string protocol = "udp";
  std::int32_t priority = 0;
  Attributes attributes;
  std::string scope{};
  std::string for_whom{};
  friend bool operator==(const NamedPublication&, const NamedPublication&) = default;
};

/// A subscription whose identity is stated by name. The fields mean what they mean in Subscription.
struct NamedSubscription {
  NamedIdentity identity;
  ChannelMode mode = ChannelMode::one_to_one;
  Degree weakest = Degree::narrower;
  std::vector<ProviderFilter> providers;
  std::string where;
  std::optional<std::uint32_t> limit;  ///< nothing: 1 for one_to_one and all otherwise; 0: all
  std::int32_t priority = 0;
  std::uint16_t port = 0;
  std::string address;
  Attributes attributes;
  std::vector<std::string> protocols{};
  std::vector<ProviderFilter> favoured{};
  std::string prefer{};
  std::string rank{};
  std::string scope{};
  std::uint32_t convert = 0;
  std::string on{};  ///< a class or a class expression that must describe the provider's participant; empty: any
  RequiredReach reach = RequiredReach::routed;
  friend bool operator==(const NamedSubscription&, const NamedSubscription&) = default;
};

/// New names of a service; a name that is not given stays. An empty representation takes back the stated one.
struct ConceptChange {
  std::optional<std::string> concept_name;
  std::optional<std::string> representation_name;
  friend bool operator==(const ConceptChange&, const ConceptChange&) = default;
};

/// A new identity. A number or a text becomes a concept by a ConceptChange with a concept.
using IdentityChange = std::variant<NumericIdentity, TextIdentity, ConceptChange>;

/// A change of a publication; a field that is not given stays.
struct PublicationChange {
  std::optional<IdentityChange> identity;
  std::optional<ChannelMode> mode;
  std::optional<std::string> address;  ///< empty: back to the provider's own
  std::optional<std::uint16_t> port;
  std::optional<std::string> protocol;
  std::optional<std::int32_t> priority;
  Attributes attributes;                  ///< added to those that are there; one of the same key takes its place
  std::optional<std::string> scope{};     ///< empty: all hosts again
  std::optional<std::string> for_whom{};  ///< empty: no condition
  friend bool operator==(const PublicationChange&, const PublicationChange&) = default;
};

/// A change of a subscription; a field that is not given stays.
struct SubscriptionChange {
  std::optional<IdentityChange> identity;
  std::optional<ChannelMode> mode;
  std::optional<Degree> weakest;
  std::optional<std::vector<ProviderFilter>> providers;  ///< empty: any provider again
  std::optional<std::string> where;                      ///< empty: no filter
  std::optional<std::uint32_t> limit;
  std::optional<std::int32_t> priority;
  std::optional<std::uint16_t> port;
  std::optional<std::string> address;
  Attributes attributes;  ///< added to those that are there; one of the same key takes its place
  std::optional<std::vector<std::string>> protocols{};    ///< empty: any protocol again
  std::optional<std::vector<ProviderFilter>> favoured{};  ///< empty: none
  std::optional<std::string> prefer{};                    ///< empty: none
  std::optional<std::string> rank{};                      ///< empty: the usual order again
  std::optional<std::string> scope{};                     ///< empty: all hosts again
  std::optional<std::uint32_t> convert{};                 ///< 0: no conversions
  std::optional<std::string> on{};                        ///< empty: any participant again
  std::optional<RequiredReach> reach{};
  friend bool operator==(const SubscriptionChange&, const SubscriptionChange&) = default;
};

}  // namespace geminga

#endif
