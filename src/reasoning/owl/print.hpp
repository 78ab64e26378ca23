// Axioms as a person reads them: Manchester-like, with short names.
#ifndef GEMINGA_REASONING_OWL_PRINT_HPP
#define GEMINGA_REASONING_OWL_PRINT_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// How an IRI is written: `soccer:BallInfo` or `<https://...>`.
using ShortName = std::function<std::string(std::string_view iri)>;

/// Terms that are printed for reading before "..." stands for the rest.
inline constexpr std::size_t max_printed_terms = 2'000;

enum class PrintStyle : std::uint8_t {
  reading,   ///< on one line: line ends in literals are written \n, \r, \t
  parsing,   ///< so that manchester::parse() reads the same term again
  document,  ///< the same for frames::read(): an anonymous individual is named by ShortName, too
};

/// "soccer:Camera and (core:observes some soccer:Ball)".
[[nodiscard]] std::string print(const Ontology& source, TermId term, const ShortName& short_name,
                                PrintStyle style = PrintStyle::reading);
/// "soccer:SharedBallInfo SubClassOf soccer:BallInfo".
[[nodiscard]] std::string print(const Ontology& source, const Axiom& axiom, const ShortName& short_name);

/// Whether a name may stand behind the colon of a short name: not empty, of letters, digits, `_`, `-` and `.`, with no
/// `.` or `-` at its beginning and no `.` at its end.
[[nodiscard]] bool is_plain_local_name(std::string_view name);

/// A text in quotation marks, with a backslash before each quotation mark and backslash in it.
[[nodiscard]] std::string quoted(std::string_view text);

/// `prefix:local` by the longest prefix IRI that leaves a plain local name, else `<iri>`. A prefix with two IRIs is not
/// used. `prefixes` are pairs of a word and an IRI, sorted.
[[nodiscard]] std::string shorten(std::string_view iri,
                                  std::span<const std::pair<std::string_view, std::string_view>> prefixes);

}  // namespace geminga::owl

#endif
