// The most that one document in Manchester syntax may hold.
#ifndef GEMINGA_REASONING_SYNTAX_FRAMES_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_FRAMES_LIMITS_HPP

#include <cstddef>

#include "reasoning/syntax/manchester/limits.hpp"

namespace geminga::frames {

/// A file that exceeds one of these is refused, with the line. The limits of owl::SourceLimits hold as well.
struct FrameLimits {
  std::size_t file_bytes = std::size_t{1} << 30;
  /// Of one IRI, written out.
  std::size_t iri_bytes = 8192;
  /// Of one text, after its escapes.
  std::size_t literal_bytes = std::size_t{1} << 20;
  /// Of one expression: levels, and names and values. The reader descends once for each level.
  manchester::ExpressionLimits expression{.text_bytes = 0, .nesting = 512, .parts = 1'000'000};
  /// Annotations of annotations.
  std::size_t annotation_levels = 512;
  std::size_t prefixes = 10'000;
  std::size_t imports = 10'000;
  /// Sections and frames with a fault, each of which is left out by name.
  std::size_t wrong_parts = 1000;
};

}  // namespace geminga::frames

#endif
