// The arrays of a compiled ontology, after every number in them has been checked.
#ifndef GEMINGA_EL_COMPILED_VIEW_HPP
#define GEMINGA_EL_COMPILED_VIEW_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "el/axiom.hpp"
#include "el/interval_index.hpp"
#include "el/ontology.hpp"

namespace geminga::el {

namespace compiled {
struct Ontology;
}

/// Spans into bytes that somebody else owns. Whatever is read through them is in range.
struct CompiledView {
  using Numbers = std::span<const std::uint32_t>;

  const compiled::Ontology* root = nullptr;  ///< for the strings of files and left-outs
  std::uint64_t digest = 0;
  bool is_consistent = true;
  std::string_view text;
  Numbers name_end;
  Numbers prefix_name;
  Numbers prefix_iri;
  Numbers class_name;
  Numbers class_label;
  Numbers representative;
  std::uint32_t thing = 0;
  std::uint32_t nothing = 0;
  Numbers parent_begin;
  Numbers parents;
  Numbers child_begin;
  Numbers children;
  std::span<const Interval> own_interval;
  Numbers further_begin;
  std::span<const Interval> further;
  Numbers label_text;
  Numbers label_class;
  std::span<const std::uint8_t> term_kind;
  Numbers term_name;
  Numbers term_number;
  Numbers term_begin;
  Numbers term_arguments;
  std::span<const std::uint8_t> axiom_kind;
  Numbers axiom_file;
  Numbers axiom_line;
  Numbers axiom_begin;
  Numbers axiom_arguments;

  /// No name.
  static constexpr std::uint32_t none = 0xffffffff;

  [[nodiscard]] std::string_view name(std::uint32_t number) const {
    const std::size_t begin = number == 0 ? 0 : name_end[number - 1];
    return text.substr(begin, name_end[number] - begin);
  }
  [[nodiscard]] std::uint32_t class_count() const { return static_cast<std::uint32_t>(class_name.size()); }
  [[nodiscard]] std::uint32_t term_count() const { return static_cast<std::uint32_t>(term_kind.size()); }
  [[nodiscard]] std::uint32_t axiom_count() const { return static_cast<std::uint32_t>(axiom_kind.size()); }
  [[nodiscard]] TermKind kind_of_term(std::uint32_t term) const { return static_cast<TermKind>(term_kind[term]); }
  [[nodiscard]] AxiomKind kind_of_axiom(std::uint32_t axiom) const { return static_cast<AxiomKind>(axiom_kind[axiom]); }
  [[nodiscard]] Numbers arguments_of_term(std::uint32_t term) const { return row(term_begin, term_arguments, term); }
  [[nodiscard]] Numbers arguments_of_axiom(std::uint32_t axiom) const {
    return row(axiom_begin, axiom_arguments, axiom);
  }
  [[nodiscard]] Numbers parents_of(std::uint32_t node) const { return row(parent_begin, parents, node); }
  [[nodiscard]] Numbers children_of(std::uint32_t node) const { return row(child_begin, children, node); }

 private:
  [[nodiscard]] static Numbers row(Numbers begin, Numbers items, std::uint32_t at) {
    return items.subspan(begin[at], begin[at + 1] - begin[at]);
  }
};

/// Checks a compiled file: frame, FlatBuffer, and every number. Linear in the file. `file` must be aligned to 8 bytes.
[[nodiscard]] std::expected<CompiledView, CompiledError> view_compiled(std::span<const std::byte> file);

[[nodiscard]] std::vector<LoadedFile> files_of(const CompiledView& view);
[[nodiscard]] std::vector<LeftOut> left_out_of(const CompiledView& view);

}  // namespace geminga::el

#endif
