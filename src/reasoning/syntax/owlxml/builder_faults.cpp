// Faults against the grammar of OWL/XML in files that are well-formed XML. Each costs the annotation or the axiom that
// it stands in, which is named, and nothing else of the file.
#include <algorithm>
#include <utility>

#include "reasoning/syntax/owlxml/builder.hpp"

namespace geminga::owlxml {
namespace {

/// Different faults of one file that have names of their own.
constexpr std::size_t max_named_faults = 250;

}  // namespace

Listener::Refusal Builder::beyond_limit(std::string text) {
  is_beyond_limit_ = true;
  return text;
}

Listener::Refusal Builder::settle(Refusal refusal, std::uint32_t line) {
  if (!refusal || is_beyond_limit_) return refusal;
  // The outermost annotation around it; without one, what stands directly below <Ontology>.
  const auto annotation =
      std::ranges::find_if(open_.begin() + 1, open_.end(), [](const Open& open) { return open.is_annotation; });
  const std::size_t depth = annotation == open_.end() ? 1 : static_cast<std::size_t>(annotation - open_.begin());
  fault_ = Fault{depth, std::move(*refusal), line};
  return std::nullopt;
}

void Builder::end_fault(const Open& open) {
  operands_.resize(open.first);
  std::string_view text = fault_->text;
  if (named_faults_.size() >= max_named_faults && !named_faults_.contains(text)) text = "and others";
  if (text == fault_->text) named_faults_.emplace(text);
  if (open.is_annotation) {
    source_.remark("an annotation that cannot be read (" + std::string(text) + ")", file_, fault_->line);
  } else {
    source_.leave_out("an axiom that cannot be read (" + std::string(text) + ")", file_, fault_->line);
  }
  if (open_.size() == 1) {
    annotations_.drop();
  } else {
    annotations_.drop_from(open.annotations);
  }
  fault_.reset();
}

void Builder::remark(std::string_view text, std::uint32_t line) { source_.remark(text, file_, line); }

}  // namespace geminga::owlxml
