#include "discovery/relaying/word_chain.hpp"

#include <algorithm>
#include <utility>

#include "discovery/keeping/frame.hpp"

namespace geminga::relaying {

using announcement::Kind;

bool WordChain::add(const WordPlace& place, HeardWord word) {
  if (place.kind == Kind::state) return add_state(place, std::move(word));
  return place.kind == Kind::change && add_change(place, std::move(word));
}

bool WordChain::add_state(const WordPlace& place, HeardWord word) {
  const bool is_other = places_.empty() || places_.front().boot != place.boot || tip() < place.revision;
  if (is_other) {
    words_.clear();
    places_.clear();
  } else if (places_.front().revision != place.revision || places_.front().link != place.link) {
    return false;  // an older one, or the same with the addresses of another link
  }
  const bool is_known = std::ranges::find(places_, place.part, &WordPlace::part) != places_.end();
  if (is_known || words_.size() == keeping::max_kept_words) return false;
  words_.push_back(std::move(word));
  places_.push_back(place);
  return true;
}

bool WordChain::add_change(const WordPlace& place, HeardWord word) {
  if (places_.empty() || places_.front().boot != place.boot || places_.front().link != place.link) return false;
  if (place.revision <= tip()) return false;
  // It contains all that has changed since then, so what was said in between need not be told.
  while (places_.back().kind == Kind::change && places_.back().revision > place.since) {
    places_.pop_back();
    words_.pop_back();
  }
  if (tip() < place.since || words_.size() == keeping::max_kept_words) return false;
  words_.push_back(std::move(word));
  places_.push_back(place);
  return true;
}

bool WordChain::leads_to(std::uint64_t revision) const {
  if (places_.empty() || tip() != revision) return false;
  const auto parts = std::ranges::count(places_, Kind::state, &WordPlace::kind);
  return std::cmp_equal(parts, places_.front().part_count);
}

}  // namespace geminga::relaying
