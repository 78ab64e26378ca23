#include "ontology/loading/class_names.hpp"

#include <cstdint>
#include <vector>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/compiled/similar.hpp"

namespace geminga::ontology {
namespace {

/// The error of a name, with similar names where it is unknown.
std::string describe(const compiled::Ontology& ontology, const std::string& name, const compiled::NameError& error) {
  if (error.kind != compiled::NameError::Kind::unknown) return error.text;
  return error.text + compiled::did_you_mean(compiled::find_similar(ontology, name));
}

}  // namespace

std::expected<taxonomy::ClassNumber, std::string> find_class(const compiled::Ontology& ontology,
                                                             const std::string& name) {
  const auto number = ontology.find(name);
  if (number) return *number;
  if (number.error().kind != compiled::NameError::Kind::unknown) return std::unexpected(number.error().text);
  std::vector<taxonomy::ClassNumber> found;
  for (std::uint32_t at = 0; at < ontology.class_count(); ++at) {
    if (compiled::end_of_iri(ontology.iri(taxonomy::ClassNumber{at})) == name)
      found.push_back(taxonomy::ClassNumber{at});
  }
  if (found.size() == 1) return found.front();
  if (found.empty()) return std::unexpected(describe(ontology, name, number.error()));
  std::vector<std::string> candidates;
  for (const taxonomy::ClassNumber candidate : found) candidates.push_back(ontology.short_name(candidate));
  return std::unexpected('\'' + base::printable(name) + "' may be " + compiled::alternatives(candidates) +
                         ": say which");
}

std::optional<taxonomy::ClassNumber> find_or_say(const compiled::Ontology& ontology, const std::string& name,
                                                 bool as_json) {
  const auto number = find_class(ontology, name);
  if (number) return *number;
  say_failure(number.error(), as_json);
  return std::nullopt;
}

}  // namespace geminga::ontology
