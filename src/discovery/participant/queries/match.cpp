// `query match`: the publications that meet an identity, best first.
#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "discovery/gcnp/attribute.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/matching/arbitration/rank.hpp"
#include "discovery/matching/degrees/representation.hpp"
#include "discovery/matching/meeting/request.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/checks.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/missing.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/ways.hpp"

namespace geminga::participant {
namespace {

/// Candidates of the index that are looked at alone. Where there are more, the whole registry is walked, which can be
/// interrupted.
constexpr std::size_t max_candidates = 256;

Line line_of(const Listed& by, const registry::PublicationEntry& entry, const matching::Match& match,
             const matching::Request& request) {
  Line line;
  append(line, "service", to_string(entry.key));
  append(line, "provider", peer_word(entry.key));
  append_stated(line, "name", entry.peer_name);
  gcnp::append_identity(line, named(by.matcher.editions().vocabulary(), entry.publication.identity));
  append(line, "degree", std::string(to_string(match.degree)));
  append(line, "distance", match.distance);
  append_channel(line, entry.publication);
  append(line, "age", age(by.matcher.publications(), by.neighbours, by.env.now(), entry));
  append_stated(line, "participant_name", entry.participant_name);
  const auto& vocabulary = by.matcher.editions().vocabulary();
  const auto classes = matching::classes_of(entry.publication.identity, vocabulary);
  const auto chain = match.cost == 0
                         ? nullptr
                         : matching::chain_between(classes.representation_class, request.classes.representation_class,
                                                   vocabulary, request.asks.chains);
  gcnp::append_attributes(line, matching::chain_words(chain.get(), vocabulary), match.cost, chain ? chain->via : "",
                          entry.publication.attributes);
  append_way(line, entry, by.neighbours);
  return line;
}

/// A service whose concept does not meet the request, and what it lacks.
struct Near {
  ServiceKey key;
  vocabulary::NearMisses near_misses;
};

Line line_of(const Listed& by, const registry::PublicationEntry& entry, const Near& near) {
  Line line;
  append(line, "service", to_string(entry.key));
  append(line, "provider", peer_word(entry.key));
  append_stated(line, "name", entry.peer_name);
  gcnp::append_identity(line, named(by.matcher.editions().vocabulary(), entry.publication.identity));
  append_channel(line, entry.publication);
  append(line, "age", age(by.matcher.publications(), by.neighbours, by.env.now(), entry));
  append_stated(line, "participant_name", entry.participant_name);
  append_missing(line, near.near_misses);
  return line;
}

/// Makes the lines of an answer; nothing for an entry that is not to be told of.
struct Lines {
  std::function<std::optional<Line>(const registry::PublicationEntry& entry, const matching::Match& match,
                                    const matching::Request& request)>
      of_match;
  std::function<std::optional<Line>(const registry::PublicationEntry& entry, const Near& near)> of_near;
};

/// Looks at all publications that may meet the request, ranks those that do, and tells them in that order.
class Ranking {
 public:
  Ranking(const Listed& by, const Overlaps& overlaps, const Self& self, const gcnp::QueryMatch& query,
          Subscription asked, Lines lines)
      : by_(by),
        lines_(std::move(lines)),
        overlaps_(overlaps),
        asked_{.key = {.participant = self.id, .peer = {}},
               .subscription = std::move(asked),
               .peer_name = {},
               .participant_name = self.name(),
               .is_local = true,
               .updated = {}},
        request_(by.matcher.examination().prepare(asked_)),
        is_any_identity_(!query.identity),
        mode_(query.mode),
        limit_(query.limit),
        is_missing_wanted_(query.missing) {
    // Each may be a question to the reasoner: then all are walked, a few at a time.
    if (!is_any_identity_ && asked_.subscription.weakest != Degree::overlapping && !is_missing_wanted_)
      candidates_ = by.matcher.search().candidates(asked_.subscription, *request_, max_candidates);
    const auto is_question = [&](const ServiceKey& key) {
      const auto* entry = by.matcher.publications().find_entry(key);
      return entry != nullptr && has_expression(entry->publication.identity);
    };
    const bool may_ask = (request_->on && request_->on->compares) ||
                         (request_->asks.compares && candidates_ && std::ranges::any_of(*candidates_, is_question));
    if (may_ask) candidates_.reset();
  }

  bool operator()(Piece& piece) {
    if (!is_ranked_ && !look(piece)) return false;
    while (next_ < found_.size() && !piece.is_full()) {
      const matching::Rank& one = found_[next_++];
      if (const auto* entry = by_.matcher.publications().find_entry(one.key)) {
        if (auto line = lines_.of_match(*entry, one.match, *request_)) piece.tell(std::move(*line));
      }
    }
    if (next_ < found_.size()) return false;
    if (is_missing_wanted_ && !tell_near(piece)) return false;
    Line end;
    if (compared_ < near_.size()) append(end, "uncompared", near_.size() - compared_);
    append_stated(end, "gaps", matching::gap_words(request_->classes));
    piece.conclude(std::move(end));
    return true;
  }

 private:
  /// Whether all have been looked at.
  bool look(Piece& piece) {
    const auto judge_one = [&](const registry::PublicationEntry& entry) {
      const std::uint64_t postponed = overlaps_.counts().postponed;
      piece.look_at_one();
      judge(entry);
      if (overlaps_.counts().postponed != postponed) return false;  // it is the first of the next piece
      last_ = entry.key;
      return !piece.is_full();
    };
    if (candidates_) {
      for (const ServiceKey& key : *candidates_) {
        if (const auto* entry = by_.matcher.publications().find_entry(key)) judge_one(*entry);
      }
    } else {
      const auto judge_stored = [&](const registry::StoredPublication& stored) { return judge_one(stored.entry); };
      if (!by_.matcher.publications().visit_after(last_, judge_stored)) return false;
    }
    std::ranges::sort(found_, matching::BestFirst{});
    if (limit_ != 0 && found_.size() > limit_) found_.resize(limit_);
    is_ranked_ = true;
    return true;
  }

  void judge(const registry::PublicationEntry& entry) {
    const ChannelMode mode = entry.publication.mode;
    if (mode_ ? *mode_ != mode : mode == ChannelMode::participant) return;
    asked_.subscription.mode = entry.publication.mode;
    // Without an identity each is asked for by its own, so that the rest of the request decides.
    if (is_any_identity_) asked_.subscription.identity = entry.publication.identity;
    if (const auto match = by_.matcher.examination().meets(asked_, *request_, entry)) {
      found_.push_back({entry.publication.priority, *match, entry.key});
    } else if (is_missing_wanted_) {
      const auto* offered = std::get_if<SemanticIdentity>(&entry.publication.identity);
      if (offered != nullptr) near_[offered->concept_iri].push_back(entry.key);
    }
  }

  /// Whether all that come near have been told, those that lack least first. One concept is compared in a piece.
  bool tell_near(Piece& piece) {
    for (; compared_ < std::min(near_.size(), max_missing_concepts); ++compared_) {
      if (piece.is_full()) return false;
      piece.look_at(cost_of_proof);
      const auto at = std::next(near_.begin(), static_cast<std::ptrdiff_t>(compared_));
      auto found = missing_between(by_.matcher.editions().vocabulary(), asked_.subscription.identity,
                                   SemanticIdentity{at->first, ""});
      if (!found || found->ranked.empty() || is_met(found->ranked.front())) continue;
      for (const ServiceKey& key : at->second) ranked_near_.push_back({.key = key, .near_misses = *found});
    }
    if (!is_near_ranked_) {
      std::ranges::sort(ranked_near_, {}, [](const Near& one) {
        const auto& way = one.near_misses.ranked.front();
        return std::tuple(way.contradicting_count, way.lacking_count, one.key);
      });
      const std::size_t most = limit_ == 0 ? max_told_missing : limit_;
      if (ranked_near_.size() > most) ranked_near_.resize(most);
      is_near_ranked_ = true;
    }
    for (; told_near_ < ranked_near_.size(); ++told_near_) {
      if (piece.is_full()) return false;
      const Near& one = ranked_near_[told_near_];
      if (const auto* entry = by_.matcher.publications().find_entry(one.key)) {
        if (auto line = lines_.of_near(*entry, one)) piece.tell(std::move(*line));
      }
    }
    return true;
  }

  /// Whether the concept is what is asked for, so that something else is in the way: geminga-query why says what.
  static bool is_met(const vocabulary::NearMiss& way) { return way.contradicting_count + way.lacking_count == 0; }

  Listed by_;
  Lines lines_;
  const Overlaps& overlaps_;
  registry::SubscriptionEntry asked_;  ///< as of a peer of this host that has no name
  std::shared_ptr<const matching::Request> request_;
  bool is_any_identity_;
  std::optional<ChannelMode> mode_;
  std::uint32_t limit_;
  std::optional<std::vector<ServiceKey>> candidates_;
  std::optional<ServiceKey> last_;
  std::vector<matching::Rank> found_;  ///< each meets the request; it may be gone when it is told
  bool is_ranked_ = false;
  std::size_t next_ = 0;
  bool is_missing_wanted_;
  std::map<std::string, std::vector<ServiceKey>> near_;  ///< those that do not meet it, by concept
  std::size_t compared_ = 0;                             ///< of these
  std::vector<Near> ranked_near_;
  bool is_near_ranked_ = false;
  std::size_t told_near_ = 0;
};

/// The subscription that the query stands for, without a mode.
std::expected<Subscription, Error> asked_of(const Listed& by, const gcnp::QueryMatch& query) {
  if (!query.where.empty()) {
    if (auto error = matching::check_where(query.where, "where", by.matcher.editions().vocabulary().units()))
      return std::unexpected(std::move(*error));
  }
  Subscription asked;
  asked.weakest = query.weakest;
  asked.providers = query.providers;
  asked.where = query.where;
  asked.convert = query.convert;
  asked.reach = RequiredReach::any;  // what cannot be reached is listed, and marked
  if (!query.on.empty()) {
    auto on = by.resolver.resolve_on(query.on);
    if (!on) return std::unexpected(on.error());
    asked.on = std::move(*on);
  }
  if (query.identity) {
    auto identity = by.resolver.resolve(*query.identity);
    if (!identity) return std::unexpected(identity.error());
    asked.identity = std::move(*identity);
    if (query.missing) {
      if (const auto ready = by.resolver.require_expressions(); !ready) return std::unexpected(ready.error());
    }
  }
  return asked;
}

}  // namespace

std::expected<Answering, Error> begin_match(const Listed& by, const Overlaps& overlaps, const Self& self,
                                            const gcnp::QueryMatch& query) {
  auto asked = asked_of(by, query);
  if (!asked) return std::unexpected(std::move(asked.error()));
  Lines lines{.of_match = [by](const auto& entry, const auto& match,
                               const auto& request) { return std::optional(line_of(by, entry, match, request)); },
              .of_near = [by](const auto& entry, const auto& near) { return std::optional(line_of(by, entry, near)); }};
  return Answering{.kind = "match", .proceed = Ranking(by, overlaps, self, query, std::move(*asked), std::move(lines))};
}

std::expected<Answering, Error> begin_participants(const Listed& by, const Overlaps& overlaps, const Self& self,
                                                   const gcnp::QueryParticipants& query,
                                                   std::function<std::optional<Line>(ParticipantId)> line_of) {
  const gcnp::QueryMatch match{.identity = ConceptNames{query.concept_name, {}},
                               .weakest = query.weakest,
                               .mode = ChannelMode::participant,
                               .providers = query.providers,
                               .where = query.where,
                               .limit = query.limit,
                               .missing = query.missing};
  auto asked = asked_of(by, match);
  if (!asked) return std::unexpected(std::move(asked.error()));
  const auto append_own = [](Line& line, const registry::PublicationEntry& entry) {
    for (const auto& [name, value] : entry.publication.attributes)
      append(line, std::string(attribute_prefix) + name, value);
  };
  Lines lines;
  lines.of_match = [line_of, append_own](const registry::PublicationEntry& entry, const matching::Match& found,
                                         const matching::Request&) {
    auto line = line_of(entry.key.participant);
    if (!line) return line;
    append(*line, "degree", std::string(to_string(found.degree)));
    append(*line, "distance", found.distance);
    append_own(*line, entry);
    return line;
  };
  lines.of_near = [line_of = std::move(line_of), append_own](const registry::PublicationEntry& entry, const Near& one) {
    auto line = line_of(entry.key.participant);
    if (!line) return line;
    append_missing(*line, one.near_misses);
    append_own(*line, entry);
    return line;
  };
  return Answering{.kind = "participants",
                   .proceed = Ranking(by, overlaps, self, match, std::move(*asked), std::move(lines))};
}

}  // namespace geminga::participant
