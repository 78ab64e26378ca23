#include "discovery/matching/degrees/representation.hpp"

#include <limits>

namespace geminga::matching {

std::optional<Match> degree_of_representation(const NamedClass& offered, const NamedClass& requested,
                                              const vocabulary::Vocabulary& vocabulary, std::uint32_t convert,
                                              const AskChain& chains) {
  if (requested.iri.empty()) return Match{Degree::exact, 0};
  if (offered.iri.empty()) return std::nullopt;
  const auto as_it_is = degree_of_name(offered, requested, vocabulary);
  const bool may_be_converted = convert != 0 && offered.number && requested.number;
  if (!may_be_converted || (as_it_is && is_weaker(Degree::converted, as_it_is->degree))) return as_it_is;
  const auto chain = chain_between(offered.number, requested.number, vocabulary, chains);
  if (chain == nullptr || chain->cost > convert) return as_it_is;
  return Match{Degree::converted, chain->distance, chain->cost, chain->mark};
}

std::shared_ptr<const vocabulary::Chain> chain_between(std::optional<taxonomy::ClassNumber> offered,
                                                       std::optional<taxonomy::ClassNumber> requested,
                                                       const vocabulary::Vocabulary& vocabulary,
                                                       const AskChain& chains) {
  if (!offered || !requested) return nullptr;
  return chains ? chains(*offered, *requested) : vocabulary.conversion(*offered, *requested);
}

std::string chain_words(const vocabulary::Chain* chain, const vocabulary::Vocabulary& vocabulary) {
  std::string words;
  if (chain == nullptr) return words;
  for (const taxonomy::ClassNumber number : chain->classes) {
    words += (words.empty() ? "" : ">") + vocabulary.short_name(number);
  }
  return words;
}

Match combined(const Match& one, const Match& other) {
  constexpr auto farthest = std::numeric_limits<std::uint32_t>::max();
  const bool fits = one.distance <= farthest - other.distance;
  const Match& converted = one.cost != 0 ? one : other;
  return {is_weaker(one.degree, other.degree) ? one.degree : other.degree,
          fits ? one.distance + other.distance : farthest, converted.cost, converted.chain};
}

}  // namespace geminga::matching
