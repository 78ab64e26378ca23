// Ontologies written in tests: a few lines of functional-style syntax, and what follows from them as text.
#ifndef GEMINGA_TESTS_SUPPORT_WRITTEN_HPP
#define GEMINGA_TESTS_SUPPORT_WRITTEN_HPP

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// Reads one axiom a line, e.g. `SubClassOf(A ObjectSomeValuesFrom(r B))`; line numbers are those of the text, `#` is a
/// comment. Upper case names are classes, lower case ones object properties, `d:x` data properties, `i:x` individuals,
/// `_:x` blank nodes, `x:integer` XML Schema datatypes, `"1"^x:integer` literals, numbers are cardinalities. `Thing`
/// and `Nothing` are OWL's; other names are in `t:` = https://t.example/#. An unreadable text fails the test.
Ontology written(std::string_view text, const std::string& path = "written.ofn");
/// Adds to a source.
void write_into(Ontology& source, std::string_view text, const std::string& path);

/// The same, classified.
taxonomy::Classification classified(const Ontology& source);
/// The same, compiled and read back.
compiled::Ontology loaded(const Ontology& source);
compiled::Ontology loaded(std::string_view text);

/// Every subsumption between different named classes other than T and F as `A < B`, sorted; of unsatisfiable classes
/// only `A < Nothing`; of equivalents of T also `Thing < A`. Only `inconsistent` if the ontology is.
std::vector<std::string> closure(const compiled::Ontology& ontology);
std::vector<std::string> closure(std::string_view text);

/// The knowledge of a team of robots about balls: an equivalence, two ways up, and a class that can have no instance.
inline constexpr std::string_view robots =
    "SubClassOf(BallInfo TrackedObject)\n"
    "SubClassOf(SharedBallInfo BallInfo)\n"
    "SubClassOf(TrackedObject Info)\n"
    "SubClassOf(SharedBallInfo Shared)\n"
    "SubClassOf(Shared Info)\n"
    "EquivalentClasses(Ball BallInfo)\n"
    "DisjointClasses(Shared Secret)\n"
    "SubClassOf(Impossible Shared)\n"
    "SubClassOf(Impossible Secret)\n";

/// `t:Name` of a class.
taxonomy::ClassNumber named(const compiled::Ontology& ontology, std::string_view name);

}  // namespace geminga::owl

#endif
