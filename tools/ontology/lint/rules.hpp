// The rules of `geminga-ontology report`, and what they find.
#ifndef GEMINGA_ONTOLOGY_LINT_RULES_HPP
#define GEMINGA_ONTOLOGY_LINT_RULES_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/entities/entities.hpp"
#include "ontology/loading/classified_files.hpp"

namespace geminga::ontology {

enum class Level : std::uint8_t {
  error,    ///< the ontology does not say what its author thinks
  warning,  ///< users will stumble over it
  info,     ///< worth a look
};
[[nodiscard]] std::string_view to_string(Level level);
[[nodiscard]] std::optional<Level> find_level(std::string_view word);

/// The codes are what other programs rely on: they are only ever appended.
struct Rule {
  std::string_view code;
  Level level;
  std::string_view meaning;
};
[[nodiscard]] std::span<const Rule> rules();
[[nodiscard]] const Rule* find_rule(std::string_view code);

struct LintFinding {
  const Rule* rule = nullptr;
  std::string iri;   ///< of the entity that it is about; empty: the ontology
  std::string file;  ///< empty: unknown
  std::uint32_t line = 0;
  std::string words;
};

/// Collects findings of rules by their codes.
class LintFindings {
 public:
  /// Requires a code of rules().
  void add(std::string_view code, const Entity& entity, std::string words);
  void add(std::string_view code, std::string file, std::uint32_t line, std::string words);
  /// By file, line, level, code and words.
  [[nodiscard]] std::vector<LintFinding> take();

 private:
  std::vector<LintFinding> found_;
};

/// Typing errors, labels, definitions, names that nothing uses, names of two kinds, and heads of files. Requires
/// annotations.
void check_names(const rdf::Loaded& loaded, const Entities& entities, LintFindings& findings);
/// Classes that can have no instance, contradictions, cycles, several roots, superfluous inclusions, synonyms.
void check_hierarchy(const ClassifiedFiles& classified, const Entities& entities, LintFindings& findings);

}  // namespace geminga::ontology

#endif
