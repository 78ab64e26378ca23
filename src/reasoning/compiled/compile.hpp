// Writes the compiled form of a classified ontology (format: COMPILED.md), which Ontology reads.
#ifndef GEMINGA_REASONING_COMPILED_COMPILE_HPP
#define GEMINGA_REASONING_COMPILED_COMPILE_HPP

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::compiled {

/// How the line among the gaps begins that says which classes are undecided.
inline constexpr std::string_view undecided_words = "undecided: ";
/// Begins each line of `geminga-ontology compile` about a file that it left out.
inline constexpr std::string_view left_out_words = "left out: ";

/// Parts to write beside the source and its classification.
struct CompileOptions {
  /// Why something may be missing although its axioms were used, one line each.
  std::span<const std::string> gaps;
  /// The folder of the file that is written, as folder_of() gives it. Paths of sources become relative to it. Empty:
  /// they stay as they are.
  std::string folder;
};

/// The octets of the compiled form. They are equal for the same axioms, labels, prefixes, files and options, whatever
/// their order. Empty if they would be more than max_compiled_bytes; Ontology refuses that.
[[nodiscard]] std::vector<std::byte> compile(const owl::Ontology& source,
                                             const taxonomy::Classification& classification,
                                             const CompileOptions& options = {});

}  // namespace geminga::compiled

#endif
