// The axioms that can matter for a question: a module by bottom locality, found by walking from names to axioms.
#ifndef GEMINGA_REASONING_MODULES_MODULE_HPP
#define GEMINGA_REASONING_MODULES_MODULE_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/modules/module_locality.hpp"
#include "reasoning/taxonomy/class_number.hpp"
#include "reasoning/taxonomy/classified_view.hpp"

namespace geminga::modules {

/// Leads from each name to the axioms that wait for it; see module_locality.hpp. It is part of the compiled form, so
/// that making one costs nothing. The view must have axioms, and must outlive it.
class ModuleIndex {
 public:
  explicit ModuleIndex(const taxonomy::ClassifiedView& view);

  [[nodiscard]] const taxonomy::ClassifiedView& view() const { return *view_; }
  [[nodiscard]] const BuiltIn& built_in() const { return built_in_; }
  /// How often a term is an argument.
  [[nodiscard]] std::span<const std::uint32_t> uses() const { return view_->uses; }
  /// The axioms to test when this entity enters the signature.
  [[nodiscard]] std::span<const std::uint32_t> axioms_of(std::uint32_t entity) const {
    return view_->axioms_waiting_for(entity);
  }
  /// Axioms that are local for no signature: facts, and what is said of everything.
  [[nodiscard]] std::span<const std::uint32_t> unconditional() const { return view_->unconditional; }
  /// The term of a class; nothing where no axiom uses it.
  [[nodiscard]] std::optional<std::uint32_t> term_of(taxonomy::ClassNumber number) const;

 private:
  const taxonomy::ClassifiedView* view_;
  BuiltIn built_in_;
};

/// What a module index is made of, as the compiled form keeps it.
struct ModuleTables {
  std::vector<std::uint32_t> built_in;  ///< in the order of BuiltIn
  std::vector<std::uint32_t> uses;
  std::vector<std::uint32_t> term_of_class;
  std::vector<std::uint32_t> waiting_begin;
  std::vector<std::uint32_t> waiting;
  std::vector<std::uint32_t> unconditional;
};

/// Makes the tables of a view that has everything but them. A pass over its axioms.
[[nodiscard]] ModuleTables make_module_tables(const taxonomy::ClassifiedView& view);

/// The numbers of axioms that include every minimal set that entails anything about these classes and terms, also that
/// one of these classes is below any named class. Their order is that in which the walk reaches them, so that near
/// axioms come first. Declarations are not among them. The cost is that of what is reached, and one bit for each term
/// and axiom of the ontology.
[[nodiscard]] std::vector<std::uint32_t> extract_module(const ModuleIndex& index,
                                                        std::span<const taxonomy::ClassNumber> classes,
                                                        std::span<const std::uint32_t> more_terms = {});

}  // namespace geminga::modules

#endif
