#include "ontology/comparison/statements.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "ontology/loading/classified_files.hpp"
#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/syntax/rdf/reserved_words.hpp"

namespace geminga::ontology {
namespace {

using explanation::ExplainedAxiom;

/// The axioms of a source that are not among others.
std::vector<ExplainedAxiom> axioms_beyond(const owl::Ontology& source, const owl::ShortName& short_name,
                                          const Axioms& others) {
  const Contents contents(source);
  std::vector<ExplainedAxiom> found;
  std::set<Contents::Hash> seen;
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    if (axiom.kind == owl::AxiomKind::declaration || others.has(contents, axiom)) continue;
    if (!seen.insert(contents.hash_of(axiom)).second) continue;
    found.push_back(
        {owl::print(source, axiom, short_name), source.files()[static_cast<std::size_t>(axiom.file)].path, axiom.line});
  }
  std::ranges::stable_sort(found, {}, [](const ExplainedAxiom& one) { return std::tie(one.file, one.line); });
  return found;
}

std::string written(const owl::Annotation& annotation, const owl::ShortName& short_name) {
  const auto name = [&](const std::string& iri) { return iri.starts_with("_:") ? "_:" : short_name(iri); };
  std::string text = name(annotation.subject) + ' ' + short_name(annotation.property) + ' ';
  if (!annotation.is_literal) return text + name(annotation.value);
  text += owl::quoted(annotation.value);
  std::ranges::replace(text, '\n', ' ');
  if (!annotation.language.empty()) return text + '@' + annotation.language;
  // A text is the same literal with its datatype and without it (OWL 2, section 5.7; RDF 1.1, section 3.3).
  const bool is_text = annotation.datatype.empty() || annotation.datatype == std::string(owl::xsd_namespace) + "string";
  return is_text ? text : text + "^^" + short_name(annotation.datatype);
}

/// Annotations by what they say, with full names, and as they are shown.
std::map<std::string, std::string> annotations_of(const rdf::Loaded& loaded, const owl::ShortName& short_name) {
  const owl::ShortName in_full = [](std::string_view iri) { return "<" + std::string(iri) + ">"; };
  std::map<std::string, std::string> all;
  for (const owl::Annotation& one : loaded.annotations) {
    if (one.of == owl::Annotation::Of::name) all.emplace(written(one, in_full), written(one, short_name));
  }
  return all;
}

std::vector<ExplainedAxiom> annotations_beyond(const std::map<std::string, std::string>& all,
                                               const std::map<std::string, std::string>& others) {
  std::vector<ExplainedAxiom> found;
  for (const auto& [key, text] : all) {
    if (!others.contains(key)) found.push_back({text, {}, 0});
  }
  return found;
}

/// The names that axioms use, declarations among them, and the properties of annotations. A declaration of a reserved
/// word says nothing: OWL 2 has all of them (section 2.4).
std::set<std::string_view> names_of(const rdf::Loaded& loaded) {
  const owl::Ontology& source = loaded.source;
  std::vector<owl::TermId> roots;
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    const auto arguments = axiom.arguments;
    if (axiom.kind == owl::AxiomKind::declaration && rdf::is_reserved(source.name_of(arguments[0]))) continue;
    roots.insert(roots.end(), arguments.begin(), arguments.end());
  }
  std::set<std::string_view> names;
  for (const owl::TermId id : owl::terms_in(source, roots)) {
    const owl::TermKind kind = source.kind(id);
    if (kind <= owl::TermKind::individual) names.insert(source.name_of(id));
  }
  for (const owl::Annotation& one : loaded.annotations) {
    if (!rdf::is_reserved(one.property)) names.insert(one.property);
    const std::string_view word =
        one.of == owl::Annotation::Of::name ? owl::annotation_axiom_of(one) : owl::annotation_assertion;
    if (word != owl::annotation_assertion) names.insert(one.subject);
    if (word == owl::sub_annotation_property_of) names.insert(one.value);
  }
  return names;
}

std::vector<std::string> names_beyond(const std::set<std::string_view>& all, const std::set<std::string_view>& others) {
  std::vector<std::string> found;
  for (const std::string_view name : all) {
    if (!others.contains(name)) found.emplace_back(name);
  }
  return found;
}

}  // namespace

ChangedStatements compare_statements(const rdf::Loaded& before, const rdf::Loaded& after) {
  const owl::ShortName old_name = short_names(before.source);
  const owl::ShortName new_name = short_names(after.source);
  const auto old_annotations = annotations_of(before, old_name);
  const auto new_annotations = annotations_of(after, new_name);
  const auto old_names = names_of(before);
  const auto new_names = names_of(after);
  return {{axioms_beyond(before.source, old_name, Axioms(after.source)),
           axioms_beyond(after.source, new_name, Axioms(before.source))},
          {annotations_beyond(old_annotations, new_annotations), annotations_beyond(new_annotations, old_annotations)},
          names_beyond(old_names, new_names),
          names_beyond(new_names, old_names)};
}

}  // namespace geminga::ontology
