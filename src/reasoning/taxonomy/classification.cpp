#include "reasoning/taxonomy/classification.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>

#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::taxonomy {

std::vector<owl::LeftOut> left_out(const owl::Ontology& source, const Classification& classification) {
  struct Tally {
    std::uint32_t count = 0;
    std::pair<std::string_view, std::uint32_t> first;
    owl::FileId file{};
  };
  std::map<std::string_view, Tally> tallies;
  const auto add = [&](std::string_view construct, owl::FileId file, std::uint32_t line, std::uint32_t count) {
    Tally& tally = tallies[construct];
    const std::pair<std::string_view, std::uint32_t> here(source.files()[static_cast<std::size_t>(file)].path, line);
    if (tally.count == 0 || here < tally.first) {
      tally.first = here;
      tally.file = file;
    }
    tally.count += count;
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
  for (const auto& [construct, tally] : tallies) {
    result.push_back({std::string(construct), tally.count,
                      std::string(tally.first.first) + ":" + std::to_string(tally.first.second),
                      static_cast<std::uint32_t>(tally.file), tally.first.second});
  }
  return result;
}

}  // namespace geminga::taxonomy
