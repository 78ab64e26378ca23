#include "discovery/participant/queries/arbitration.hpp"

#include <algorithm>
#include <iterator>

#include "discovery/matching/interest.hpp"
#include "discovery/matching/standing.hpp"
#include "discovery/participant/queries/lines.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;
using matching::Standing;
using registry::PublicationEntry;

/// The place of an offer among all that meet a request, from 1.
struct RankWords {
  std::size_t place = 0;
  std::size_t candidates = 0;
  std::uint32_t limit = 0;
  std::size_t settled = 0;  ///< its place where those that were there first and rank behind it keep theirs
  [[nodiscard]] std::string text() const {
    return "it ranks " + std::to_string(place) + " of " + std::to_string(candidates) +
           (settled > place ? ", and " + std::to_string(settled) + " behind those that were there first" : "") +
           (limit == 0 ? ", and there is no limit" : ", the limit is " + std::to_string(limit));
  }
};

std::string mend_of(std::size_t place) {
  return "ask with a limit of at least " + std::to_string(place) +
         ", or with favour, prefer or rank so that it is ahead";
}

/// The number of chosen offers that rank behind this rank and keep their places against it.
std::size_t kept_behind(const matching::Matcher& matcher, const Asked& asked, const matching::Rank& rank) {
  auto chosen = asked.entry.subscription.chosen;
  if (chosen.empty()) chosen = matcher.choices().chosen(asked.entry.key);
  return static_cast<std::size_t>(std::ranges::count_if(chosen, [&](const ServiceKey& key) {
    const auto* incumbent = matcher.publications().find_entry(key);
    const auto match =
        incumbent == nullptr ? std::nullopt : matcher.examination().meets(asked.entry, *asked.request, *incumbent);
    return match && matching::BestFirst{}(rank, asked.request->rank(*incumbent, *match));
  }));
}

/// The match by identity; the rest of an offer that meets the request does not matter here.
std::optional<matching::Match> match_of(const matching::Matcher& matcher, const Asked& asked,
                                        const PublicationEntry& offer) {
  return matcher.examination().examine(asked.entry, *asked.request, offer).match;
}

/// The criterion by which the rival is ahead; empty where it is the key alone.
std::string lead_of(const matching::Matcher& matcher, const Asked& asked, const PublicationEntry& rival,
                    const PublicationEntry& offer) {
  const auto better = match_of(matcher, asked, rival);
  const auto worse = match_of(matcher, asked, offer);
  if (!better || !worse) return "";
  return asked.request->preferences.lead(rival, *better, offer, *worse);
}

Check refused(Obstacle obstacle, std::string text, std::size_t place) {
  return {"arbitration", obstacle, std::move(text), mend_of(place)};
}

Check outranked_known(const matching::Matcher& matcher, const Asked& asked, const PublicationEntry& offer,
                      const Standing& standing, std::size_t place, std::string text) {
  const bool is_by_consumer = standing.decided == Standing::Decided::by_consumer;
  if (standing.rival == nullptr) {
    text += is_by_consumer ? ": the consumer's host has chosen another" : ": it is not used";
    return refused(Obstacle::outranked, std::move(text), place);
  }
  text += ": outranked by " + to_string(standing.rival->key);
  if (is_by_consumer) {
    return refused(Obstacle::outranked, text + ", which the consumer's host has chosen", place);
  }
  if (standing.decided == Standing::Decided::by_incumbent && !asked.entry.subscription.prefer.empty()) {
    text += ", which was there first, and it is not better by as much as prefer asks for";
    return refused(Obstacle::incumbent, std::move(text), place);
  }
  if (const std::string lead = lead_of(matcher, asked, *standing.rival, offer); !lead.empty()) {
    return refused(Obstacle::outranked, text.append(", ").append(lead), place);
  }
  if (standing.decided == Standing::Decided::elsewhere) {
    text += ", which is no better: the consumer's host keeps whichever was there first";
  } else if (standing.decided == Standing::Decided::by_incumbent || standing.rival->key > offer.key) {
    text += ", which was there first and is no worse";
  } else {
    text += ", which is as good and was there first or has the smaller key";
  }
  return refused(Obstacle::incumbent, std::move(text), place);
}

/// A newcomer against what a consumer has already: it must be better than the last of these.
Check against_incumbent(const matching::Matcher& matcher, const Asked& asked, const PublicationEntry& offer,
                        const matching::Rank& rank, const PublicationEntry& incumbent, RankWords words_of_rank) {
  const auto match = match_of(matcher, asked, incumbent);
  const auto& preferences = asked.request->preferences;
  if (!match) return {"arbitration", Obstacle::none, words_of_rank.text()};
  const matching::Rank other = asked.request->rank(incumbent, *match);
  if (matching::is_better_by(preferences.margins(), rank, other)) {
    return {"arbitration", Obstacle::none,
            words_of_rank.text() + ": it takes the place of " + to_string(incumbent.key)};
  }
  const std::size_t place = words_of_rank.place + kept_behind(matcher, asked, rank);
  words_of_rank.settled = place;
  std::string text = words_of_rank.text() + ": outranked by " + to_string(incumbent.key);
  if (matching::is_strictly_better(rank, other)) {
    text += ", which was there first, and it is not better by as much as prefer asks for";
    return refused(Obstacle::incumbent, std::move(text), place);
  }
  const std::string lead = preferences.lead(incumbent, *match, offer, rank.match);
  if (!lead.empty()) return refused(Obstacle::outranked, text.append(", ").append(lead), place);
  return refused(Obstacle::incumbent, text + ", which was there first and is no worse", place);
}

/// A pair that the matcher knows.
Check check_known(const matching::Matcher& matcher, const Asked& asked, const PublicationEntry& offer,
                  const Standing& standing, const matching::Rank& rank) {
  RankWords words_of_rank{
      .place = standing.rank, .candidates = standing.candidates, .limit = asked.entry.subscription.limit};
  if (words_of_rank.limit == 0) return {"arbitration", Obstacle::none, words_of_rank.text()};
  if (!standing.is_chosen) {
    words_of_rank.settled = words_of_rank.place + kept_behind(matcher, asked, rank);
    return outranked_known(matcher, asked, offer, standing, words_of_rank.settled, words_of_rank.text());
  }
  std::string text = words_of_rank.text();
  if (standing.decided == Standing::Decided::by_incumbent) {
    text += ": it was there first, and none of those ahead of it is better ";
    text += asked.entry.subscription.prefer.empty() ? "but for its key" : "by as much as prefer asks for";
  }
  return {"arbitration", Obstacle::none, std::move(text)};
}

/// A pair of which at least one side is stated by nobody.
Check check_imagined(const matching::Matcher& matcher, const Survey& survey, const PublicationEntry& offer,
                     const matching::Rank& rank, bool is_offer_living) {
  const Asked& asked = survey.asked();
  const std::uint32_t limit = asked.entry.subscription.limit;
  const std::size_t place = survey.ahead() + 1;
  const std::size_t candidates = survey.matching() + (is_offer_living ? 0 : 1);
  const RankWords words_of_rank{.place = place, .candidates = candidates, .limit = limit};
  if (limit == 0) return {"arbitration", Obstacle::none, words_of_rank.text()};
  const auto chosen = asked.is_living ? matcher.choices().chosen(asked.entry.key) : std::vector<ServiceKey>();
  if (!chosen.empty() && chosen.size() >= limit) {
    const auto* incumbent = matcher.publications().find_entry(chosen.back());
    if (incumbent != nullptr) {
      return against_incumbent(matcher, asked, offer, rank, *incumbent, words_of_rank);
    }
  }
  if (place <= limit) return {"arbitration", Obstacle::none, words_of_rank.text()};
  const auto at = std::next(survey.best().begin(),
                            static_cast<std::ptrdiff_t>(std::min<std::size_t>(limit, survey.best().size()) - 1));
  return outranked(matcher, asked, offer, {.place = place, .settled = place, .candidates = candidates},
                   matcher.publications().find_entry(at->key));
}

}  // namespace

Check check_arbitration(matching::Matcher& matcher, const Survey& survey, const Offered& offer,
                        const matching::Rank& rank) {
  const Asked& asked = survey.asked();
  if (!asked.is_living || !offer.is_living) return check_imagined(matcher, survey, offer.entry, rank, offer.is_living);
  matching::Place place{.rank = survey.ahead() + 1, .candidates = survey.matching()};
  const std::size_t limit = matching::counted_limit(asked.entry);
  if (limit != 0 && place.rank > limit && limit <= survey.best().size()) {
    const auto last = std::next(survey.best().begin(), static_cast<std::ptrdiff_t>(limit) - 1);
    place.last = matcher.publications().find_entry(last->key);
  }
  matcher.vocabulary_change().catch_up(asked.entry.key);
  const auto standing = matcher.choices().standing(asked.entry.key, offer.entry.key, place);
  if (!standing) return {"arbitration", Obstacle::none, "one of them has gone"};
  return check_known(matcher, asked, offer.entry, *standing, rank);
}

Check outranked(const matching::Matcher& matcher, const Asked& asked, const PublicationEntry& offer,
                const Outranking& among, const PublicationEntry* rival) {
  const RankWords words_of_rank{.place = among.place,
                                .candidates = among.candidates,
                                .limit = asked.entry.subscription.limit,
                                .settled = among.settled};
  const std::size_t place = std::max(among.place, among.settled);
  std::string text = words_of_rank.text();
  if (rival == nullptr) return refused(Obstacle::outranked, text + ": it is not used", place);
  text += ": outranked by " + to_string(rival->key);
  const std::string lead = lead_of(matcher, asked, *rival, offer);
  if (!lead.empty()) return refused(Obstacle::outranked, text.append(", ").append(lead), place);
  if (among.settled <= among.place) {
    return refused(Obstacle::incumbent, text + ", which is as good and was there first or has the smaller key", place);
  }
  text += asked.entry.subscription.prefer.empty()
              ? ", which was there first and is no worse"
              : ", which was there first, and it is not better by as much as prefer asks for";
  return refused(Obstacle::incumbent, std::move(text), place);
}

}  // namespace geminga::participant
