#include "discovery/matching/arbitration/preferences.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/text.hpp"
#include "discovery/matching/conditions/items.hpp"
#include "discovery/matching/conditions/number.hpp"
#include "discovery/matching/conditions/provider.hpp"
#include "discovery/matching/conditions/stated.hpp"
#include "geminga/attribute.hpp"

namespace geminga::matching {

using vocabulary::Units;

namespace {

using registry::PublicationEntry;

constexpr std::array<std::pair<std::string_view, Criterion>, criterion_count> criteria{
    {{"favour", Criterion::favour},
     {"priority", Criterion::priority},
     {"prefer", Criterion::prefer},
     {"degree", Criterion::degree},
     {"distance", Criterion::distance}}};

/// Takes the first word of a text, and the blanks behind it.
std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  text = base::trimmed(text.substr(word.size()));
  return word;
}

std::unexpected<Error> unreadable(std::string_view key, std::string_view item, std::string_view expected) {
  return std::unexpected(Error{ErrorCode::impossible, std::string(key) + ": " + base::printable(item, max_shown_item) +
                                                          " cannot be read: " + std::string(expected)});
}

std::expected<Wish, Error> read_wish(std::string_view item, const Units& declared) {
  constexpr std::string_view form = "write KEY asc or KEY desc, perhaps with by NUMBER [UNIT], e.g. rate desc by 5";
  std::string_view rest = item;
  Wish wish{.key = std::string(take_word(rest))};
  const std::string_view direction = take_word(rest);
  wish.is_descending = direction == "desc";
  const std::string_view name = std::string_view(wish.key).starts_with(attribute_prefix)
                                    ? std::string_view(wish.key).substr(attribute_prefix.size())
                                    : std::string_view(wish.key);
  if (!base::is_key(name) || (direction != "asc" && !wish.is_descending)) return unreadable("prefer", item, form);
  if (rest.empty()) return wish;
  if (take_word(rest) != "by") return unreadable("prefer", item, form);
  if (const auto bare = number(rest)) {
    wish.margin = *bare;
    wish.dimension = Dimension{};
  } else if (const auto stated = difference(rest, declared)) {
    wish.margin = stated->value;
    wish.dimension = stated->dimension;
  } else {
    return unreadable("prefer", item, form);
  }
  if (wish.margin < 0) return unreadable("prefer", item, "what is behind by is 0 or more");
  return wish;
}

/// The value of a publication under the key of a wish, in the base unit; nothing where it is no number, or of another
/// kind than the wish states.
std::optional<double> value_of(const Wish& wish, const PublicationEntry& publication, const Units& declared) {
  std::string room;
  const auto stated = Stated(publication).under(wish.key, room);
  if (!stated) return std::nullopt;
  Quantity value;
  if (const auto bare = number(*stated)) {
    value.value = *bare;
  } else if (const auto with_unit = quantity(*stated, declared)) {
    value = *with_unit;
    value.value = rounded(value.value);  // converting rounds, which must not make one value better than another
  } else {
    return std::nullopt;
  }
  if (wish.dimension && *wish.dimension != value.dimension) return std::nullopt;
  return value.value;
}

/// The number of a wish in a score, the lesser the better. A publication without a value is behind all that have one.
double score_of(const Wish& wish, const PublicationEntry& publication, const Units& declared) {
  const auto value = value_of(wish, publication, declared);
  if (!value) return std::numeric_limits<double>::infinity();
  return wish.is_descending ? -*value : *value;
}

std::string shown(const Wish& wish, const PublicationEntry& publication, const Units& declared) {
  std::string room;
  return value_of(wish, publication, declared)
             ? base::printable(Stated(publication).under(wish.key, room).value_or(""), max_shown_item)
             : "none";
}

}  // namespace

std::expected<Preferences, Error> Preferences::parse(const Subscription& subscription, const Units& declared) {
  Preferences preferences;
  preferences.favoured_ = subscription.favoured;
  if (subscription.prefer.ends_with(',')) {
    return unreadable("prefer", subscription.prefer, "nothing follows the last comma");
  }
  for (std::string_view rest = subscription.prefer; !rest.empty();) {
    if (preferences.wishes_.size() == max_wishes) {
      return unreadable("prefer", rest, "there are at most " + std::to_string(max_wishes) + " wishes");
    }
    auto wish = read_wish(take_item(rest), declared);
    if (!wish) return std::unexpected(std::move(wish.error()));
    preferences.wishes_.push_back(std::move(*wish));
    preferences.declared_ = declared;
  }
  if (subscription.rank.ends_with(',')) return unreadable("rank", subscription.rank, "nothing follows the last comma");
  std::size_t place = 0;
  for (std::string_view rest = subscription.rank; !rest.empty();) {
    const std::string_view word = take_item(rest);
    const auto named = std::ranges::find(criteria, word, &decltype(criteria)::value_type::first);
    const auto begin = preferences.order_.begin() + static_cast<std::ptrdiff_t>(place);
    // The criteria that are named already stand before `begin`.
    const auto at =
        named == criteria.end() ? preferences.order_.end() : std::find(begin, preferences.order_.end(), named->second);
    if (at == preferences.order_.end()) {
      return unreadable("rank", word, "favour, priority, prefer, degree, distance, each once at most, with commas");
    }
    std::rotate(begin, at, at + 1);
    ++place;
  }
  preferences.is_reordered_ = preferences.order_ != Preferences().order_;
  return preferences;
}

namespace {

/// The degree, and a fraction for the cost of converting: less than the difference between two degrees.
double weakness_and_cost(const Match& match) {
  constexpr double of_cost = 0x1p-24;
  static_assert(vocabulary::max_chain_cost * of_cost < 1);
  return weakness(match.degree) + match.cost * of_cost;
}

}  // namespace

double Preferences::favour(const PublicationEntry& publication) const {
  const auto at = std::ranges::find_if(favoured_, [&](const auto& provider) { return is_of(provider, publication); });
  return static_cast<double>(at - favoured_.begin());
}

Score Preferences::stated_score(const PublicationEntry& publication, const Match& match) const {
  Score score;
  score.reserve(criterion_count - 1 + wishes_.size());
  for (const Criterion criterion : order_) {
    switch (criterion) {
      case Criterion::favour:
        score.push_back(favour(publication));
        break;
      case Criterion::priority:
        score.push_back(-static_cast<double>(publication.publication.priority));
        break;
      case Criterion::prefer:
        for (const Wish& wish : wishes_) score.push_back(score_of(wish, publication, declared_));
        break;
      case Criterion::degree:
        score.push_back(weakness_and_cost(match));
        break;
      case Criterion::distance:
        score.push_back(match.distance);
        break;
    }
  }
  return score;
}

Score Preferences::margins() const {
  if (is_usual()) return {};
  Score margins;
  for (const Criterion criterion : order_) {
    if (criterion != Criterion::prefer) {
      margins.push_back(0);
      continue;
    }
    for (const Wish& wish : wishes_) margins.push_back(wish.margin);
  }
  return margins;
}

std::string Preferences::lead(const PublicationEntry& better, const Match& its_match, const PublicationEntry& worse,
                              const Match& others_match) const {
  for (const Criterion criterion : order_) {
    switch (criterion) {
      case Criterion::favour:
        if (favour(better) != favour(worse)) return "which is favoured";
        break;
      case Criterion::priority:
        if (better.publication.priority == worse.publication.priority) break;
        return "whose priority is " + std::to_string(better.publication.priority) + " against " +
               std::to_string(worse.publication.priority);
      case Criterion::prefer:
        for (const Wish& wish : wishes_) {
          if (score_of(wish, better, declared_) == score_of(wish, worse, declared_)) continue;
          return "whose " + base::printable(wish.key) + " is " + shown(wish, better, declared_) + " against " +
                 shown(wish, worse, declared_);
        }
        break;
      case Criterion::degree:
      case Criterion::distance:
        if (criterion == Criterion::degree ? weakness_and_cost(its_match) == weakness_and_cost(others_match)
                                           : its_match.distance == others_match.distance) {
          break;
        }
        return "which is " + std::string(to_string(its_match.degree)) + ", distance " +
               std::to_string(its_match.distance) +
               (its_match.cost == 0 ? "" : ", cost " + std::to_string(its_match.cost));
    }
  }
  return "";
}

std::optional<Error> check_preferences(const Subscription& subscription, const Units& declared) {
  const auto preferences = Preferences::parse(subscription, declared);
  return preferences ? std::nullopt : std::optional(preferences.error());
}

}  // namespace geminga::matching
