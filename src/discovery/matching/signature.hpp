// The attributes `inputs` and `outputs`: what a service consumes and produces, and what a subscription can give and
// needs.
#ifndef GEMINGA_DISCOVERY_MATCHING_SIGNATURE_HPP
#define GEMINGA_DISCOVERY_MATCHING_SIGNATURE_HPP

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/matching/degree.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

inline constexpr std::string_view inputs_attribute = "inputs";
inline constexpr std::string_view outputs_attribute = "outputs";

/// A concept by its IRI, or a word that is none, which is compared as it is.
struct Parameter {
  std::string name;
  std::optional<vocabulary::ClassNumber> number;
};

/// As many as the words of an attribute, which has a limit of its own. Nothing where the attribute is not stated.
struct Signature {
  std::optional<std::vector<Parameter>> inputs;
  std::optional<std::vector<Parameter>> outputs;
};

[[nodiscard]] bool has_signature(const Attributes& attributes);
/// The words between spaces: `prefix:Name`, `<IRI>` or an IRI. Labels are not looked for: what comes by air may have
/// many.
[[nodiscard]] Signature signature_of(const Attributes& attributes, const vocabulary::Vocabulary& vocabulary);

/// What is stated; null: nothing.
[[nodiscard]] const Signature& stated(const Signature* signature);

/// The weakest degree and the distances of all parameters together. Outputs are covariant: each that is asked for takes
/// the best one that is offered. Inputs are contravariant: each that the service needs takes the best one that is
/// given. What the subscription does not state is not asked. Nothing where a parameter has none within `weakest`.
[[nodiscard]] std::optional<Match> degree_of_signature(const Signature& offered, const Signature& asked, Degree weakest,
                                                       const vocabulary::Vocabulary& vocabulary);

/// The parameters that have none, in words; empty where all have one.
[[nodiscard]] std::string signature_misfit(const Signature& offered, const Signature& asked, Degree weakest,
                                           const vocabulary::Vocabulary& vocabulary);

}  // namespace geminga::matching

#endif
