// Names are compared first (similarity.hpp). What the neighbours of two entities are linked to then moves the
// confidence up or down.
#include "ontology/alignment/matching.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "base/text.hpp"
#include "ontology/alignment/similarity.hpp"

namespace geminga::ontology {
namespace {

/// Candidates below this need no look at their neighbours.
constexpr double least_by_names = 0.6;
/// The most entities of one ontology that are compared because of one key of their names.
constexpr std::size_t most_of_a_key = 400;
/// Properties that nothing but their domain and range suggests.
constexpr double of_the_only_property = 0.7;
/// How far neighbours can move a confidence.
constexpr double weight_of_neighbours = 0.2;

struct Candidate {
  std::uint32_t one = 0;
  std::uint32_t other = 0;
  double by_names = 0;
  double neighbours = 0;  ///< in [-1, 1]
  bool is_by_places = false;
  std::string first;  ///< the names that are most alike
  std::string second;

  [[nodiscard]] double confidence() const {
    return std::clamp(by_names + weight_of_neighbours * neighbours - (neighbours == 0 ? 0 : 0.05), 0.0, 1.0);
  }
};

class Matching {
 public:
  Matching(const Lexicon& one, const Lexicon& other, const Thesaurus& thesaurus)
      : one_(one.entities()), other_(other.entities()), similarity_(one, other, thesaurus) {}

  std::vector<Link> run() {
    std::vector<Candidate> candidates = by_names();
    std::vector<Candidate> chosen = choose(candidates);
    // Twice: the first choice is by names alone, and neighbours of neighbours count in the second one.
    for (int round = 0; round < 2; ++round) {
      keep_partners(chosen);
      look_at_neighbours(candidates);
      chosen = choose(candidates);
    }
    keep_partners(chosen);
    add_by_places(candidates);
    chosen = choose(candidates);
    std::vector<Link> links;
    for (const Candidate& each : chosen) {
      if (each.confidence() < least_confidence) continue;
      links.push_back({.kind = one_[each.one].kind,
                       .relation = Relation::equivalent,
                       .one = one_[each.one].iri,
                       .other = other_[each.other].iri,
                       .confidence = each.confidence(),
                       .reason = reason(each)});
    }
    return links;
  }

 private:
  std::vector<Candidate> by_names() {
    std::unordered_map<std::string, std::vector<std::uint32_t>> having;
    for (std::uint32_t number = 0; number < other_.size(); ++number) {
      for (const EntityName& name : other_[number].names) {
        for (std::string& key : similarity_.keys_of(name)) {
          auto& list = having[std::move(key)];
          if (list.empty() || list.back() != number) list.push_back(number);
        }
      }
    }
    std::vector<Candidate> candidates;
    for (std::uint32_t number = 0; number < one_.size(); ++number) {
      std::vector<std::uint32_t> near;
      for (const EntityName& name : one_[number].names) {
        for (const std::string& key : similarity_.keys_of(name)) {
          const auto found = having.find(key);
          if (found == having.end() || found->second.size() > most_of_a_key) continue;
          near.insert(near.end(), found->second.begin(), found->second.end());
        }
      }
      std::ranges::sort(near);
      near.erase(std::ranges::unique(near).begin(), near.end());
      for (const std::uint32_t each : near) {
        if (auto candidate = compared(number, each)) candidates.push_back(std::move(*candidate));
      }
    }
    return candidates;
  }

  [[nodiscard]] std::optional<Candidate> compared(std::uint32_t number, std::uint32_t each) const {
    if (one_[number].kind != other_[each].kind || one_[number].iri == other_[each].iri) return std::nullopt;
    Candidate candidate{number, each, 0, 0, false, {}, {}};
    const bool are_classes = one_[number].kind == owl::TermKind::named_class;
    for (const EntityName& first : one_[number].names) {
      for (const EntityName& second : other_[each].names) {
        const double alike = similarity_.of(first, second, are_classes);
        if (alike <= candidate.by_names) continue;
        candidate.by_names = alike;
        candidate.first = base::joined(first.words, " ");
        candidate.second = base::joined(second.words, " ");
      }
    }
    if (candidate.by_names < least_by_names) return std::nullopt;
    return candidate;
  }

  /// Best first, each entity once.
  [[nodiscard]] std::vector<Candidate> choose(std::vector<Candidate>& candidates) const {
    std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
      return std::tuple(-a.confidence(), -a.by_names, a.one, a.other) <
             std::tuple(-b.confidence(), -b.by_names, b.one, b.other);
    });
    std::vector<bool> is_taken_one(one_.size());
    std::vector<bool> is_taken_other(other_.size());
    std::vector<Candidate> chosen;
    for (const Candidate& each : candidates) {
      if (is_taken_one[each.one] || is_taken_other[each.other]) continue;
      is_taken_one[each.one] = is_taken_other[each.other] = true;
      chosen.push_back(each);
    }
    return chosen;
  }

  /// The partners of the entities of one ontology among those of the other.
  using Partners = std::unordered_map<std::uint32_t, std::uint32_t>;

  /// The share of `first` whose partners are in `second` among those that have a partner, as -1 where it is none and 1
  /// where it is all; 0 where none has one.
  [[nodiscard]] static double agreement(const std::vector<std::uint32_t>& first,
                                        const std::vector<std::uint32_t>& second, const Partners& partners) {
    double agreeing = 0;
    double linked = 0;
    for (const std::uint32_t each : first) {
      const auto found = partners.find(each);
      if (found == partners.end()) continue;
      linked += 1;
      if (std::ranges::find(second, found->second) != second.end()) agreeing += 1;
    }
    if (linked == 0 || second.empty()) return 0;
    return 2 * agreeing / linked - 1;
  }
  /// The same in both directions.
  [[nodiscard]] double agreement(const std::vector<std::uint32_t>& first,
                                 const std::vector<std::uint32_t>& second) const {
    const double there = agreement(first, second, partner_);
    return there != 0 ? there : agreement(second, first, back_);
  }

  void keep_partners(const std::vector<Candidate>& chosen) {
    partner_.clear();
    back_.clear();
    for (const Candidate& each : chosen) {
      if (each.confidence() < least_confidence) continue;
      partner_.emplace(each.one, each.other);
      back_.emplace(each.other, each.one);
    }
  }

  void look_at_neighbours(std::vector<Candidate>& candidates) const {
    for (Candidate& each : candidates) {
      const double above = agreement(one_[each.one].above, other_[each.other].above);
      const double below = agreement(one_[each.one].below, other_[each.other].below);
      // Children that are linked elsewhere say less against a link than parents do.
      const bool is_class = one_[each.one].kind == owl::TermKind::named_class;
      each.neighbours = std::clamp(above + (is_class ? std::max(below, 0.0) : below), -1.0, 1.0);
    }
  }

  /// The classes that a property goes from and to, in the numbers of the other ontology.
  using Places = std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>>;

  /// Object properties between the same two classes are linked whatever they are called, where each is the only one.
  void add_by_places(std::vector<Candidate>& candidates) const {
    std::map<Places, std::vector<std::uint32_t>> there;
    for (std::uint32_t number = 0; number < other_.size(); ++number) {
      const LexiconEntry& entry = other_[number];
      if (entry.kind == owl::TermKind::object_property && !back_.contains(number))
        there[{entry.above, entry.below}].push_back(number);
    }
    std::map<Places, std::vector<std::uint32_t>> here;
    for (std::uint32_t number = 0; number < one_.size(); ++number) {
      const LexiconEntry& entry = one_[number];
      if (entry.kind != owl::TermKind::object_property || partner_.contains(number)) continue;
      if (auto places = moved(entry)) here[*std::move(places)].push_back(number);
    }
    for (const auto& [places, properties] : here) {
      const auto found = there.find(places);
      if (found == there.end() || found->second.size() != 1 || properties.size() != 1) continue;
      candidates.push_back({properties.front(), found->second.front(), of_the_only_property, 0, true, {}, {}});
    }
  }

  /// Nothing where it has no domain or no range, or one of these is not linked.
  [[nodiscard]] std::optional<Places> moved(const LexiconEntry& entry) const {
    Places places;
    for (const auto& [from, to] : {std::pair(&entry.above, &places.first), std::pair(&entry.below, &places.second)}) {
      for (const std::uint32_t each : *from) {
        const auto found = partner_.find(each);
        if (found == partner_.end()) return std::nullopt;
        to->push_back(found->second);
      }
      if (to->empty()) return std::nullopt;
    }
    return places;
  }

  [[nodiscard]] static std::string reason(const Candidate& each) {
    if (each.is_by_places) return "each is the only property between classes that are linked";
    std::string words = each.first == each.second ? "both are named \"" + each.first + '"'
                                                  : "\"" + each.first + "\" and \"" + each.second + "\" are alike";
    if (each.neighbours > 0) words += ", and their neighbours are linked";
    if (each.neighbours < 0) words += ", although their neighbours are linked elsewhere";
    return words;
  }

  const std::vector<LexiconEntry>& one_;
  const std::vector<LexiconEntry>& other_;
  Similarity similarity_;
  Partners partner_;  ///< of the one's entities
  Partners back_;     ///< of the other's
};

}  // namespace

char sign_of(Relation relation) {
  if (relation == Relation::equivalent) return '=';
  return relation == Relation::narrower ? '<' : '>';
}

void drop_links_of_shared(const Lexicon& one, const Lexicon& other, std::vector<Link>& links) {
  const auto names_of = [](const Lexicon& lexicon) {
    std::set<std::string_view> names;
    for (const LexiconEntry& entry : lexicon.entities()) names.insert(entry.iri);
    return names;
  };
  const auto of_one = names_of(one);
  const auto of_other = names_of(other);
  std::erase_if(links, [&](const Link& link) { return of_other.contains(link.one) || of_one.contains(link.other); });
}

std::vector<Link> match(const Lexicon& one, const Lexicon& other, const Thesaurus& thesaurus) {
  return Matching(one, other, thesaurus).run();
}

}  // namespace geminga::ontology
