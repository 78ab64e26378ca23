// The words of a name or label, as they are compared between ontologies.
#ifndef GEMINGA_ONTOLOGY_ALIGNMENT_WORDS_HPP
#define GEMINGA_ONTOLOGY_ALIGNMENT_WORDS_HPP

#include <string>
#include <string_view>
#include <vector>

namespace geminga::ontology {

/// Cuts at `_`, `-`, blanks and other signs, between a small and a great letter, and between letters and digits; makes
/// ASCII letters small and leaves out the endings of English plurals. "hasConferencePapers" is has, conference, paper.
[[nodiscard]] std::vector<std::string> words_of_name(std::string_view name);

/// The same without the words that tell the direction of a property: has, is, of, by and their like. A name of nothing
/// else keeps them.
[[nodiscard]] std::vector<std::string> words_of_property(std::string_view name);

/// How alike two words are, in [0, 1]: 1 for equal ones; less where few letters of long words differ; else 0.
[[nodiscard]] double likeness(std::string_view one, std::string_view other);

}  // namespace geminga::ontology

#endif
