#include "ontology/alignment/thesaurus.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>

namespace geminga::ontology {
namespace {

constexpr std::string_view digits = "0123456789";
constexpr std::size_t digits_of_an_offset = 8;
constexpr std::size_t frequent_senses = 2;

/// The lemma of a line: all before its first blank.
std::string_view lemma_at(std::string_view text, std::size_t line) {
  const std::string_view rest = text.substr(line);
  return rest.substr(0, rest.find_first_of(" \n"));
}

}  // namespace

std::expected<Thesaurus::Index, std::string> Thesaurus::read_index(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t octets = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream) return std::unexpected(file.string() + " cannot be read");
  if (octets > most_octets) return std::unexpected(file.string() + " is longer than an index of WordNet");
  Index index;
  index.text.resize(octets);
  stream.read(index.text.data(), static_cast<std::streamsize>(octets));
  if (!stream) return std::unexpected(file.string() + " cannot be read");
  for (std::size_t line = 0; line < index.text.size();) {
    // Lines of the licence begin with a blank.
    if (index.text[line] != ' ') index.lines.push_back(static_cast<std::uint32_t>(line));
    const std::size_t end = index.text.find('\n', line);
    line = end == std::string::npos ? index.text.size() : end + 1;
  }
  const auto lemma = [&index](std::uint32_t line) { return lemma_at(index.text, line); };
  if (!std::ranges::is_sorted(index.lines, {}, lemma)) std::ranges::sort(index.lines, {}, lemma);
  return index;
}

std::expected<Thesaurus, std::string> Thesaurus::read(const std::filesystem::path& folder) {
  Thesaurus made;
  auto nouns = read_index(folder / "index.noun");
  if (!nouns) return std::unexpected(nouns.error());
  auto verbs = read_index(folder / "index.verb");
  if (!verbs) return std::unexpected(verbs.error());
  made.nouns_ = std::move(*nouns);
  made.verbs_ = std::move(*verbs);
  return made;
}

std::vector<Thesaurus::Sense> Thesaurus::senses_of(std::string_view word) const {
  std::vector<Sense> senses;
  add_senses(nouns_, word, 0, senses);
  add_senses(verbs_, word, 1, senses);
  for (const std::string_view ending : {"ed", "ing"}) {
    if (!senses.empty() || !word.ends_with(ending)) continue;
    const std::string stem(word.substr(0, word.size() - ending.size()));
    add_senses(verbs_, stem + 'e', 1, senses);
    if (senses.empty()) add_senses(verbs_, stem, 1, senses);
  }
  return senses;
}

void Thesaurus::add_senses(const Index& index, std::string_view lemma, std::uint64_t part_of_speech,
                           std::vector<Sense>& senses) {
  const auto line_of = [&index](std::uint32_t line) { return lemma_at(index.text, line); };
  const auto found = std::ranges::lower_bound(index.lines, lemma, {}, line_of);
  if (found == index.lines.end() || line_of(*found) != lemma) return;
  const std::string_view rest = std::string_view(index.text).substr(*found + lemma.size());
  std::string_view line = rest.substr(0, rest.find('\n'));
  // The offsets of the senses are the only words of eight digits.
  std::size_t count = 0;
  while (!line.empty() && count < most_senses) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string_view::npos) break;
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find(' '));
    line.remove_prefix(word.size());
    if (word.size() != digits_of_an_offset || word.find_first_not_of(digits) != std::string_view::npos) continue;
    std::uint64_t offset = 0;
    std::from_chars(word.data(), word.data() + word.size(), offset);
    senses.push_back({2 * offset + part_of_speech, count < frequent_senses});
    ++count;
  }
}

}  // namespace geminga::ontology
