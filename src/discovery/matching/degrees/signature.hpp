// Signatures: the attributes `inputs` and `outputs` of a service, and those that a subscription can give and needs.
#ifndef GEMINGA_DISCOVERY_MATCHING_DEGREES_SIGNATURE_HPP
#define GEMINGA_DISCOVERY_MATCHING_DEGREES_SIGNATURE_HPP

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/matching/degrees/degree.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

inline constexpr std::string_view inputs_attribute = "inputs";
inline constexpr std::string_view outputs_attribute = "outputs";

/// An input or output: a concept by its IRI, or another word, which is compared as it is.
struct Parameter {
  std::string name;
  std::optional<vocabulary::ClassNumber> number;
};

/// The parameters in both attributes; nothing where an attribute is not stated. The limit of an attribute's length
/// bounds their number.
struct Signature {
  std::optional<std::vector<Parameter>> inputs;
  std::optional<std::vector<Parameter>> outputs;
};

[[nodiscard]] bool has_signature(const Attributes& attributes);
/// Reads the names in both attributes: `prefix:Name`, `<IRI>` or an IRI, with blanks or commas between them. Labels are
/// not searched, because an announcement may name many.
[[nodiscard]] Signature signature_of(const Attributes& attributes, const vocabulary::Vocabulary& vocabulary);

/// The signature itself; an empty one for null.
[[nodiscard]] const Signature& stated(const Signature* signature);

/// The weakest degree of all parameters, with the sum of their distances. Outputs are covariant: each requested output
/// is compared with the best offered one. Inputs are contravariant: each input that the service needs is compared with
/// the best one that the subscription gives. An attribute that the subscription does not state is not compared.
/// Nothing where a parameter has no degree as good as `weakest`.
[[nodiscard]] std::optional<Match> degree_of_signature(const Signature& offered, const Signature& asked, Degree weakest,
                                                       const vocabulary::Vocabulary& vocabulary);

/// The parameters without such a degree, in words; empty where there is none.
[[nodiscard]] std::string signature_misfit(const Signature& offered, const Signature& asked, Degree weakest,
                                           const vocabulary::Vocabulary& vocabulary);

}  // namespace geminga::matching

#endif
