// The facts of an ontology about units, by subject, and the measure of a unit that follows from them.
#ifndef GEMINGA_REASONING_OWL_UNIT_FACTS_HPP
#define GEMINGA_REASONING_OWL_UNIT_FACTS_HPP

#include <compare>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::owl {

struct UnitFact {
  UnitWord word = UnitWord::none;
  std::string_view value;  ///< an IRI or a lexical form
  friend auto operator<=>(const UnitFact&, const UnitFact&) = default;
};

/// Where something stands: the first place by path and line.
struct UnitPlace {
  std::string_view path;
  std::uint32_t line = 0;
  FileId file{};
  friend auto operator<=>(const UnitPlace&, const UnitPlace&) = default;
};

/// A thing that is described in these words: a unit, a prefix, or a part of a unit. Borrows from its ontology.
struct UnitSubject {
  std::string_view iri;
  std::vector<UnitFact> facts;  ///< ascending, each once
  UnitPlace place;

  [[nodiscard]] std::span<const UnitFact> all(UnitWord word) const;
  [[nodiscard]] bool has(UnitWord word) const { return !all(word).empty(); }
};

/// The measure of a unit.
struct UnitMeasure {
  double factor = 1;
  double offset = 0;
  UnitDimension dimension{};
  std::string_view alone;  ///< the IRI of the unit of its own kind; empty: the dimension says the kind
};
/// The measure of a unit, or the reason why it is unknown.
using UnitReading = std::expected<UnitMeasure, std::string_view>;

/// A number as xsd:decimal and xsd:double write it, finite; nothing where it is none.
[[nodiscard]] std::optional<double> unit_number(std::string_view lexical);
/// The number that the facts of one word give. Nothing if there are no facts; an error if they differ or are no
/// numbers.
[[nodiscard]] std::expected<std::optional<double>, std::string_view> unit_number(const UnitSubject& subject,
                                                                                 UnitWord word);
/// Refuses a factor that is not positive, or too large or small, and an offset that is not finite.
[[nodiscard]] UnitReading sound(const UnitMeasure& measure);

/// By IRI. Nothing where there are more than max_unit_statements.
[[nodiscard]] std::optional<std::vector<UnitSubject>> unit_subjects(const Ontology& source);

/// Whether it is a unit of QUDT, and what it measures.
[[nodiscard]] bool is_qudt_unit(const UnitSubject& subject);
[[nodiscard]] UnitReading qudt_measure(const UnitSubject& subject);
/// Whether it is a unit of OM.
[[nodiscard]] bool is_om_unit(const UnitSubject& subject);
/// Measures the units of OM among the subjects. `readings` has one entry for each subject; those of other units are
/// known already.
void measure_om_units(std::span<const UnitSubject> subjects, std::span<std::optional<UnitReading>> readings);

}  // namespace geminga::owl

#endif
