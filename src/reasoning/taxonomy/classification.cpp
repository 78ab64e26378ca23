#include "reasoning/taxonomy/classification.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>

#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::taxonomy {

std::vector<owl::LeftOut> left_out(const owl::Ontology& source, const Classification& classification) {
  struct Place {
    std::uint32_t count = 0;
    std::pair<std::string_view, std::uint32_t> first;
    owl::FileId file{};
  };
  std::map<std::string_view, Place> places;
  const auto add = [&](std::string_view construct, owl::FileId file, std::uint32_t line, std::uint32_t count) {
    Place& place = places[construct];
    const std::pair<std::string_view, std::uint32_t> here(source.files()[static_cast<std::size_t>(file)].path, line);
    if (place.count == 0 || here < place.first) {
      place.first = here;
      place.file = file;
    }
    place.count += count;
  };
  for (const owl::Ontology::Omission& omission : source.omissions()) {
    add(source.name(omission.construct), omission.file, omission.line, omission.count);
  }
  for (const UnusedAxiom& unused : classification.unused) {
    const owl::Axiom axiom = source.axiom(unused.axiom);
    add(unused.construct, axiom.file, axiom.line, 1);
  }
  const std::set<owl::NameId> classes = source.conversions().empty()
                                            ? std::set<owl::NameId>()
                                            : std::set(classification.classes.begin(), classification.classes.end());
  for (const owl::Ontology::Conversion& one : source.conversions()) {
    if (classes.contains(one.from) && classes.contains(one.to)) continue;
    add("geminga:convertsTo of what is no class", one.file, one.line, 1);
  }
  std::vector<owl::LeftOut> result;
  for (const auto& [construct, place] : places) {
    result.push_back({std::string(construct), place.count,
                      std::string(place.first.first) + ":" + std::to_string(place.first.second),
                      static_cast<std::uint32_t>(place.file), place.first.second});
  }
  return result;
}

}  // namespace geminga::taxonomy
