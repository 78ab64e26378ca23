// The sections of the compiled form, each written by its own function. compile.cpp puts them together.
#ifndef GEMINGA_REASONING_COMPILED_COMPILE_SECTIONS_HPP
#define GEMINGA_REASONING_COMPILED_COMPILE_SECTIONS_HPP

#include <cstdint>

#include "compiled_generated.h"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::compiled {

/// The most items of a list whose length is not known in advance: intervals, and axioms that wait for names. Both lists
/// are short unless the taxonomy is far from a tree.
inline constexpr std::size_t max_list_items = std::size_t{1} << 26;

/// No class, no term.
inline constexpr std::uint32_t none = base::NumberTable::none;

/// The input of all sections.
struct CompilerInput {
  const owl::Ontology& source;
  const taxonomy::Classification& classification;
  const owl::ContentHashes& hashes;
  const owl::CanonicalOrder& order;
};

/// Writes files, left-outs, gaps and prefixes.
void write_sources(const CompilerInput& input, const CompileOptions& options, form::TaxonomyT& out);
/// Writes classes, taxonomy and the index of intervals.
void write_classes(const CompilerInput& input, form::TaxonomyT& out);
void write_labels(const CompilerInput& input, form::LabelsT& out);
/// Writes the conversions between classes.
void write_conversions(const CompilerInput& input, form::TaxonomyT& out);
/// Writes the units that are declared, with their names, and what was left out of them.
void write_units(const CompilerInput& input, form::TaxonomyT& out);
/// Writes the signatures by which similar names are found. Classes and labels must have been written.
void write_signatures(const form::LabelsT& labels, form::TaxonomyT& out);
/// Writes names, terms, axioms and the tables of modules. The taxonomy must have been written. False if there would be
/// more than max_list_items, or more files than sixteen bits can count.
[[nodiscard]] bool write_axioms(const CompilerInput& input, const form::TaxonomyT& taxonomy, form::AxiomsT& out);

}  // namespace geminga::compiled

#endif
