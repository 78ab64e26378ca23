#include "ontology/alignment/words.hpp"

#include <algorithm>
#include <array>

#include "base/edit_distance.hpp"

namespace geminga::ontology {
namespace {

/// Shorter words differ in meaning where they differ in a letter.
constexpr std::size_t least_fuzzy = 5;
constexpr std::array<std::string_view, 19> directions{"has", "have", "had",  "is",   "be", "was", "were",
                                                      "of",  "by",   "the",  "a",    "an", "to",  "in",
                                                      "at",  "on",   "from", "with", "for"};
/// Words that join what something is to what it is of.
constexpr std::array<std::string_view, 3> links{"of", "for", "in"};
constexpr std::array<std::string_view, 9> prepositions{"of", "for", "in", "by", "to", "at", "on", "from", "with"};

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_great(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// Octets of letters beyond ASCII belong to words.
bool is_of_word(char c) { return is_small(c) || is_great(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80; }

/// Whether a word ends before `name[at]`, which belongs to one as the octet before it does.
bool is_cut(std::string_view name, std::size_t at) {
  const char before = name[at - 1];
  const char here = name[at];
  if (is_digit(before) != is_digit(here)) return true;
  if (is_small(before) && is_great(here)) return true;
  // PDFFile: the last great letter begins the next word.
  return is_great(before) && is_great(here) && at + 1 < name.size() && is_small(name[at + 1]);
}

std::string without_plural(std::string word) {
  const std::size_t size = word.size();
  if (size > 4 && word.ends_with("ies")) return word.replace(size - 3, 3, "y");
  const bool is_sibilant =
      word.ends_with("sses") || word.ends_with("xes") || word.ends_with("ches") || word.ends_with("shes");
  if (size > 4 && is_sibilant) return word.substr(0, size - 2);
  if (size > 3 && word.ends_with("s") && !word.ends_with("ss") && !word.ends_with("us") && !word.ends_with("is"))
    return word.substr(0, size - 1);
  return word;
}

}  // namespace

std::vector<std::string> words_of_name(std::string_view name) {
  std::vector<std::string> words;
  bool goes_on = false;
  for (std::size_t at = 0; at < name.size(); ++at) {
    if (!is_of_word(name[at])) {
      goes_on = false;
      continue;
    }
    if (!goes_on || is_cut(name, at)) words.emplace_back();
    words.back() += is_great(name[at]) ? static_cast<char>(name[at] + ('a' - 'A')) : name[at];
    goes_on = true;
  }
  for (std::string& word : words) word = without_plural(std::move(word));
  return words;
}

std::vector<std::string> words_of_class(std::string_view name) {
  std::vector<std::string> words = words_of_name(name);
  const auto link = std::ranges::find_first_of(words, links);
  if (link == words.begin() || link == words.end() || link + 1 == words.end()) return words;
  std::vector<std::string> turned(link + 1, words.end());
  turned.insert(turned.end(), words.begin(), link);
  return turned;
}

std::vector<std::string> words_of_property(std::string_view name) {
  std::vector<std::string> words = words_of_class(name);
  std::vector<std::string> left;
  for (const std::string& word : words) {
    if (std::ranges::find(directions, word) == directions.end()) left.push_back(word);
  }
  return left.empty() ? words : left;
}

std::string preposition_of(std::string_view name) {
  const std::vector<std::string> words = words_of_name(name);
  if (words.size() < 2 || std::ranges::find(prepositions, words.back()) == prepositions.end()) return {};
  return words.back();
}

double likeness(std::string_view one, std::string_view other) {
  if (one == other) return 1;
  const std::size_t shorter = std::min(one.size(), other.size());
  const std::size_t longer = std::max(one.size(), other.size());
  if (shorter < least_fuzzy) return 0;
  const std::size_t slips = longer / least_fuzzy;
  const std::size_t distance = base::edit_distance(one, other, slips);
  return distance > slips ? 0 : 1 - static_cast<double>(distance) / static_cast<double>(longer);
}

}  // namespace geminga::ontology
