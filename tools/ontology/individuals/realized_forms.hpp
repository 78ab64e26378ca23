// The forms in which realize prints: lines of short names, lines of full IRIs, JSON.
#ifndef GEMINGA_ONTOLOGY_INDIVIDUALS_REALIZED_FORMS_HPP
#define GEMINGA_ONTOLOGY_INDIVIDUALS_REALIZED_FORMS_HPP

#include <boost/json/array.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/individuals/realized_files.hpp"
#include "ontology/loading/hierarchy.hpp"

namespace geminga::ontology {

/// The classes of one individual, in groups of equivalents; owl:Thing where there is no other one.
class RealizedForms {
 public:
  /// Borrows both. With `all` an individual has all its types, else its most specific ones.
  RealizedForms(const ClassifiedFiles& classified, const realization::Realization& realization, bool all);

  /// One line for each thing: `name = other name: type, type = equivalent type`.
  [[nodiscard]] bool write_types(const Sink& sink) const;
  /// One INDIVIDUAL<TAB>CLASS line of full IRIs for all types, sorted, without owl:Thing.
  [[nodiscard]] bool write_closure(const Sink& sink) const;
  /// One line for each fact: `subject property object`.
  [[nodiscard]] bool write_facts(const Sink& sink) const;
  /// One SUBJECT<TAB>PROPERTY<TAB>OBJECT line for each fact, sorted. Literals are written as in functional syntax.
  [[nodiscard]] bool write_fact_closure(const Sink& sink) const;
  /// The individuals that are the same, with their types.
  [[nodiscard]] boost::json::array json_things() const;
  /// The facts as a JSON array, piece by piece: they may be millions.
  [[nodiscard]] bool write_json_facts(const Sink& sink) const;

 private:
  [[nodiscard]] std::vector<std::uint32_t> types_of(std::uint32_t individual, bool all) const;
  [[nodiscard]] std::string_view iri(owl::TermId term) const { return classified_.loaded.source.name_of(term); }
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> things() const;

  const ClassifiedFiles& classified_;
  const realization::Realization& realization_;
  const Hierarchy classes_;
  const bool all_;
};

}  // namespace geminga::ontology

#endif
