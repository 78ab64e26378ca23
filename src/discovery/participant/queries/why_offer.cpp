// `query why` of an offer alone: who takes it, and why the others do not.
#include "discovery/participant/queries/why_offer.hpp"

#include <utility>

#include "discovery/participant/queries/arbitration.hpp"
#include "discovery/participant/queries/demand.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/mending.hpp"
#include "discovery/participant/queries/use.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;
using registry::SubscriptionEntry;

class OfferAnswer {
 public:
  OfferAnswer(matching::Matcher& matcher, const Overlaps& overlaps, const membership::NeighbourTable& neighbours,
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
      const auto* request = matcher_.find_subscription(list_[told_].key);
      if (request == nullptr) continue;
      auto check = checked(piece, *request, list_[told_]);
      if (!check) return false;
      tell(piece, *request, *check);
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
    for (const Misfit& one : demand_.misfits()) list_.push_back({.key = one.key, .misfit = one.finding.first()});
  }

  /// Nothing: all offers are being ranked, and it goes on.
  std::optional<Check> checked(Piece& piece, const SubscriptionEntry& request, const Entry& entry) {
    Offered offer = demand_.offer();
    offer.entry = demand_.offer_for(request);
    const Asked asked{.entry = request, .request = matcher_.prepare(request)};
    if (!entry.is_meeting) {
      Check check = misfit_of(matcher_, asked, offer.entry, entry.misfit);
      check.mend = mend_by_provider(matcher_, asked, offer.entry, check);
      return check;
    }
    if (entry.is_taken) {
      Check check = checks_of(matcher_, asked, offer.entry, Depth::search)[1];
      if (!check.proof.empty()) piece.look_at(cost_of_proof);
      return check;
    }
    if (!survey_) {
      const auto finding = matcher_.examine(asked.entry, *asked.request, offer.entry);
      if (!finding.match) return Check{.what = "arbitration", .obstacle = Obstacle::outranked, .text = "it has gone"};
      rank_ = rank_of(asked, offer, *finding.match);
      survey_.emplace(matcher_, overlaps_, asked, *rank_);
    }
    if (!survey_->proceed(piece)) return std::nullopt;
    Check check = check_arbitration(matcher_, *survey_, offer, *rank_);
    survey_.reset();
    if (!check.is_ok()) check.mend = mend_by_provider(matcher_, asked, offer.entry, check);
    return check;
  }

  void tell(Piece& piece, const SubscriptionEntry& request, const Check& check) const {
    Line line;
    append(line, "subscription", to_string(request.key));
    append(line, "consumer", peer_word(request.key));
    append_stated(line, "name", request.peer_name);
    append_stated(line, "participant_name", request.participant_name);
    append(line, "asked", words(matcher_.vocabulary(), request.subscription.identity));
    append(line, "mode", std::string(to_string(request.subscription.mode)));
    append_check(line, check);
    piece.tell(std::move(line));
  }

  [[nodiscard]] Line end(Piece& piece) const {
    Line line;
    const bool is_in_chain = Use().is_in_chain(matcher_, demand_.offer().entry);
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
  const membership::NeighbourTable& neighbours_;
  Demand demand_;
  bool is_walked_ = false;
  std::vector<Entry> list_;
  std::size_t told_ = 0;
  std::optional<Survey> survey_;  ///< for the one that is told next
  std::optional<matching::Rank> rank_;
  std::optional<Check> outranked_;  ///< of the first that has better ones
};

}  // namespace

Answering explaining(matching::Matcher& matcher, const Overlaps& overlaps, const membership::NeighbourTable& neighbours,
                     Offered offer) {
  return {.kind = "why", .proceed = OfferAnswer(matcher, overlaps, neighbours, std::move(offer))};
}

}  // namespace geminga::participant
