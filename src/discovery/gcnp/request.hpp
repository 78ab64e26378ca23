// The requests of a client, read from statements: every key is checked, names are not resolved yet
// (src/discovery/gcnp/GCNP.md).
#ifndef GEMINGA_DISCOVERY_GCNP_REQUEST_HPP
#define GEMINGA_DISCOVERY_GCNP_REQUEST_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "geminga/error.hpp"
#include "geminga/match.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::gcnp {

/// `0 sys hello [name=NAME] [room=N] [keys=yes|no]`. Name and room are checked by the participant.
struct Hello {
  std::optional<std::string> name;
  std::optional<std::uint32_t> room{};  ///< how many subscriptions for `otm/stream` the client needs
  std::optional<bool> keys{};           ///< whether the client asks for the keys of its channels
  friend bool operator==(const Hello&, const Hello&) = default;
};
/// `0 sys ping`
struct Ping {
  friend bool operator==(const Ping&, const Ping&) = default;
};
/// `0 sys bye`
struct Bye {
  friend bool operator==(const Bye&, const Bye&) = default;
};

/// `0 sys describe [concept=C] [ATTRIBUTES]`: what this participant is. Attributes are added to those that there are.
struct Describe {
  std::optional<std::string> concept_name;  ///< nothing: it stays; empty: there is no description any more
  Attributes attributes;
  friend bool operator==(const Describe&, const Describe&) = default;
};

/// `N pub create ...`
struct PubCreate {
  NamedPublication publication;
  friend bool operator==(const PubCreate&, const PubCreate&) = default;
};
/// `N pub modify ...`
using PubModify = PublicationChange;
/// `N pub remove`
struct PubRemove {
  friend bool operator==(const PubRemove&, const PubRemove&) = default;
};

/// `N sub create ...`
struct SubCreate {
  NamedSubscription subscription;
  friend bool operator==(const SubCreate&, const SubCreate&) = default;
};
/// `N sub modify ...`
using SubModify = SubscriptionChange;
/// `N sub remove`
struct SubRemove {
  friend bool operator==(const SubRemove&, const SubRemove&) = default;
};

/// The filter of `services` and `requests`: everything given must hold.
struct ListFilter {
  std::optional<NamedIdentity> identity;
  std::optional<ChannelMode> mode;
  std::vector<ProviderFilter> providers;
  std::string text;        ///< `filter=TEXT`: occurs in a value of the line (matches_text())
  bool with_iris = false;  ///< names of concepts and representations are told as full IRIs
  friend bool operator==(const ListFilter&, const ListFilter&) = default;
};

/// The most names that an answer to `query concepts` has.
inline constexpr std::uint32_t max_told_concepts = 1000;

/// The most classes that an answer to `query taxonomy` has.
inline constexpr std::uint32_t max_told_classes = 500;

/// The prefix of the keys of an assumed service in `query why`.
inline constexpr std::string_view offer_prefix = "offer.";

/// `N query KIND ...`; the answers are specified in src/discovery/participant/QUERIES.md.
struct QueryParticipants {
  std::string concept_name;  ///< a class or an expression: only those that it describes; empty: all
  Degree weakest = Degree::narrower;
  std::vector<ProviderFilter> providers;
  std::string where;        ///< about the attributes of the description
  std::uint32_t limit = 0;  ///< the best so many; 0: all
  bool missing = false;     ///< also those that come near, with what they lack
  friend bool operator==(const QueryParticipants&, const QueryParticipants&) = default;
};
struct QueryServices {
  ListFilter filter;
  bool unused = false;  ///< only those that nobody asks for
  friend bool operator==(const QueryServices&, const QueryServices&) = default;
};
struct QueryRequests {
  ListFilter filter;
  bool unmatched = false;  ///< only those that nobody serves
  bool unused = false;     ///< answered as `services unused=1`
  friend bool operator==(const QueryRequests&, const QueryRequests&) = default;
};
struct QueryMatch {
  std::optional<NamedIdentity> identity;  ///< nothing: every publication
  Degree weakest = Degree::narrower;
  std::optional<ChannelMode> mode;
  std::vector<ProviderFilter> providers;
  std::string where;
  std::string on{};           ///< the description that the participant of a service must meet; empty: any
  std::uint32_t limit = 0;    ///< 0: all
  std::uint32_t convert = 0;  ///< the largest cost of conversions that counts
  bool missing = false;       ///< also those that come near, with what is missing; then there is a concept
  friend bool operator==(const QueryMatch&, const QueryMatch&) = default;
};
struct QueryExplain {
  std::string sub;
  std::string super;
  friend bool operator==(const QueryExplain&, const QueryExplain&) = default;
};
/// An assumed request: what it would be given. Its keys are those of `sub create`.
struct HypotheticalRequest {
  NamedSubscription subscription;
  bool is_any_mode = false;  ///< no mode was stated: it takes each offer's own
  friend bool operator==(const HypotheticalRequest&, const HypotheticalRequest&) = default;
};
/// An assumed service: what would take it. Its keys are those of `pub create` behind `offer.`.
struct HypotheticalOffer {
  NamedPublication publication;
  bool is_any_mode =
      false;  ///< no mode was stated: it has that of the request, or that of each request if none is given
  ProviderFilter provider;  ///< its provider; empty: a peer of this participant
  friend bool operator==(const HypotheticalOffer&, const HypotheticalOffer&) = default;
};
/// Why a request and an offer meet or do not. Without an offer: why nobody answers the request, or who does. Without a
/// request: why nobody takes the offer, or who does. At least one is present.
struct QueryWhy {
  std::variant<std::monostate, ServiceKey, HypotheticalRequest> request;
  std::variant<std::monostate, ServiceKey, HypotheticalOffer> offer;
  friend bool operator==(const QueryWhy&, const QueryWhy&) = default;
};
/// The names of classes that begin with a text.
struct QueryConcepts {
  std::string begin;
  std::uint32_t limit = max_told_concepts;  ///< 0 and more than that: that many
  friend bool operator==(const QueryConcepts&, const QueryConcepts&) = default;
};
/// The classes right below one, or those whose names a text occurs in.
struct QueryTaxonomy {
  std::string class_name;  ///< empty: owl:Thing
  std::string contains;    ///< empty: those right below the class
  std::uint32_t skip = 0;
  std::uint32_t limit = max_told_classes;  ///< 0 and more than that: that many
  friend bool operator==(const QueryTaxonomy&, const QueryTaxonomy&) = default;
};
struct QueryOntology {
  friend bool operator==(const QueryOntology&, const QueryOntology&) = default;
};
struct QueryStatus {
  friend bool operator==(const QueryStatus&, const QueryStatus&) = default;
};
struct QueryInterfaces {
  friend bool operator==(const QueryInterfaces&, const QueryInterfaces&) = default;
};
struct QueryPeers {
  friend bool operator==(const QueryPeers&, const QueryPeers&) = default;
};
/// The view of another participant: whom it hears, and how it is.
struct QueryDiagnosis {
  std::string participant;  ///< its identifier, or its name
  friend bool operator==(const QueryDiagnosis&, const QueryDiagnosis&) = default;
};
/// Asks who hears whom, by what each participant says of it.
struct QueryHearing {
  friend bool operator==(const QueryHearing&, const QueryHearing&) = default;
};
struct QuerySecurity {
  friend bool operator==(const QuerySecurity&, const QuerySecurity&) = default;
};

/// Everything that a client may ask. The statement's id goes beside it.
using Request = std::variant<Hello, Ping, Bye, Describe, PubCreate, PubModify, PubRemove, SubCreate, SubModify,
                             SubRemove, QueryParticipants, QueryServices, QueryRequests, QueryMatch, QueryExplain,
                             QueryWhy, QueryOntology, QueryStatus, QueryInterfaces, QueryPeers, QuerySecurity,
                             QueryConcepts, QueryDiagnosis, QueryTaxonomy, QueryHearing>;

/// The request of a statement. Errors: 400 for an unknown command, a missing, doubled or unreadable key, a reserved key
/// where it means nothing, or an id that the command may not have (0 except for sys, and any other for sys); 413 for a
/// value over its limit; 422 for an address that is no IP address. The participant checks whether the id is in use.
[[nodiscard]] std::expected<Request, Error> read_request(const Statement& statement);

/// The statement of a request, as a client sends it; read_request() is the inverse.
[[nodiscard]] Statement to_statement(std::uint32_t id, const Request& request);

/// The publication with its identity resolved.
[[nodiscard]] Publication with_identity(const NamedPublication& named, Identity identity);
/// The subscription with its identity resolved. A limit that is not stated becomes 1 for `oto` and 0 (all) otherwise.
[[nodiscard]] Subscription with_identity(const NamedSubscription& named, Identity identity);

/// Changes everything but the identity, which the participant resolves.
void apply(const PubModify& change, Publication& publication);
void apply(const SubModify& change, Subscription& subscription);

/// Whether a line of an answer has a value in which `text` occurs, octet by octet; an empty text always does.
[[nodiscard]] bool matches_text(const Statement& line, std::string_view text);

}  // namespace geminga::gcnp

#endif
