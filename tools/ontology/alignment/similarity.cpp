#include "ontology/alignment/similarity.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "base/text.hpp"
#include "ontology/alignment/words.hpp"

namespace geminga::ontology {
namespace {

using Words = std::vector<std::string>;

/// Two words, or two names, with a sense in common that is frequent for both, or one that is not.
constexpr double of_synonyms = 0.9;
constexpr double of_rare_synonyms = 0.75;
/// Words in another order are the same words, but for rounding.
constexpr double of_the_same_words = 0.999;
/// Classes that say the same of other things: a customer's order is no customer.
constexpr double of_other_heads = 0.7;
/// Properties with other prepositions: "treated by" and "treated with", "has part" and "is part of". Equal words alone
/// do not link them.
constexpr double of_other_prepositions = 0.65;
/// A name that is the end of the other one: a chapter may be a book's chapter, or another kind of one.
constexpr double of_an_end = 0.72;
constexpr std::size_t octets_of_a_beginning = 4;
constexpr std::size_t least_of_initials = 2;
constexpr std::size_t most_of_initials = 6;

std::string initials_of(std::span<const std::string> words) {
  std::string initials;
  for (const std::string& word : words) initials += word.front();
  return initials;
}

bool is_end_of(const Words& shorter, const Words& longer) {
  return shorter.size() < longer.size() && std::equal(shorter.rbegin(), shorter.rend(), longer.rbegin());
}

/// `words` with each word that is made of the initials of words of `other` in their place.
Words with_initials_written_out(const Words& words, const Words& other) {
  Words written;
  for (const std::string& word : words) {
    const std::size_t size = word.size();
    bool is_found = false;
    if (size >= least_of_initials && size <= most_of_initials) {
      for (std::size_t at = 0; !is_found && at + size <= other.size(); ++at) {
        const std::span run = std::span(other).subspan(at, size);
        if (initials_of(run) != word) continue;
        written.insert(written.end(), run.begin(), run.end());
        is_found = true;
      }
    }
    if (!is_found) written.push_back(word);
  }
  return written;
}

/// "has author" is "author", and may be "written by"; it is not "is author of".
bool are_other_ways(const std::string& one, const std::string& other) {
  if (one == other) return false;
  return one == "of" || other == "of" || (!one.empty() && !other.empty());
}

/// 0 where no sense is common.
double by_senses(const std::vector<Thesaurus::Sense>& one, const std::vector<Thesaurus::Sense>& other) {
  double best = 0;
  for (const Thesaurus::Sense& first : one) {
    for (const Thesaurus::Sense& second : other) {
      if (first.number != second.number) continue;
      best = std::max(best, first.is_frequent && second.is_frequent ? of_synonyms : of_rare_synonyms);
    }
  }
  return best;
}

}  // namespace

Similarity::Similarity(const Lexicon& one, const Lexicon& other, const Thesaurus& thesaurus) {
  count(one, thesaurus);
  count(other, thesaurus);
}

void Similarity::count(const Lexicon& lexicon, const Thesaurus& thesaurus) {
  for (const LexiconEntry& entry : lexicon.entities()) {
    for (const EntityName& name : entry.names) {
      for (const std::string& part : name.words) {
        Word& word = words_[part];
        if (word.count == 0) word.senses = thesaurus.senses_of(part);
        ++word.count;
      }
      ++names_;
      if (name.words.size() == 1) continue;
      auto senses = thesaurus.senses_of(base::joined(name.words, "_"));
      if (!senses.empty()) phrases_.emplace(base::joined(name.words, " "), std::move(senses));
    }
  }
}

double Similarity::weight(const std::string& word) const {
  const auto found = words_.find(word);
  const double count = found == words_.end() ? 1 : static_cast<double>(found->second.count);
  return std::log(1 + static_cast<double>(names_) / count);
}

double Similarity::alike(const std::string& one, const std::string& other) const {
  const double by_letters = likeness(one, other);
  if (by_letters >= of_synonyms) return by_letters;
  const auto first = words_.find(one);
  const auto second = words_.find(other);
  if (first == words_.end() || second == words_.end()) return by_letters;
  return std::max(by_letters, by_senses(first->second.senses, second->second.senses));
}

double Similarity::by_meaning(const Words& one, const Words& other) const {
  const auto senses = [this](const Words& name) -> const std::vector<Thesaurus::Sense>* {
    if (name.size() == 1) {
      const auto word = words_.find(name.front());
      return word == words_.end() ? nullptr : &word->second.senses;
    }
    const auto phrase = phrases_.find(base::joined(name, " "));
    return phrase == phrases_.end() ? nullptr : &phrase->second;
  };
  const auto* const first = senses(one);
  const auto* const second = senses(other);
  return first != nullptr && second != nullptr ? by_senses(*first, *second) : 0;
}

double Similarity::by_words(const Words& one, const Words& other) const {
  double shared = 0;
  double all = 0;
  std::vector<bool> is_taken(other.size());
  for (const std::string& word : one) {
    all += weight(word);
    double best = 0;
    std::size_t best_at = other.size();
    for (std::size_t at = 0; at < other.size(); ++at) {
      if (is_taken[at]) continue;
      const double found = alike(word, other[at]);
      if (found > best) std::tie(best, best_at) = std::pair(found, at);
    }
    if (best_at == other.size()) continue;
    is_taken[best_at] = true;
    shared += best * (weight(word) + weight(other[best_at]));
  }
  for (const std::string& word : other) all += weight(word);
  return all > 0 ? shared / all : 0;
}

double Similarity::of(const EntityName& one, const EntityName& other, bool are_classes) const {
  const Words first = with_initials_written_out(one.words, other.words);
  const Words second = with_initials_written_out(other.words, one.words);
  double worth = one.worth * other.worth;
  if (are_other_ways(one.preposition, other.preposition)) worth *= of_other_prepositions;
  if (base::joined(first, "") == base::joined(second, "")) return worth;
  double found = by_words(first, second);
  if (are_classes && found < of_the_same_words && alike(first.back(), second.back()) == 0) found *= of_other_heads;
  if (is_end_of(first, second) || is_end_of(second, first)) found = std::max(found, of_an_end);
  return worth * std::max(found, by_meaning(first, second));
}

std::vector<std::string> Similarity::keys_of(const EntityName& name) const {
  const Words& words = name.words;
  std::vector<std::string> keys;
  const auto add_senses = [&keys](const std::vector<Thesaurus::Sense>& senses) {
    for (const Thesaurus::Sense& sense : senses) keys.push_back('#' + std::to_string(sense.number));
  };
  for (std::size_t at = 0; at < words.size(); ++at) {
    keys.push_back(words[at].substr(0, octets_of_a_beginning));
    if (const auto word = words_.find(words[at]); word != words_.end()) add_senses(word->second.senses);
    if (words[at].size() <= most_of_initials) keys.push_back('!' + words[at]);
    for (std::size_t size = least_of_initials; size <= std::min(most_of_initials, words.size() - at); ++size)
      keys.push_back('!' + initials_of(std::span(words).subspan(at, size)));
  }
  if (const auto phrase = phrases_.find(base::joined(words, " ")); phrase != phrases_.end()) add_senses(phrase->second);
  keys.push_back('=' + base::joined(words, ""));
  return keys;
}

}  // namespace geminga::ontology
