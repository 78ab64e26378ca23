// Steps from one representation to another, declared by an ontology or offered by a service, and the cheapest way over
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
/// The most that a chain can cost.
inline constexpr std::uint32_t max_chain_cost = max_chain_conversions * owl::max_conversion_cost;

/// Conversions, one after the other. The result of one is below the input of the next.
struct Chain {
  /// The input of the first conversion, then the result of each.
  std::vector<taxonomy::ClassNumber> classes;
  std::uint32_t cost = 0;
  /// Taxonomy edges from the offered class up to the input of the first conversion, between conversions, and from the
  /// last result up to the requested class.
  std::uint32_t distance = 0;
  /// A hash of the classes and of the services that convert. Equal on every host.
  std::uint32_t mark = 0;
  /// The services that do the steps, as events name them; empty: the consumer does all.
  std::string via{};
};

/// A conversion from one representation into another.
struct Step {
  taxonomy::ClassNumber from{};
  taxonomy::ClassNumber to{};
  std::uint32_t cost = 1;  ///< 1 to owl::max_conversion_cost
  bool is_service = false;
};

/// A changing set of steps. A step keeps its place, a small number, until it is erased. Not thread-safe while it is
/// changed.
class StepGraph {
 public:
  explicit StepGraph(std::shared_ptr<const compiled::Ontology> ontology) : ontology_(std::move(ontology)) {}

  /// Adds a step. Its place must be free, no other step may have its turn, and both of its classes must be satisfiable.
  /// O(steps).
  void put(std::uint32_t place, const Step& step, std::uint64_t turn);
  /// Removes a step. O(steps and pairs of them).
  void erase(std::uint32_t place);
  [[nodiscard]] bool has(std::uint32_t place) const { return place < steps_.size() && steps_[place].is_there; }
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] const Step& step(std::uint32_t place) const { return steps_[place].step; }

  /// Whether a step may be used. Empty: all.
  using Usable = std::function<bool(std::uint32_t place)>;
  /// The places of the cheapest way, up to max_chain_conversions, from something above `offered` to something below
  /// `requested`. Ties are broken by the fewest services, then the shortest way, then the least distance, then the
  /// least turn of the last step, of the one before, and so on. Empty if there is none.
  [[nodiscard]] std::vector<std::uint32_t> cheapest(taxonomy::ClassNumber offered, taxonomy::ClassNumber requested,
                                                    const Usable& usable = {}) const;
  /// The results of all ways that begin with this step, each place once, with the least cost of a way to it.
  [[nodiscard]] std::vector<std::pair<taxonomy::ClassNumber, std::uint32_t>> behind(std::uint32_t place) const;
  /// These steps as a chain.
  [[nodiscard]] Chain chain_of(const std::vector<std::uint32_t>& way, taxonomy::ClassNumber offered,
                               taxonomy::ClassNumber requested) const;

 private:
  struct Next {
    std::uint32_t place = 0;
    std::uint32_t distance = 0;  ///< up to its input
  };
  struct Stored {
    Step step;
    std::uint64_t turn = 0;
    bool is_there = false;
    std::vector<Next> next{};  ///< steps that take its result
  };
  struct Best;
  using Round = std::vector<Best>;
  [[nodiscard]] static std::uint64_t weight_of(const Step& step);
  [[nodiscard]] std::uint32_t climb(taxonomy::ClassNumber from, taxonomy::ClassNumber to) const;
  /// Adds to `further` the steps that one step more than `reached` leads to, at a weight below `least`. Returns whether
  /// there are any.
  [[nodiscard]] bool go_on(const Round& reached, std::uint64_t least, const Usable& usable, Round& further) const;

  std::shared_ptr<const compiled::Ontology> ontology_;
  std::vector<Stored> steps_;         ///< by place
  std::vector<std::uint32_t> order_;  ///< of the places in use, by turn
};

}  // namespace geminga::vocabulary

#endif
