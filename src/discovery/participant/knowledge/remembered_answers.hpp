// The reasoner's answers about pairs of an offered and a requested concept, by the ontology that gave them.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_REMEMBERED_ANSWERS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_REMEMBERED_ANSWERS_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "discovery/matching/degrees/degree.hpp"
#include "geminga/identity.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// Beyond `most` answers all about the least recently used request are forgotten. While one ontology takes the place of
/// another, both are at work, and the answers of both are kept.
template <typename Answer, std::size_t most>
class RememberedAnswers {
 public:
  using Answers = std::shared_ptr<const Answer>;

  /// The answer about a pair; null where it is not known.
  [[nodiscard]] Answers find(const vocabulary::Vocabulary& vocabulary, const matching::Meaning& offered,
                             const SemanticIdentity& requested) {
    Memory& memory = memory_of(vocabulary);
    const auto about = memory.by_request.find(requested.concept_iri);
    if (about == memory.by_request.end()) return nullptr;
    about->second.used = ++uses_;
    const auto found = about->second.by_offer.find(offer_of(offered));
    return found == about->second.by_offer.end() ? nullptr : found->second;
  }
  /// How many answers about a request are known.
  [[nodiscard]] std::size_t count(const vocabulary::Vocabulary& vocabulary, const SemanticIdentity& requested) {
    Memory& memory = memory_of(vocabulary);
    const auto about = memory.by_request.find(requested.concept_iri);
    return about == memory.by_request.end() ? 0 : about->second.by_offer.size();
  }
  /// Remembers an answer that is not known yet.
  void put(const vocabulary::Vocabulary& vocabulary, const matching::Meaning& offered,
           const SemanticIdentity& requested, Answers answer) {
    Memory& memory = memory_of(vocabulary);
    OfRequest& answers = memory.by_request[requested.concept_iri];
    answers.used = ++uses_;
    answers.by_offer.emplace(offer_of(offered), std::move(answer));
    if (++memory.size <= most) return;
    const auto oldest =
        std::ranges::min_element(memory.by_request, {}, [](const auto& entry) { return entry.second.used; });
    memory.size -= oldest->second.by_offer.size();
    memory.by_request.erase(oldest);
  }

 private:
  /// A class, or the text of an expression.
  using Offer = std::pair<std::uint32_t, std::string>;
  struct OfRequest {
    std::map<Offer, Answers> by_offer;
    std::uint64_t used = 0;
  };
  struct Memory {
    vocabulary::OntologyMark ontology;
    std::map<std::string, OfRequest, std::less<>> by_request;
    std::size_t size = 0;
  };

  [[nodiscard]] static Offer offer_of(const matching::Meaning& offered) {
    if (offered.classes.concept_class) return {std::to_underlying(*offered.classes.concept_class), ""};
    return {0, offered.identity.concept_iri};
  }
  [[nodiscard]] Memory& memory_of(const vocabulary::Vocabulary& vocabulary) {
    if (!memories_[last_].ontology.is_of(vocabulary)) {
      last_ = 1 - last_;
      if (!memories_[last_].ontology.is_of(vocabulary)) {
        memories_[last_] = {.ontology = vocabulary::OntologyMark(vocabulary), .by_request = {}, .size = 0};
      }
    }
    return memories_[last_];
  }

  std::array<Memory, 2> memories_;
  std::size_t last_ = 0;  ///< the memory that was asked last
  std::uint64_t uses_ = 0;
};

}  // namespace geminga::participant

#endif
