// Steps from one representation to another, declared by an ontology or done by somebody, and the cheapest way over
// several of them.
#ifndef GEMINGA_REASONING_VOCABULARY_STEP_GRAPH_HPP
#define GEMINGA_REASONING_VOCABULARY_STEP_GRAPH_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/owl/conversion.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::compiled {
class Ontology;
}

namespace geminga::vocabulary {

/// The most steps in one chain.
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
  /// Different for chains over different classes or by others, but for chance; equal on every host.
  std::uint32_t mark = 0;
  /// Who does each step, as events say it; empty: the consumer does them all.
  std::string via{};
};

/// What is in `from` can be turned into something in `to`.
struct Step {
  taxonomy::ClassNumber from{};
  taxonomy::ClassNumber to{};
  std::uint32_t cost = 1;  ///< 1 to owl::max_conversion_cost
  bool is_service = false;
};

/// Steps that come and go. A step has a place, a small number, for as long as it is there. Not thread-safe while it is
/// changed.
class StepGraph {
 public:
  explicit StepGraph(std::shared_ptr<const compiled::Ontology> ontology) : ontology_(std::move(ontology)) {}

  /// Adds a step. Its place must be free, its turn that of no other, and both of its classes satisfiable. O(steps).
  void put(std::uint32_t place, const Step& step, std::uint64_t turn);
  /// Takes it out. O(steps and pairs of them).
  void erase(std::uint32_t place);
  [[nodiscard]] bool has(std::uint32_t place) const { return place < steps_.size() && steps_[place].is_there; }
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] const Step& step(std::uint32_t place) const { return steps_[place].step; }

  /// Whether a step may be used. Empty: all.
  using Usable = std::function<bool(std::uint32_t place)>;
  /// The places of the cheapest way, up to max_chain_conversions, from something above `offered` to something below
  /// `requested`; of those that with the fewest services, of those the shortest, of those that with the least distance,
  /// of those the one whose last step has the least turn, and so on back to the first. Empty where there is none.
  [[nodiscard]] std::vector<std::uint32_t> cheapest(taxonomy::ClassNumber offered, taxonomy::ClassNumber requested,
                                                    const Usable& usable = {}) const;
  /// What comes of the ways that begin with this step, each place once, with the least cost of a way that ends with it.
  [[nodiscard]] std::vector<std::pair<taxonomy::ClassNumber, std::uint32_t>> behind(std::uint32_t place) const;
  /// These steps as a chain.
  [[nodiscard]] Chain chain_of(const std::vector<std::uint32_t>& way, taxonomy::ClassNumber offered,
                               taxonomy::ClassNumber requested) const;

 private:
  struct Next {
    std::uint32_t place = 0;
    std::uint32_t distance = 0;  ///< up to what it takes
  };
  struct Stored {
    Step step;
    std::uint64_t turn = 0;
    bool is_there = false;
    std::vector<Next> next{};  ///< those that take what comes of it
  };
  struct Best;
  using Round = std::vector<Best>;
  [[nodiscard]] static std::uint64_t weight_of(const Step& step);
  [[nodiscard]] std::uint32_t climb(taxonomy::ClassNumber from, taxonomy::ClassNumber to) const;
  /// What one step more than `reached` leads to, where that is below `least`; false: nothing.
  [[nodiscard]] bool go_on(const Round& reached, std::uint64_t least, const Usable& usable, Round& further) const;

  std::shared_ptr<const compiled::Ontology> ontology_;
  std::vector<Stored> steps_;         ///< by place
  std::vector<std::uint32_t> order_;  ///< of those that are there, by turn
};

}  // namespace geminga::vocabulary

#endif
