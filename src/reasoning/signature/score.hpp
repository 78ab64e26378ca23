// How well a service with inputs and outputs suits a request: contravariant inputs, covariant outputs, in degrees.
//
// RANK.md has the formula with its arguments and sources.
#ifndef GEMINGA_REASONING_SIGNATURE_SCORE_HPP
#define GEMINGA_REASONING_SIGNATURE_SCORE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "reasoning/signature/hierarchy.hpp"

namespace geminga::signature {

/// The most parameters of one side. What reads signatures refuses more.
inline constexpr std::size_t max_parameters = 64;

/// What a service consumes and produces, or what a request can give and needs. The same concept may stand twice.
struct Signature {
  std::vector<Concept> inputs;
  std::vector<Concept> outputs;
};

/// How what is offered stands to what is required.
enum class Relation : std::uint8_t {
  none,        ///< they share nothing
  related,     ///< they share ancestors
  broader,     ///< what is offered may be what is required
  narrower,    ///< what is offered always is what is required
  equivalent,  ///< the same
};

/// "narrower".
[[nodiscard]] std::string_view to_string(Relation relation);

/// One required parameter, and the offered one that the best assignment gives it.
struct Pair {
  std::size_t required = 0;
  std::optional<std::size_t> offered;
  Relation relation = Relation::none;
  double value = 0;
};

/// In [0, 1], as its parts.
struct Score {
  double total = 0;
  double outputs = 0;
  double inputs = 0;
  std::vector<Pair> output_pairs;  ///< required: outputs of the request; offered: of the service
  std::vector<Pair> input_pairs;   ///< required: inputs of the service; offered: of the request
};

/// What the formula takes from judgement rather than from the taxonomy. Each has its argument in RANK.md.
namespace weight {
/// The most that being more special than required costs a parameter, and surplus outputs cost all outputs.
inline constexpr double surplus = 0.25;
/// How much an input that the request cannot give weighs beside those that it can, and the most that inputs cost that
/// the request gives and the service does not use.
inline constexpr double lone_input = 0.5;
/// What is left where the outputs, or the inputs, have nothing in common at all.
inline constexpr double wrong_outputs = 0.05;
inline constexpr double wrong_inputs = 0.1;
}  // namespace weight

/// Scores over one hierarchy, which it borrows. Remembers what concepts mean. Not for several threads at once.
class Scorer {
 public:
  explicit Scorer(const Hierarchy& hierarchy) : hierarchy_(hierarchy) {}

  /// How far what is offered satisfies what is required, in [0, 1]; 1 for equivalent concepts only.
  [[nodiscard]] double satisfaction(Concept required, Concept offered);
  [[nodiscard]] Relation relation(Concept required, Concept offered);
  /// O(n^3) in the parameters of the larger side, at most max_parameters.
  [[nodiscard]] Score score(const Signature& request, const Signature& service);

 private:
  const Meaning& meaning(Concept of);
  std::vector<Pair> pairs(const std::vector<Concept>& required, const std::vector<Concept>& offered);

  const Hierarchy& hierarchy_;
  std::unordered_map<std::uint32_t, Meaning> meanings_;
};

}  // namespace geminga::signature

#endif
