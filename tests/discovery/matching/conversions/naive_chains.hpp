// The best chain, found by trying all of them, as Converters and StepGraph must find it.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_CONVERSIONS_NAIVE_CHAINS_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_CONVERSIONS_NAIVE_CHAINS_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "discovery/matching/meeting/request.hpp"

namespace geminga::matching {

/// All conversions and converters for one consumer.
class NaiveChains {
 public:
  /// Publications with the order in which they came.
  using Offered = std::vector<std::pair<std::uint64_t, const registry::PublicationEntry*>>;

  NaiveChains(vocabulary::Vocabulary vocabulary, const registry::SubscriptionEntry& consumer, const Offered& offered);

  [[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain(vocabulary::ClassNumber offered,
                                                               vocabulary::ClassNumber requested);

 private:
  struct Way {
    vocabulary::Step step;
    std::uint64_t turn = 0;
    std::string via;  ///< "-": the consumer converts
  };
  struct Trial {
    std::uint32_t cost = 0;
    std::uint32_t distance = 0;
    std::vector<const Way*> ways;
  };
  void extend(const Trial& trial, vocabulary::ClassNumber at, vocabulary::ClassNumber requested);
  [[nodiscard]] bool leads_to(vocabulary::ClassNumber at, vocabulary::ClassNumber requested) const;
  [[nodiscard]] static bool is_better(const Trial& one, const Trial& other);

  vocabulary::Vocabulary vocabulary_;
  std::vector<Way> ways_;
  std::optional<Trial> best_;
  std::map<std::pair<vocabulary::ClassNumber, vocabulary::ClassNumber>, std::shared_ptr<const vocabulary::Chain>>
      known_;
};

}  // namespace geminga::matching

#endif
