// `query ontology`: the ontology in force, what the reasoner does not use, and the participants that have another one.
#include "base/text.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "reasoning/vocabulary/sources.hpp"

namespace geminga::participant {
namespace {

/// owl:Thing and owl:Nothing, which no file declares: geminga-ontology counts the others, too.
constexpr std::uint32_t unnamed_classes = 2;

}  // namespace

Answer answer_ontology(const vocabulary::Vocabulary& vocabulary, const OntologyReading& reading,
                       const membership::Neighbours& neighbours, base::Instant now) {
  Answer answer{.kind = "ontology", .lines = {{}}, .end = {}};
  append_flag(answer.lines.front(), "loaded", vocabulary.is_loaded());
  append(answer.lines.front(), "digest", digest_word(vocabulary.digest()));
  if (vocabulary.is_loaded()) {
    const auto files = vocabulary.files();
    const auto left_out = vocabulary.left_out();
    append(answer.lines.front(), "classes", vocabulary.class_count() - unnamed_classes);
    append(answer.lines.front(), "files", files.size());
    append(answer.lines.front(), "left_out", left_out.size());
    const auto gaps = vocabulary.gaps();
    const bool is_consistent = vocabulary.is_consistent();
    append_flag(answer.lines.front(), "complete", is_consistent && left_out.empty() && gaps.empty());
    if (!is_consistent) append_flag(answer.lines.front(), "contradiction", true);
    for (const auto& file : files) {
      Line line;
      append(line, "file", base::printable(file.path, 4096));
      append_stated(line, "iri", file.ontology_iri);
      answer.lines.push_back(std::move(line));
    }
    for (const auto& one : left_out) {
      Line line;
      append(line, "left_out", one.construct);
      append(line, "count", one.count);
      append_stated(line, "first", base::printable(one.first, 4096));
      answer.lines.push_back(std::move(line));
    }
    for (const std::string& gap : gaps) {
      Line line;
      append(line, "gap", base::printable(gap, 4096));
      answer.lines.push_back(std::move(line));
    }
  }
  if (reading.is_loading) append_flag(answer.lines.front(), "loading", true);
  for (const std::string& failure : reading.failure) {
    Line line;
    append(line, "failed", failure);
    append(line, "age", seconds(now - reading.failed_at));
    answer.lines.push_back(std::move(line));
  }
  neighbours.for_each([&](const membership::Neighbour& neighbour) {
    if (neighbour.ontology_digest == vocabulary.digest()) return;
    Line line;
    append(line, "other", to_string(neighbour.id));
    append(line, "name", neighbour.name);
    append(line, "ontology", digest_word(neighbour.ontology_digest));
    answer.lines.push_back(std::move(line));
  });
  return answer;
}

}  // namespace geminga::participant
