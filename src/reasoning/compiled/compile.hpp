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

/// How the line of the gaps begins that says what they leave open.
inline constexpr std::string_view undecided_words = "undecided: ";

/// What the source and its classification do not say.
struct CompileOptions {
  /// Why something may be missing although its axioms were used, one line each, as they are to be kept.
  std::span<const std::string> gaps;
  /// The folder of the file that is written, of folder_of(); paths of sources are relative to it. Empty: they stay as
  /// they are.
  std::string folder;
};

/// The bytes of the compiled form. Equal for the same axioms, labels, prefixes, files and options, whatever their
/// order. Empty where they would be more than max_compiled_bytes; Ontology refuses that.
[[nodiscard]] std::vector<std::byte> compile(const owl::Ontology& source,
                                             const taxonomy::Classification& classification,
                                             const CompileOptions& options = {});

}  // namespace geminga::compiled

#endif
