// From the sections of a compiled ontology to its arrays, after every number in them has been checked.
#ifndef GEMINGA_REASONING_COMPILED_COMPILED_VIEW_HPP
#define GEMINGA_REASONING_COMPILED_COMPILED_VIEW_HPP

#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/compiled/compiled_error.hpp"
#include "reasoning/compiled/container.hpp"
#include "reasoning/compiled/units_view.hpp"
#include "reasoning/taxonomy/classified_view.hpp"
#include "reasoning/taxonomy/conversion.hpp"

namespace geminga::owl {
struct LeftOut;
struct LoadedFile;
}  // namespace geminga::owl

namespace geminga::compiled {

namespace form {
struct Taxonomy;
}

/// The first section of a file: the taxonomy, and the strings of files, left-outs, gaps and prefixes.
struct TaxonomySection {
  const form::Taxonomy* root = nullptr;
  taxonomy::ClassifiedView view;
};

/// The labels of classes, ascending. Each label has its classes, and each class the label to show.
struct LabelsView {
  std::string_view text;
  taxonomy::ClassifiedView::Numbers end;
  taxonomy::ClassifiedView::Numbers class_begin;
  taxonomy::ClassifiedView::Numbers classes;
  taxonomy::ClassifiedView::Numbers label_of_class;

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(end.size()); }
  [[nodiscard]] std::string_view label(std::uint32_t at) const {
    return taxonomy::ClassifiedView::piece(text, end, at);
  }
};

/// Views the taxonomy of a file whose first section is whole, after checking the FlatBuffer and every number in it.
/// Linear in the section.
[[nodiscard]] std::expected<TaxonomySection, CompiledError> view_taxonomy(const Container& file);
/// Views the labels, after verifying their section. Linear in it.
[[nodiscard]] std::expected<LabelsView, CompiledError> view_labels(const Container& file,
                                                                   const taxonomy::ClassifiedView& taxonomy);
/// Views the taxonomy with terms and axioms, after verifying their section. Linear in it.
[[nodiscard]] std::expected<taxonomy::ClassifiedView, CompiledError> view_axioms(const Container& file,
                                                                                 const TaxonomySection& taxonomy);

[[nodiscard]] std::vector<owl::LoadedFile> files_of(const TaxonomySection& taxonomy);
[[nodiscard]] std::vector<owl::LeftOut> left_out_of(const TaxonomySection& taxonomy);
[[nodiscard]] std::vector<std::string> gaps_of(const TaxonomySection& taxonomy);
/// Pairs of a prefix without its colon and an IRI, ascending.
[[nodiscard]] std::vector<std::pair<std::string_view, std::string_view>> prefixes_of(const TaxonomySection& taxonomy);
/// Two for each class, of its local name and of its label (similar.hpp). Empty if the file has none.
[[nodiscard]] std::span<const std::uint64_t> signatures_of(const TaxonomySection& taxonomy);
/// Which representation can be turned into which, ascending by pairs of classes.
[[nodiscard]] std::span<const taxonomy::Conversion> conversions_of(const TaxonomySection& taxonomy);
/// The units that are declared; none in a file that has no such arrays.
[[nodiscard]] UnitsView units_of(const TaxonomySection& taxonomy);
/// The units that were left out, by reason.
[[nodiscard]] std::vector<owl::LeftOut> units_left_out_of(const TaxonomySection& taxonomy);
/// The number of different axioms, without declarations.
[[nodiscard]] std::uint32_t counted_axioms(const TaxonomySection& taxonomy);

}  // namespace geminga::compiled

#endif
