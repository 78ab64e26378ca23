// The axioms that can matter for a question: a module by bottom locality, found by walking from names to axioms.
#ifndef GEMINGA_REASONING_MODULES_MODULE_HPP
#define GEMINGA_REASONING_MODULES_MODULE_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "reasoning/modules/module_locality.hpp"
#include "reasoning/taxonomy/class_number.hpp"
#include "reasoning/taxonomy/classified_view.hpp"

namespace geminga::modules {

/// Leads from each name to the axioms that wait for it (module_locality.hpp). Its tables are part of the compiled form,
/// so that making one costs nothing. The view must have axioms, and must outlive it.
class ModuleIndex {
 public:
  explicit ModuleIndex(const taxonomy::ClassifiedView& view);

  [[nodiscard]] const taxonomy::ClassifiedView& view() const { return *view_; }
  [[nodiscard]] const BuiltIn& built_in() const { return built_in_; }
  /// How often each term is an argument.
  [[nodiscard]] std::span<const std::uint32_t> uses() const { return view_->uses; }
  /// The axioms to test when this entity enters the signature.
  [[nodiscard]] std::span<const std::uint32_t> axioms_of(std::uint32_t entity) const {
    return view_->axioms_waiting_for(entity);
  }
  /// Axioms that are local for no signature: facts, and axioms about everything.
  [[nodiscard]] std::span<const std::uint32_t> unconditional() const { return view_->unconditional; }
  /// The term of a class; nothing if no axiom uses it.
  [[nodiscard]] std::optional<std::uint32_t> term_of(taxonomy::ClassNumber number) const;

 private:
  const taxonomy::ClassifiedView* view_;
  BuiltIn built_in_;
};

/// The tables of a module index, as the compiled form keeps them.
struct ModuleTables {
  std::vector<std::uint32_t> built_in;  ///< in the order of BuiltIn
  std::vector<std::uint32_t> uses;
  std::vector<std::uint32_t> term_of_class;
  std::vector<std::uint32_t> waiting_begin;
  std::vector<std::uint32_t> waiting;
  std::vector<std::uint32_t> unconditional;
};

/// Makes the tables of a view that has no tables yet. One pass over its axioms.
[[nodiscard]] ModuleTables make_module_tables(const taxonomy::ClassifiedView& view);

/// The axioms of the module for these classes and terms, by number. They include every minimal set that entails an
/// axiom over this signature, or that one of the classes is below any named class. The walk reaches near axioms first,
/// and the result is in this order. It ends after `most` axioms: then it is the beginning of the module. Declarations
/// are not among them. The cost is that of the reached axioms, and one bit for each term and axiom of the ontology.
[[nodiscard]] std::vector<std::uint32_t> extract_module(const ModuleIndex& index,
                                                        std::span<const taxonomy::ClassNumber> classes,
                                                        std::span<const std::uint32_t> more_terms = {},
                                                        std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace geminga::modules

#endif
