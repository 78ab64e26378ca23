// Which representation can be turned into which, over several declared conversions.
#ifndef GEMINGA_REASONING_VOCABULARY_CONVERSIONS_HPP
#define GEMINGA_REASONING_VOCABULARY_CONVERSIONS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/owl/conversion.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::vocabulary {

/// The most conversions in one chain.
inline constexpr std::size_t max_chain_conversions = 8;
/// The most that one can cost.
inline constexpr std::uint32_t max_chain_cost = max_chain_conversions * owl::max_conversion_cost;

/// One conversion after the other. What comes of one is below what the next one takes.
struct Chain {
  /// What the first conversion takes, then what comes of each.
  std::vector<taxonomy::ClassNumber> classes;
  std::uint32_t cost = 0;
  /// Taxonomy edges from what is offered up to what the first conversion takes, between conversions, and from what
  /// comes of the last up to what is asked for.
  std::uint32_t distance = 0;
  std::uint32_t mark = 0;  ///< different for chains over different classes, but for chance; equal on every host
};

/// The declared conversions of one ontology, without those of which a side can have no instance. Safe to use from many
/// threads.
class Conversions {
 public:
  /// How many answers are remembered. When there are more, all are forgotten.
  static constexpr std::size_t max_remembered = 4096;

  explicit Conversions(std::shared_ptr<const compiled::Ontology> ontology);

  /// The cheapest chain, up to its length, from something above `offered` to something below `requested`; of those the
  /// shortest, and of those the first by the classes. Null where there is none. Both must be satisfiable.
  [[nodiscard]] std::shared_ptr<const Chain> cheapest(taxonomy::ClassNumber offered,
                                                      taxonomy::ClassNumber requested) const;
  [[nodiscard]] std::size_t size() const { return conversions_.size(); }

 private:
  [[nodiscard]] std::shared_ptr<const Chain> search(taxonomy::ClassNumber offered,
                                                    taxonomy::ClassNumber requested) const;
  [[nodiscard]] Chain chain_of(const std::vector<std::uint32_t>& steps, taxonomy::ClassNumber offered,
                               taxonomy::ClassNumber requested) const;

  std::shared_ptr<const compiled::Ontology> ontology_;
  std::vector<taxonomy::Conversion> conversions_;
  std::vector<std::vector<std::uint32_t>> next_;  ///< of each conversion, those that take what comes of it
  mutable std::mutex mutex_;
  mutable std::map<std::pair<taxonomy::ClassNumber, taxonomy::ClassNumber>, std::shared_ptr<const Chain>> remembered_;
};

}  // namespace geminga::vocabulary

#endif
