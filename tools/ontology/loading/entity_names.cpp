#include "ontology/loading/entity_names.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/compiled/similar.hpp"

namespace geminga::ontology {

EntityNames::EntityNames(const owl::Ontology& source) {
  const auto short_name = short_names(source);
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    const owl::TermId term{id};
    if (source.kind(term) > owl::TermKind::individual) continue;
    const std::string_view iri = source.name_of(term);
    std::vector<owl::TermId>& terms = terms_[iri];
    terms.push_back(term);
    if (terms.size() > 1) continue;
    iris_[short_name(iri)].push_back(iri);
    iris_[std::string(compiled::local_name(iri))].push_back(iri);
  }
}

std::expected<std::vector<owl::TermId>, std::string> EntityNames::find(std::string_view name) const {
  const bool is_in_brackets = name.size() > 2 && name.front() == '<' && name.back() == '>';
  const std::string_view iri = is_in_brackets ? name.substr(1, name.size() - 2) : name;
  if (const auto found = terms_.find(iri); found != terms_.end()) return found->second;
  const std::string words = base::printable(name, 200);
  const auto found = iris_.find(std::string(name));
  if (found == iris_.end())
    return std::unexpected(words + " is no class, property or individual of the files: write prefix:Name or <IRI>");
  std::vector<std::string_view> iris = found->second;
  std::ranges::sort(iris);
  iris.erase(std::ranges::unique(iris).begin(), iris.end());
  if (iris.size() == 1) return terms_.at(iris.front());
  std::string several;
  for (const std::string_view one : iris) several += " <" + base::printable(one, 200) + ">";
  return std::unexpected(words + " is the name of several:" + several + ": write one of these");
}

}  // namespace geminga::ontology
