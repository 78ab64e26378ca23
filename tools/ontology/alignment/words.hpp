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

/// The words of a class, with what it is as the last one, as English compounds have it: "Head_of_Department" is
/// department, head.
[[nodiscard]] std::vector<std::string> words_of_class(std::string_view name);

/// The same of a property, without the words that tell its direction: has, is, of, by and their like. A name of nothing
/// else keeps them.
[[nodiscard]] std::vector<std::string> words_of_property(std::string_view name);

/// The preposition at the end of a property's name, by which "hasPart" differs from "isPartOf"; empty without one.
[[nodiscard]] std::string preposition_of(std::string_view name);

/// How alike two words are, in [0, 1]: 1 for equal ones; less where few letters of long words differ; else 0.
[[nodiscard]] double likeness(std::string_view one, std::string_view other);

}  // namespace geminga::ontology

#endif
