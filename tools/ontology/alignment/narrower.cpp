#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "base/text.hpp"
#include "ontology/alignment/matching.hpp"

namespace geminga::ontology {
namespace {

/// The end of a name is what the thing is; the rest may still change its meaning, as that of "guinea pig" does.
constexpr double of_narrower = 0.6;

using Words = std::vector<std::string>;

/// Finds the classes of one side that are narrower than classes of the other.
class Narrower {
 public:
  Narrower(const Lexicon& sub, const Lexicon& super, std::map<std::string, std::string> partners)
      : sub_(sub.entities()), super_(super.entities()), partners_(std::move(partners)) {
    for (const LexiconEntry& entry : super_) {
      if (entry.kind != owl::TermKind::named_class) continue;
      for (const EntityName& name : entry.names) {
        if (name.worth == 1) named_.emplace(name.words, &entry);
      }
    }
  }

  /// With the narrower class first, and equal ones left out.
  void add_to(std::vector<Link>& links, Relation relation) const {
    for (const LexiconEntry& entry : sub_) {
      if (entry.kind != owl::TermKind::named_class || partners_.contains(entry.iri)) continue;
      const auto [found, end] = broadest_of(entry);
      if (found == nullptr || found->iri == entry.iri || is_told(entry, found->iri)) continue;
      const bool is_narrower = relation == Relation::narrower;
      links.push_back({.kind = entry.kind,
                       .relation = relation,
                       .one = is_narrower ? entry.iri : found->iri,
                       .other = is_narrower ? found->iri : entry.iri,
                       .confidence = of_narrower,
                       .reason = "the name of one ends with \"" + end + '"'});
    }
  }

 private:
  /// The class whose name is the longest proper end of a name of `entry`, and that end.
  [[nodiscard]] std::pair<const LexiconEntry*, std::string> broadest_of(const LexiconEntry& entry) const {
    const LexiconEntry* best = nullptr;
    Words end;
    for (const EntityName& name : entry.names) {
      for (std::size_t at = 1; at < name.words.size(); ++at) {
        Words rest(std::next(name.words.begin(), static_cast<std::ptrdiff_t>(at)), name.words.end());
        const auto found = named_.find(rest);
        if (found == named_.end()) continue;
        if (rest.size() > end.size()) std::tie(best, end) = std::pair(found->second, std::move(rest));
        break;  // shorter ends say less
      }
    }
    return {best, base::joined(end, " ")};
  }

  /// Whether a class that is told above `entry` is linked to `super`.
  [[nodiscard]] bool is_told(const LexiconEntry& entry, const std::string& super) const {
    std::set<std::uint32_t> seen(entry.above.begin(), entry.above.end());
    std::vector<std::uint32_t> open = entry.above;
    while (!open.empty()) {
      const LexiconEntry& above = sub_[open.back()];
      open.pop_back();
      const auto partner = partners_.find(above.iri);
      if (above.iri == super || (partner != partners_.end() && partner->second == super)) return true;
      for (const std::uint32_t each : above.above) {
        if (seen.insert(each).second) open.push_back(each);
      }
    }
    return false;
  }

  const std::vector<LexiconEntry>& sub_;
  const std::vector<LexiconEntry>& super_;
  std::map<std::string, std::string> partners_;  ///< of the narrower side's classes
  std::map<Words, const LexiconEntry*> named_;   ///< of the broader side, the first of equal names
};

}  // namespace

std::vector<Link> narrower_classes(const Lexicon& one, const Lexicon& other, const std::vector<Link>& equivalences) {
  std::map<std::string, std::string> there;
  std::map<std::string, std::string> back;
  for (const Link& link : equivalences) {
    if (link.kind != owl::TermKind::named_class) continue;
    there.emplace(link.one, link.other);
    back.emplace(link.other, link.one);
  }
  std::vector<Link> links;
  Narrower(one, other, std::move(there)).add_to(links, Relation::narrower);
  Narrower(other, one, std::move(back)).add_to(links, Relation::broader);
  return links;
}

}  // namespace geminga::ontology
