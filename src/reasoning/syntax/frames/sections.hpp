// The words with a colon in a document: those that begin its head, frames, and the sections of frames.
#ifndef GEMINGA_REASONING_SYNTAX_FRAMES_SECTIONS_HPP
#define GEMINGA_REASONING_SYNTAX_FRAMES_SECTIONS_HPP

#include <cstdint>
#include <span>
#include <string_view>

#include "reasoning/owl/axiom.hpp"

namespace geminga::frames {

/// All of them, sorted.
[[nodiscard]] std::span<const std::string_view> section_words();
/// Whether a word begins a frame, an axiom outside of frames, a rule or an import.
[[nodiscard]] bool begins_frame(std::string_view word);

/// The kind of members in a section's list.
enum class Member : std::uint8_t {
  class_expression,
  object_property,
  data_property,
  annotation_property,
  iri,
  data_range,
  individual,
};

/// Which frames a section may stand in.
enum class Frame : std::uint8_t {
  of_class,
  of_object_property,
  of_data_property,
  of_annotation_property,
  of_datatype,
  of_individual,
};

/// A section in which each member makes one axiom of two arguments.
struct Section {
  Frame frame = Frame::of_class;
  std::string_view word;
  Member member = Member::class_expression;
  owl::AxiomKind kind = owl::AxiomKind::sub_class_of;
  bool is_axiom = true;          ///< false: about annotation properties, which mean nothing to a reasoner
  bool is_subject_last = false;  ///< the frame's subject is the second argument
};

/// The section of a word in a frame. nullptr if it is not one of these simple sections.
[[nodiscard]] const Section* find_section(Frame frame, std::string_view word);

/// A characteristic of properties, `Transitive`; is_data: of data properties.
struct Characteristic {
  std::string_view word;
  owl::AxiomKind kind = owl::AxiomKind::functional_object_property;
};
[[nodiscard]] const Characteristic* find_characteristic(std::string_view word, bool is_data);

}  // namespace geminga::frames

#endif
