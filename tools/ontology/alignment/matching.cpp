// Names are compared word by word, and a word counts the more, the rarer it is in both ontologies (Cohen, Ravikumar,
// Fienberg: A Comparison of String Distance Metrics for Name-Matching Tasks, 2003: soft TF-IDF). What the neighbours of
// two entities are linked to then moves the confidence up or down.
#include "ontology/alignment/matching.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "base/text.hpp"
#include "ontology/alignment/words.hpp"

namespace geminga::ontology {
namespace {

using Name = std::vector<std::string>;

/// Candidates below this need no look at their neighbours.
constexpr double least_by_names = 0.6;
/// The most entities of one ontology that are compared because of one word.
constexpr std::size_t most_of_a_word = 400;
/// How far neighbours can move a confidence.
constexpr double weight_of_neighbours = 0.2;

/// The weights of words: the logarithm of how rare they are.
class Weights {
 public:
  Weights(const Lexicon& one, const Lexicon& other) {
    for (const Lexicon* lexicon : {&one, &other}) {
      for (const LexiconEntry& entry : lexicon->entities()) {
        for (const Name& name : entry.names) {
          for (const std::string& part : name) ++counts_[part];
          ++names_;
        }
      }
    }
  }
  [[nodiscard]] double of(const std::string& word) const {
    const auto found = counts_.find(word);
    const double count = found == counts_.end() ? 1 : static_cast<double>(found->second);
    return std::log(1 + static_cast<double>(names_) / count);
  }
  /// In [0, 1]; 1 for equal words in any order.
  [[nodiscard]] double similarity(const Name& one, const Name& other) const {
    double shared = 0;
    double all = 0;
    std::vector<bool> is_taken(other.size());
    for (const std::string& word : one) {
      all += of(word);
      double best = 0;
      std::size_t best_at = other.size();
      for (std::size_t at = 0; at < other.size(); ++at) {
        if (is_taken[at]) continue;
        const double alike = likeness(word, other[at]);
        if (alike > best) std::tie(best, best_at) = std::pair(alike, at);
      }
      if (best_at == other.size()) continue;
      is_taken[best_at] = true;
      shared += best * (of(word) + of(other[best_at]));
    }
    for (const std::string& word : other) all += of(word);
    return all > 0 ? shared / all : 0;
  }

 private:
  std::unordered_map<std::string, std::size_t> counts_;
  std::size_t names_ = 1;
};

struct Candidate {
  std::uint32_t one = 0;
  std::uint32_t other = 0;
  double by_names = 0;
  double neighbours = 0;  ///< in [-1, 1]
  std::string first;      ///< the names that are most alike
  std::string second;

  [[nodiscard]] double confidence() const {
    return std::clamp(by_names + weight_of_neighbours * neighbours - (neighbours == 0 ? 0 : 0.05), 0.0, 1.0);
  }
};

class Matching {
 public:
  Matching(const Lexicon& one, const Lexicon& other)
      : one_(one.entities()), other_(other.entities()), weights_(one, other) {}

  std::vector<Link> run() {
    std::vector<Candidate> candidates = by_names();
    std::vector<Candidate> chosen = choose(candidates);
    // Twice: the first choice is by names alone, and neighbours of neighbours count in the second one.
    for (int round = 0; round < 2; ++round) {
      look_at_neighbours(candidates, chosen);
      chosen = choose(candidates);
    }
    std::vector<Link> links;
    for (const Candidate& each : chosen) {
      if (each.confidence() < least_confidence) continue;
      links.push_back(
          {one_[each.one].kind, one_[each.one].iri, other_[each.other].iri, each.confidence(), reason(each)});
    }
    return links;
  }

 private:
  std::vector<Candidate> by_names() {
    std::unordered_map<std::string, std::vector<std::uint32_t>> having;
    for (std::uint32_t number = 0; number < other_.size(); ++number) {
      for (const Name& name : other_[number].names) {
        for (const std::string& word : name) {
          auto& list = having[word.substr(0, 4)];  // words that differ in later letters are found, too
          if (list.empty() || list.back() != number) list.push_back(number);
        }
      }
    }
    std::vector<Candidate> candidates;
    for (std::uint32_t number = 0; number < one_.size(); ++number) {
      std::vector<std::uint32_t> near;
      for (const Name& name : one_[number].names) {
        for (const std::string& word : name) {
          const auto found = having.find(word.substr(0, 4));
          if (found == having.end() || found->second.size() > most_of_a_word) continue;
          near.insert(near.end(), found->second.begin(), found->second.end());
        }
        add_equal(name, near);
      }
      std::ranges::sort(near);
      near.erase(std::ranges::unique(near).begin(), near.end());
      for (const std::uint32_t each : near) {
        if (auto candidate = compared(number, each)) candidates.push_back(std::move(*candidate));
      }
    }
    return candidates;
  }

  /// Entities with the same name are compared however common its words are.
  void add_equal(const Name& name, std::vector<std::uint32_t>& near) {
    if (named_.empty()) {
      for (std::uint32_t number = 0; number < other_.size(); ++number) {
        for (const Name& each : other_[number].names) named_[sorted(each)].push_back(number);
      }
    }
    const auto found = named_.find(sorted(name));
    if (found != named_.end()) near.insert(near.end(), found->second.begin(), found->second.end());
  }
  static Name sorted(Name name) {
    std::ranges::sort(name);
    return name;
  }

  [[nodiscard]] std::optional<Candidate> compared(std::uint32_t number, std::uint32_t each) const {
    if (one_[number].kind != other_[each].kind || one_[number].iri == other_[each].iri) return std::nullopt;
    Candidate candidate{number, each, 0, 0, {}, {}};
    for (const Name& first : one_[number].names) {
      for (const Name& second : other_[each].names) {
        const double alike = weights_.similarity(first, second);
        if (alike <= candidate.by_names) continue;
        candidate.by_names = alike;
        candidate.first = base::joined(first, " ");
        candidate.second = base::joined(second, " ");
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

  /// The share of the neighbours that are linked to each other among those that are linked at all; -1 where all are
  /// linked elsewhere, 0 where none is linked.
  [[nodiscard]] double agreement(const std::vector<std::uint32_t>& first,
                                 const std::vector<std::uint32_t>& second) const {
    double agreeing = 0;
    double linked = 0;
    for (const std::uint32_t each : first) {
      const auto found = partner_.find(each);
      if (found == partner_.end()) continue;
      linked += 1;
      if (std::ranges::find(second, found->second) != second.end()) agreeing += 1;
    }
    if (linked == 0 || second.empty()) return 0;
    return 2 * agreeing / linked - 1;
  }

  void look_at_neighbours(std::vector<Candidate>& candidates, const std::vector<Candidate>& chosen) {
    partner_.clear();
    for (const Candidate& each : chosen) {
      if (each.confidence() >= least_confidence) partner_.emplace(each.one, each.other);
    }
    for (Candidate& each : candidates) {
      const double above = agreement(one_[each.one].above, other_[each.other].above);
      const double below = agreement(one_[each.one].below, other_[each.other].below);
      // Children that are linked elsewhere say less against a link than parents do.
      const bool is_class = one_[each.one].kind == owl::TermKind::named_class;
      each.neighbours = std::clamp(above + (is_class ? std::max(below, 0.0) : below), -1.0, 1.0);
    }
  }

  [[nodiscard]] static std::string reason(const Candidate& each) {
    std::string words = each.first == each.second ? "both are named \"" + each.first + '"'
                                                  : "\"" + each.first + "\" and \"" + each.second + "\" are alike";
    if (each.neighbours > 0) words += ", and their neighbours are linked";
    if (each.neighbours < 0) words += ", although their neighbours are linked elsewhere";
    return words;
  }

  const std::vector<LexiconEntry>& one_;
  const std::vector<LexiconEntry>& other_;
  Weights weights_;
  std::map<Name, std::vector<std::uint32_t>> named_;  ///< of the other, by sorted words
  std::unordered_map<std::uint32_t, std::uint32_t> partner_;
};

}  // namespace

std::vector<Link> match(const Lexicon& one, const Lexicon& other) { return Matching(one, other).run(); }

}  // namespace geminga::ontology
