// Which representation can be turned into which, over several declared conversions.
#ifndef GEMINGA_REASONING_VOCABULARY_CONVERSIONS_HPP
#define GEMINGA_REASONING_VOCABULARY_CONVERSIONS_HPP

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "reasoning/taxonomy/class_number.hpp"
#include "reasoning/vocabulary/step_graph.hpp"

namespace geminga::vocabulary {

/// The declared conversions of one ontology between satisfiable classes. Safe to use from many threads.
class Conversions {
 public:
  /// The most answers that are remembered. Beyond it all are forgotten.
  static constexpr std::size_t max_remembered = 4096;

  explicit Conversions(std::shared_ptr<const compiled::Ontology> ontology);

  /// The cheapest chain of up to max_chain_conversions from a class above `offered` to a class below `requested`, with
  /// the ties of StepGraph::cheapest(). Null if there is none. Both classes must be satisfiable.
  [[nodiscard]] std::shared_ptr<const Chain> cheapest(taxonomy::ClassNumber offered,
                                                      taxonomy::ClassNumber requested) const;
  [[nodiscard]] std::size_t size() const { return graph_.size(); }
  /// The conversions, at the places from 0 to size().
  [[nodiscard]] const StepGraph& graph() const { return graph_; }

 private:
  StepGraph graph_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<taxonomy::ClassNumber, taxonomy::ClassNumber>, std::shared_ptr<const Chain>> remembered_;
};

}  // namespace geminga::vocabulary

#endif
