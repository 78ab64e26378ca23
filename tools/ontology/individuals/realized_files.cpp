#include "ontology/individuals/realized_files.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "ontology/loading/argument.hpp"

namespace geminga::ontology {

realization::Realization realize_files(ClassifiedFiles& classified, base::Budget& budget, Progress& progress,
                                       std::optional<std::size_t> most_fact_octets) {
  realization::Options options{.budget = &budget, .with_facts = most_fact_octets.has_value()};
  options.most_fact_octets = most_fact_octets.value_or(options.most_fact_octets);
  options.progress = [&](std::string_view phase, double done) { progress.show(phase, done); };
  auto found = realization::realize(classified.loaded.source, classified.classification, options);
  progress.clear();
  note_unread(classified.loaded.source, found.gaps);
  return found;
}

void note_unread(const owl::Ontology& source, std::vector<std::string>& gaps) {
  auto unread = find_unread(source, {}, true);
  if (!unread) return;
  gaps.push_back(std::move(*unread));
  std::ranges::sort(gaps);
}

std::optional<std::string> describe_open(const owl::Ontology& source, const std::vector<owl::TermId>& undecided,
                                         const std::vector<std::string>& gaps) {
  if (gaps.empty() && undecided.empty()) return std::nullopt;
  std::string line = base::joined(gaps, "; ");
  if (undecided.empty()) return line;
  if (!line.empty()) line += "; ";
  line += "undecided: " + counted(undecided.size(), "individual", "individuals") + " (" +
          short_names(source)(source.name_of(undecided.front())) + (undecided.size() == 1 ? ")" : ", ...)");
  return line;
}

std::vector<owl::TermId> undecided_individuals(const realization::Realization& realization) {
  std::vector<owl::TermId> found;
  for (const std::uint32_t at : realization.undecided) found.push_back(realization.individuals[at]);
  return found;
}

}  // namespace geminga::ontology
