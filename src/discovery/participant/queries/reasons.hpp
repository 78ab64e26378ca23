// The likely reason why nobody answers a request or takes an offer: what comes nearest to it on the other side, or a
// fault of its own.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_REASONS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_REASONS_HPP

#include <compare>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/membership/neighbours.hpp"
#include "discovery/participant/queries/checks.hpp"

namespace geminga::participant {

/// For a request in `requests unmatched=1`, offers that are looked at whose concept is above or below what it asks for.
/// They are enough to say what is wrong, and bound the cost of each request.
inline constexpr std::size_t max_examined_offers = 64;
/// Offers that are compared with a text that nobody offers, or searched for concepts that are unknown here where
/// another participant has another ontology.
inline constexpr std::size_t max_compared_offers = 256;
/// The same limits in `services unused=1`, for requests.
inline constexpr std::size_t max_examined_requests = 64;
inline constexpr std::size_t max_compared_requests = 256;
/// Representations that are named as offered instead of the one that is asked for.
inline constexpr std::size_t max_told_representations = 4;
/// The nearest services, or requests, that do not match and that `why` tells of.
inline constexpr std::size_t max_told_misfits = 4;
/// Unknown names of one answer for which similar names are searched; each search takes up to milliseconds.
inline constexpr std::size_t max_searched_names = 16;
/// The work of such a search, in entries.
inline constexpr std::size_t cost_of_searched_name = 160;

/// An offer that does not meet a request, or a request that is not met by an offer.
struct Misfit {
  ServiceKey key;
  matching::Finding finding;
  friend bool operator<(const Misfit& a, const Misfit& b) {
    const auto order = a.finding.remoteness() <=> b.finding.remoteness();
    return order == 0 ? a.key < b.key : order < 0;
  }
};

/// The nearest entries of the other side.
struct Nearest {
  /// The nearest of those whose concept fits at least, or whose text nearly; max_told_misfits at most.
  std::set<Misfit> misfits;
  std::optional<Misfit> misfit;
  std::vector<std::string> representations;  ///< IRIs of those there with a concept that fits, each once
  // Those whose concept the ontology here does not know: how many, and the first.
  std::size_t unknown_count = 0;
  std::optional<ServiceKey> unknown;
  /// Takes another one into account, with its identity, that does not fit.
  void consider(const ServiceKey& key, const Identity& identity, const matching::Finding& finding);
};

struct Reason {
  matching::Obstacle obstacle = matching::Obstacle::nobody;
  std::string text;
  std::string mend;
};

/// Appends `code text mend`.
void append_reason(Line& line, const Reason& reason);
/// Appends `why because`, the same in one sentence.
void append_because(Line& line, const Reason& reason);

/// Finds the reasons of one answer.
class Reasons {
 public:
  /// Borrows both for its life.
  Reasons(const matching::Matcher& matcher, const membership::Neighbours& neighbours)
      : matcher_(matcher), neighbours_(neighbours) {}

  /// From what is known already; the nearest offer may be gone since.
  [[nodiscard]] Reason of(Piece& piece, const Asked& asked, const Nearest& nearest);
  /// From a bounded look at what may come near, all in one piece. It counts as work, and towards the statements of the
  /// client no more than the request itself does.
  [[nodiscard]] Reason likely(Piece& piece, const registry::SubscriptionEntry& request);
  // The same why nobody takes an offer.
  [[nodiscard]] Reason of(Piece& piece, const registry::PublicationEntry& offer, const Nearest& nearest);
  [[nodiscard]] Reason likely(Piece& piece, const registry::PublicationEntry& offer);

 private:
  [[nodiscard]] std::optional<Reason> of_request(Piece& piece, const Asked& asked);
  [[nodiscard]] std::optional<Reason> of_offer(Piece& piece, const registry::PublicationEntry& offer);
  /// Of a name that somebody of this participant uses.
  [[nodiscard]] Reason of_unknown_name(Piece& piece, ParticipantId user, const std::string& iri,
                                       matching::Obstacle obstacle);

  [[nodiscard]] Reason of_nobody(const Asked& asked) const;
  [[nodiscard]] Reason of_nobody(const registry::PublicationEntry& offer) const;
  [[nodiscard]] std::optional<Reason> of_unknown_offers(const Asked& asked, const Nearest& nearest) const;
  [[nodiscard]] std::string beside_other_ontology(ParticipantId user) const;

  const matching::Matcher& matcher_;
  const membership::Neighbours& neighbours_;
  std::size_t searches_left_ = max_searched_names;
};

}  // namespace geminga::participant

#endif
