// `query why` of a pair: what fits between them and what does not; of a request or an offer alone: why nobody answers
// or takes it, or who does.
#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include "discovery/matching/degrees/representation.hpp"
#include "discovery/participant/queries/arbitration.hpp"
#include "discovery/participant/queries/demand.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/mending.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/sides.hpp"
#include "discovery/participant/queries/survey.hpp"
#include "discovery/participant/queries/use.hpp"
#include "discovery/participant/queries/ways.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;
using registry::PublicationEntry;
using registry::SubscriptionEntry;

/// The line of a request or an offer that answers the other side or comes near: who it is, and how it fits.
template <typename Entry>
Line line_of_party(const Entry& party, gcnp::Parameter identity, ChannelMode mode, const Check& check,
                   const membership::Neighbours& neighbours) {
  Line line;
  append_party(line, party);
  line.push_back(std::move(identity));
  append(line, "mode", std::string(to_string(mode)));
  append_check(line, check);
  append_way(line, party, neighbours);
  return line;
}

/// One request and one offer, aspect by aspect.
class PairAnswer {
 public:
  PairAnswer(matching::Matcher& matcher, const Overlaps& overlaps, const membership::Neighbours& neighbours,
             Asked asked, Offered offer)
      : matcher_(matcher),
        overlaps_(overlaps),
        neighbours_(neighbours),
        asked_(std::move(asked)),
        offer_(std::move(offer)) {}

  bool operator()(Piece& piece) {
    if (checks_.empty()) begin(piece);
    if (survey_) {
      if (!survey_->proceed(piece)) return false;
      checks_.push_back(check_arbitration(matcher_, *survey_, offer_, *rank_));
      survey_.reset();
    }
    for (; told_ < checks_.size(); ++told_) {
      if (piece.is_full()) return false;
      Line line;
      append_check(line, checks_[told_]);
      piece.tell(std::move(line));
    }
    piece.conclude(end());
    return true;
  }

 private:
  void begin(Piece& piece) {
    checks_ = checks_of(matcher_, neighbours_, asked_, offer_.entry, Depth::search);
    if (std::ranges::any_of(checks_, [](const Check& one) { return one.missing || !one.proof.empty(); }))
      piece.look_at(cost_of_proof);
    const auto finding = matcher_.examination().examine(asked_.entry, *asked_.request, offer_.entry);
    match_ = finding.match;
    if (first_obstacle(checks_) != nullptr) return;
    if (!match_) return;  // cannot happen where all checks are ok
    rank_ = rank_of(asked_, offer_, *match_);
    survey_.emplace(matcher_, overlaps_, asked_, *rank_);
  }

  [[nodiscard]] Line end() const {
    const Check* obstacle = first_obstacle(checks_);
    const bool is_outranked = obstacle != nullptr && obstacle->what == "arbitration";
    Line line;
    append_flag(line, "matches", obstacle == nullptr);
    if (match_ && (obstacle == nullptr || is_outranked)) {
      append(line, "degree", std::string(to_string(match_->degree)));
      append(line, "distance", match_->distance);
      if (match_->cost != 0) {
        const auto chain = chain_of(matcher_.examination(), asked_, offer_.entry);
        append(line, "convert", matching::chain_words(chain.get(), matcher_.editions().vocabulary()));
        append(line, "cost", match_->cost);
        if (chain != nullptr) append_stated(line, "via", chain->via);
      }
    }
    if (is_outranked) append_flag(line, "outranked", true);
    if (obstacle != nullptr) append(line, "code", std::string(to_string(obstacle->obstacle)));
    append_way(line, offer_.entry, neighbours_);
    return line;
  }

  matching::Matcher& matcher_;
  const Overlaps& overlaps_;
  const membership::Neighbours& neighbours_;
  Asked asked_;
  Offered offer_;
  std::vector<Check> checks_;
  std::optional<matching::Match> match_;
  std::optional<matching::Rank> rank_;
  std::optional<Survey> survey_;
  std::size_t told_ = 0;
};

/// Everybody who answers a request or comes near.
class RequestAnswer {
 public:
  RequestAnswer(const matching::Matcher& matcher, const Overlaps& overlaps, const membership::Neighbours& neighbours,
                Asked asked)
      : matcher_(matcher), neighbours_(neighbours), survey_(matcher, overlaps, std::move(asked)) {}

  bool operator()(Piece& piece) {
    if (!is_surveyed_) {
      if (!survey_.proceed(piece)) return false;
      list();
      is_surveyed_ = true;
    }
    for (; told_ < list_.size(); ++told_) {
      if (piece.is_full()) return false;
      const auto* offer = matcher_.publications().find_entry(list_[told_].key);
      if (offer == nullptr) continue;
      const Check check = checked(piece, *offer, list_[told_]);
      const Publication& offered = offer->publication;
      piece.tell(line_of_party(*offer, {"offered", words(matcher_.editions().vocabulary(), offered.identity)},
                               offered.mode, check, neighbours_));
    }
    if (piece.is_full()) return false;
    piece.conclude(end(piece));
    return true;
  }

 private:
  struct Entry {
    ServiceKey key;
    bool is_chosen = false;
    std::size_t place = 0;    ///< in the ranking, from 1; 0: it does not meet, or is behind those that are kept
    std::size_t settled = 0;  ///< the same behind all that are chosen
    Obstacle misfit = Obstacle::none;
  };

  /// Lists the offers that it is given, then the outranked ones, then the nearest; the best few of each.
  void list() {
    std::vector<ServiceKey> ranked;
    for (const matching::Rank& rank : survey_.best()) ranked.push_back(rank.key);
    chosen_ = chosen_of(ranked);
    list_chosen(ranked);
    list_outranked(ranked);
    for (const Misfit& one : survey_.nearest().misfits)
      list_.push_back({.key = one.key, .misfit = one.finding.first()});
  }

  /// The choice of the consumer's host. For a request of nobody, or of a host that is not asked whom it has chosen: the
  /// best ones, as many as the request wants.
  [[nodiscard]] std::vector<ServiceKey> chosen_of(const std::vector<ServiceKey>& ranked) const {
    const Asked& asked = survey_.asked();
    std::vector<ServiceKey> chosen = asked.entry.subscription.chosen;  // as the consumer's host has announced
    if (chosen.empty() && asked.is_living) chosen = matcher_.choices().chosen(asked.entry.key);
    if (!chosen.empty()) return chosen;
    const std::size_t limit = asked.entry.subscription.limit;
    const std::size_t count = limit == 0 ? ranked.size() : std::min(limit, ranked.size());
    return {ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(count)};
  }

  void list_chosen(const std::vector<ServiceKey>& ranked) {
    for (const ServiceKey& key : chosen_) {
      if (list_.size() == max_told_matches) return;
      const auto at = std::ranges::find(ranked, key);
      const std::size_t place = at == ranked.end() ? 0 : static_cast<std::size_t>(at - ranked.begin()) + 1;
      list_.push_back({.key = key, .is_chosen = true, .place = place});
    }
  }

  void list_outranked(const std::vector<ServiceKey>& ranked) {
    const std::set<ServiceKey> chosen(chosen_.begin(), chosen_.end());
    std::size_t listed = 0;
    for (std::size_t i = 0; i < ranked.size() && listed < max_told_matches; ++i) {
      if (chosen.contains(ranked[i])) continue;
      list_.push_back({.key = ranked[i], .place = i + 1, .settled = std::max(i, chosen.size() + listed) + 1});
      ++listed;
    }
  }

  [[nodiscard]] Check checked(Piece& piece, const PublicationEntry& offer, const Entry& entry) const {
    const Asked& asked = survey_.asked();
    if (entry.misfit != Obstacle::none) return misfit_of(matcher_, neighbours_, asked, offer, entry.misfit);
    if (entry.is_chosen) {
      Check check = checks_of(matcher_, neighbours_, asked, offer, Depth::search)[1];
      if (!check.proof.empty()) piece.look_at(cost_of_proof);
      return check;
    }
    const auto* rival = chosen_.empty() ? nullptr : matcher_.publications().find_entry(chosen_.back());
    return outranked(matcher_, asked, offer,
                     {.place = entry.place, .settled = entry.settled, .candidates = survey_.matching()}, rival);
  }

  [[nodiscard]] Line end(Piece& piece) const {
    Line line;
    append_flag(line, "served", survey_.matching() > 0);
    append(line, "offers", survey_.seen());
    append(line, "matching", survey_.matching());
    const std::string gaps = matching::gap_words(survey_.asked().request->classes);
    if (survey_.matching() > 0) {
      append_stated(line, "gaps", gaps);
      return line;
    }
    const Reason reason = Reasons(matcher_, neighbours_).of(piece, survey_.asked(), survey_.nearest());
    append_reason(line, reason);
    append_stated(line, "gaps", gaps);
    return line;
  }

  const matching::Matcher& matcher_;
  const membership::Neighbours& neighbours_;
  Survey survey_;
  bool is_surveyed_ = false;
  std::vector<ServiceKey> chosen_;
  std::vector<Entry> list_;
  std::size_t told_ = 0;
};

/// Everybody who takes an offer, has better ones or comes near.
class OfferAnswer {
 public:
  OfferAnswer(matching::Matcher& matcher, const Overlaps& overlaps, const membership::Neighbours& neighbours,
              Offered offer)
      : matcher_(matcher), overlaps_(overlaps), neighbours_(neighbours), demand_(matcher, overlaps, std::move(offer)) {}

  bool operator()(Piece& piece) {
    if (!is_walked_) {
      if (!demand_.proceed(piece)) return false;
      list();
      is_walked_ = true;
    }
    for (; told_ < list_.size(); ++told_) {
      if (piece.is_full()) return false;
      const auto* request = matcher_.subscriptions().find_entry(list_[told_].key);
      if (request == nullptr) continue;
      auto check = checked(piece, *request, list_[told_]);
      if (!check) return false;
      const Subscription& asked = request->subscription;
      piece.tell(line_of_party(*request, {"asked", words(matcher_.editions().vocabulary(), asked.identity)}, asked.mode,
                               *check, neighbours_));
      if (list_[told_].is_meeting && !check->is_ok() && !outranked_) outranked_ = std::move(*check);
    }
    if (piece.is_full()) return false;
    piece.conclude(end(piece));
    return true;
  }

 private:
  struct Entry {
    ServiceKey key;
    bool is_meeting = false;
    bool is_taken = false;
    Obstacle misfit = Obstacle::none;
  };

  void list() {
    for (const ServiceKey& key : demand_.takers()) list_.push_back({.key = key, .is_meeting = true, .is_taken = true});
    for (const ServiceKey& key : demand_.others()) list_.push_back({.key = key, .is_meeting = true});
    for (const Misfit& one : demand_.nearest().misfits)
      list_.push_back({.key = one.key, .misfit = one.finding.first()});
  }

  /// Nothing while the offers are still being ranked.
  std::optional<Check> checked(Piece& piece, const SubscriptionEntry& request, const Entry& entry) {
    Offered offer = demand_.offer();
    offer.entry = demand_.offer_for(request);
    const Asked asked{.entry = request, .request = matcher_.examination().prepare(request)};
    if (!entry.is_meeting) {
      Check check = misfit_of(matcher_, neighbours_, asked, offer.entry, entry.misfit);
      check.mend = mend_by_provider(matcher_.examination(), asked, offer.entry, check);
      return check;
    }
    if (entry.is_taken) {
      Check check = checks_of(matcher_, neighbours_, asked, offer.entry, Depth::search)[1];
      if (!check.proof.empty()) piece.look_at(cost_of_proof);
      return check;
    }
    if (!survey_) {
      const auto finding = matcher_.examination().examine(asked.entry, *asked.request, offer.entry);
      if (!finding.match) return Check{.what = "arbitration", .obstacle = Obstacle::outranked, .text = "it has gone"};
      rank_ = rank_of(asked, offer, *finding.match);
      survey_.emplace(matcher_, overlaps_, asked, *rank_);
    }
    if (!survey_->proceed(piece)) return std::nullopt;
    Check check = check_arbitration(matcher_, *survey_, offer, *rank_);
    survey_.reset();
    if (!check.is_ok()) check.mend = mend_by_provider(matcher_.examination(), asked, offer.entry, check);
    return check;
  }

  [[nodiscard]] Line end(Piece& piece) const {
    Line line;
    const bool is_in_chain = Use().is_in_chain(matcher_.search(), demand_.offer().entry);
    append_flag(line, "used", demand_.matching() > 0 || is_in_chain);
    append(line, "requests", demand_.seen());
    append(line, "matching", demand_.matching());
    append(line, "taken", demand_.taken());
    if (demand_.taken() > 0) return line;
    if (demand_.matching() > 0) {
      if (!outranked_) return line;  // they have gone meanwhile
      append(line, "code", std::string(to_string(outranked_->obstacle)));
      append(line, "text", to_string(demand_.others().front()) + ": " + outranked_->text);
      append_stated(line, "mend", outranked_->mend);
      return line;
    }
    if (is_in_chain) {
      append(line, "text", "nobody asks for it, and what somebody else is given is converted by it");
      return line;
    }
    const Reason reason = Reasons(matcher_, neighbours_).of(piece, demand_.offer().entry, demand_.nearest());
    append_reason(line, reason);
    return line;
  }

  matching::Matcher& matcher_;
  const Overlaps& overlaps_;
  const membership::Neighbours& neighbours_;
  Demand demand_;
  bool is_walked_ = false;
  std::vector<Entry> list_;
  std::size_t told_ = 0;
  std::optional<Survey> survey_;  ///< for the one that is told next
  std::optional<matching::Rank> rank_;
  std::optional<Check> outranked_;  ///< of the first that has better ones
};

}  // namespace

std::expected<Answering, Error> begin_why(matching::Matcher& matcher, const Overlaps& overlaps,
                                          const membership::Neighbours& neighbours, const Stating& by,
                                          const gcnp::QueryWhy& query) {
  auto asked = asked_of(by, query);
  if (!asked) return std::unexpected(std::move(asked.error()));
  auto offered = offered_of(by, query, *asked);
  if (!offered) return std::unexpected(std::move(offered.error()));
  if (!*asked) {
    return Answering{.kind = "why", .proceed = OfferAnswer(matcher, overlaps, neighbours, std::move(**offered))};
  }
  if (!*offered)
    return Answering{.kind = "why", .proceed = RequestAnswer(matcher, overlaps, neighbours, std::move(**asked))};
  return Answering{.kind = "why",
                   .proceed = PairAnswer(matcher, overlaps, neighbours, std::move(**asked), std::move(**offered))};
}

}  // namespace geminga::participant
