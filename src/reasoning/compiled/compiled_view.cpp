// From sections to spans: each is a FlatBuffer, verified, then checked number by number.
#include "reasoning/compiled/compiled_view.hpp"

#include <bit>

#include "compiled_generated.h"
#include "reasoning/compiled/compiled_checks.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::compiled {
namespace {

static_assert(std::endian::native == std::endian::little, "the compiled form is read in place");
static_assert(sizeof(taxonomy::Interval) == sizeof(form::Interval));
static_assert(sizeof(taxonomy::Reach) == sizeof(form::Reach));
static_assert(sizeof(taxonomy::EquivalentMember) == sizeof(form::Member));
static_assert(sizeof(taxonomy::Conversion) == sizeof(form::Conversion));

template <typename Element>
std::span<const std::uint32_t> numbers(const flatbuffers::Vector<Element>* vector) {
  return {reinterpret_cast<const std::uint32_t*>(vector->Data()), vector->size()};
}
template <typename Ours, typename Theirs>
std::span<const Ours> structs(const flatbuffers::Vector<const Theirs*>* vector) {
  static_assert(sizeof(Ours) == sizeof(Theirs));
  return {reinterpret_cast<const Ours*>(vector->Data()), vector->size()};
}
std::span<const std::uint8_t> octets(const flatbuffers::Vector<std::uint8_t>* vector) {
  return {vector->Data(), vector->size()};
}
std::string_view text(const flatbuffers::Vector<std::uint8_t>* vector) {
  return {reinterpret_cast<const char*>(vector->Data()), vector->size()};
}

/// An array that older files do not have.
template <typename Number>
std::span<const Number> optional_array(const flatbuffers::Vector<Number>* vector) {
  return vector == nullptr ? std::span<const Number>()
                           : std::span<const Number>(reinterpret_cast<const Number*>(vector->Data()), vector->size());
}

std::vector<owl::LeftOut> read_left_out(const flatbuffers::Vector<flatbuffers::Offset<form::LeftOut>>* entries) {
  std::vector<owl::LeftOut> left_out;
  if (entries == nullptr) return left_out;
  for (const form::LeftOut* left : *entries) {
    left_out.push_back({left->construct()->str(), left->count(), {}, left->file(), left->line()});
  }
  return left_out;
}

/// The root of a section.
template <typename Root>
std::expected<const Root*, CompiledError> root_of(const Container& file, Section section) {
  constexpr flatbuffers::uoffset_t max_depth = 4;
  constexpr flatbuffers::uoffset_t max_tables = 1'000'000;  // files and the like; all else is in flat arrays
  const std::span<const std::byte> bytes = file.section(section);
  const auto* begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
  flatbuffers::Verifier verifier(begin, bytes.size(), max_depth, max_tables);
  if (bytes.empty() || !verifier.VerifyBuffer<Root>(nullptr)) {
    return std::unexpected(CompiledError{"the compiled ontology is damaged: its " + std::string(to_string(section)) +
                                         " at offset " + std::to_string(bytes.data() - file.file().data()) +
                                         " are no FlatBuffer of the schema: compile it again"});
  }
  return flatbuffers::GetRoot<Root>(begin);
}

}  // namespace

std::expected<TaxonomySection, CompiledError> view_taxonomy(const Container& file) {
  const auto found = root_of<form::Taxonomy>(file, Section::taxonomy);
  if (!found) return std::unexpected(found.error());
  const form::Taxonomy& root = **found;
  taxonomy::ClassifiedView view;
  view.digest = root.digest();
  view.is_consistent = root.is_consistent();
  view.class_text = text(root.class_text());
  view.class_end = numbers(root.class_end());
  view.representative = numbers(root.representative());
  view.thing = root.thing();
  view.nothing = root.nothing();
  view.members = structs<taxonomy::EquivalentMember>(root.members());
  view.parent_begin = numbers(root.parent_begin());
  view.parents = numbers(root.parents());
  view.child_begin = numbers(root.child_begin());
  view.children = numbers(root.children());
  view.reach = structs<taxonomy::Reach>(root.reach());
  view.further = structs<taxonomy::Interval>(root.further());
  Checker check(file.file());
  check_taxonomy(view, check);
  const TaxonomySection section{&root, view};
  if (!check.failed()) check_conversions(conversions_of(section), view, check);
  if (!check.failed()) check_units(units_of(section), check);
  if (check.failed()) return std::unexpected(check.error());
  return section;
}

std::expected<LabelsView, CompiledError> view_labels(const Container& file, const taxonomy::ClassifiedView& taxonomy) {
  if (auto whole = file.verify(Section::labels); !whole) return std::unexpected(whole.error());
  const auto found = root_of<form::Labels>(file, Section::labels);
  if (!found) return std::unexpected(found.error());
  const form::Labels& root = **found;
  const LabelsView labels{text(root.text()), numbers(root.end()), numbers(root.class_begin()), numbers(root.classes()),
                          numbers(root.label_of_class())};
  Checker check(file.file());
  check_labels(labels, taxonomy, check);
  if (check.failed()) return std::unexpected(check.error());
  return labels;
}

std::expected<taxonomy::ClassifiedView, CompiledError> view_axioms(const Container& file,
                                                                   const TaxonomySection& taxonomy) {
  if (auto whole = file.verify(Section::axioms); !whole) return std::unexpected(whole.error());
  const auto found = root_of<form::Axioms>(file, Section::axioms);
  if (!found) return std::unexpected(found.error());
  const form::Axioms& root = **found;
  taxonomy::ClassifiedView view = taxonomy.view;
  view.term_text = text(root.text());
  view.name_end = numbers(root.name_end());
  view.term_kind = octets(root.term_kind());
  view.term_word = numbers(root.term_word());
  view.term_begin = numbers(root.term_begin());
  view.term_arguments = numbers(root.term_arguments());
  view.axiom_kind = octets(root.axiom_kind());
  view.axiom_file = {reinterpret_cast<const std::uint16_t*>(root.axiom_file()->Data()), root.axiom_file()->size()};
  view.axiom_line = numbers(root.axiom_line());
  view.axiom_begin = numbers(root.axiom_begin());
  view.axiom_arguments = numbers(root.axiom_arguments());
  view.unused_axiom = numbers(root.unused_axiom());
  view.unused_group = numbers(root.unused_group());
  view.built_in = numbers(root.built_in());
  view.uses = numbers(root.uses());
  view.term_of_class = numbers(root.term_of_class());
  view.waiting_begin = numbers(root.waiting_begin());
  view.waiting = numbers(root.waiting());
  view.unconditional = numbers(root.unconditional());
  Checker check(file.file());
  check_axioms(view, taxonomy.root->files()->size(), taxonomy.root->left_out()->size(), check);
  if (check.failed()) return std::unexpected(check.error());
  return view;
}

std::vector<owl::LoadedFile> files_of(const TaxonomySection& taxonomy) {
  std::vector<owl::LoadedFile> files;
  for (const form::File* file : *taxonomy.root->files())
    files.push_back({file->path()->str(), file->ontology_iri()->str(), {file->size(), file->hash()}});
  return files;
}

std::vector<owl::LeftOut> left_out_of(const TaxonomySection& taxonomy) {
  return read_left_out(taxonomy.root->left_out());
}

std::vector<std::string> gaps_of(const TaxonomySection& taxonomy) {
  std::vector<std::string> gaps;
  for (const flatbuffers::String* gap : *taxonomy.root->gaps()) gaps.push_back(gap->str());
  return gaps;
}

std::vector<std::pair<std::string_view, std::string_view>> prefixes_of(const TaxonomySection& taxonomy) {
  std::vector<std::pair<std::string_view, std::string_view>> prefixes;
  for (const form::Prefix* prefix : *taxonomy.root->prefixes())
    prefixes.emplace_back(prefix->prefix()->string_view(), prefix->iri()->string_view());
  std::ranges::sort(prefixes);
  return prefixes;
}

std::span<const std::uint64_t> signatures_of(const TaxonomySection& taxonomy) {
  const auto* const signatures = taxonomy.root->signatures();
  if (signatures == nullptr) return {};
  return {reinterpret_cast<const std::uint64_t*>(signatures->Data()), signatures->size()};
}

std::span<const taxonomy::Conversion> conversions_of(const TaxonomySection& taxonomy) {
  const auto* const conversions = taxonomy.root->conversions();
  return conversions == nullptr ? std::span<const taxonomy::Conversion>() : structs<taxonomy::Conversion>(conversions);
}

UnitsView units_of(const TaxonomySection& taxonomy) {
  const form::Taxonomy& root = *taxonomy.root;
  UnitsView view;
  view.factor = optional_array(root.unit_factor());
  view.offset = optional_array(root.unit_offset());
  view.dimension = optional_array(root.unit_dimension());
  view.alone = optional_array(root.unit_alone());
  view.symbol = optional_array(root.unit_symbol());
  const auto names = optional_array(root.unit_text());
  view.text = {reinterpret_cast<const char*>(names.data()), names.size()};
  view.name_end = optional_array(root.unit_name_end());
  view.unit_of_name = optional_array(root.unit_of_name());
  return view;
}

std::vector<owl::LeftOut> units_left_out_of(const TaxonomySection& taxonomy) {
  return read_left_out(taxonomy.root->units_left_out());
}

std::uint32_t counted_axioms(const TaxonomySection& taxonomy) { return taxonomy.root->axioms(); }

}  // namespace geminga::compiled
