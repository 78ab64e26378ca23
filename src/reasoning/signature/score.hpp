// The score of a service with inputs and outputs for a request: contravariant inputs, covariant outputs, in degrees.
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

/// The limit of parameters of one side. Readers of signatures refuse more.
inline constexpr std::size_t max_parameters = 64;

/// The parameters that a service consumes and produces, or that a request can give and needs. A concept may stand
/// twice.
struct Signature {
  std::vector<Concept> inputs;
  std::vector<Concept> outputs;
};

/// The relation of an offered concept to a required one.
enum class Relation : std::uint8_t {
  none,        ///< they share nothing
  related,     ///< they share ancestors
  broader,     ///< an instance of the offered concept may be one of the required concept
  narrower,    ///< each instance of the offered concept is one of the required concept
  equivalent,  ///< they are the same
};

/// The word for a relation, such as "narrower".
[[nodiscard]] std::string_view to_string(Relation relation);

/// One required parameter, and the offered parameter of the best assignment.
struct Pair {
  std::size_t required = 0;
  std::optional<std::size_t> offered;
  Relation relation = Relation::none;
  double value = 0;
};

/// A score and its parts, each in [0, 1].
struct Score {
  double total = 0;
  double outputs = 0;
  double inputs = 0;
  std::vector<Pair> output_pairs;  ///< required: outputs of the request; offered: of the service
  std::vector<Pair> input_pairs;   ///< required: inputs of the service; offered: of the request
};

/// The constants of the formula that rest on judgement. RANK.md argues for each.
namespace weight {
/// The most that a parameter loses for being more special than required, and that all outputs lose for surplus outputs.
inline constexpr double surplus = 0.25;
/// The weight of an input that the request cannot give, beside inputs that it can give; and the most that inputs lose
/// which the request gives and the service does not use.
inline constexpr double lone_input = 0.5;
/// The share that is left if the outputs, or the inputs, have nothing in common.
inline constexpr double wrong_outputs = 0.05;
inline constexpr double wrong_inputs = 0.1;
}  // namespace weight

/// Scores over one hierarchy, which it borrows. It remembers the ancestors of concepts. Not thread-safe.
class Scorer {
 public:
  explicit Scorer(const Hierarchy& hierarchy) : hierarchy_(hierarchy) {}

  /// The degree in [0, 1] to which an offered concept satisfies a required one; 1 for equivalent concepts only.
  [[nodiscard]] double satisfaction(Concept required, Concept offered);
  [[nodiscard]] Relation relation(Concept required, Concept offered);
  /// The score of a service for a request. O(n^3) in the parameters of the larger side, at most max_parameters.
  [[nodiscard]] Score score(const Signature& request, const Signature& service);

 private:
  const Meaning& meaning(Concept of);
  std::vector<Pair> pairs(const std::vector<Concept>& required, const std::vector<Concept>& offered);

  const Hierarchy& hierarchy_;
  std::unordered_map<std::uint32_t, Meaning> meanings_;
};

}  // namespace geminga::signature

#endif
