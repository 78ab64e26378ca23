// Units as the compiled form has them.
#include <algorithm>
#include <memory>

#include "reasoning/compiled/compile_sections.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::compiled {

void write_units(const CompilerInput& input, form::TaxonomyT& out) {
  const owl::DeclaredUnits declared = owl::units_of(input.source);
  for (const owl::DeclaredUnit& unit : declared.units) {
    const auto symbol = std::ranges::lower_bound(declared.names, unit.symbol, {}, &owl::UnitName::text);
    const bool is_named = !unit.symbol.empty() && symbol != declared.names.end() && symbol->text == unit.symbol;
    out.unit_factor.push_back(unit.factor);
    out.unit_offset.push_back(unit.offset);
    out.unit_dimension.insert(out.unit_dimension.end(), unit.dimension.begin(), unit.dimension.end());
    out.unit_alone.push_back(unit.alone.value_or(none));
    out.unit_symbol.push_back(is_named ? static_cast<std::uint32_t>(symbol - declared.names.begin()) : none);
  }
  for (const owl::UnitName& name : declared.names) {
    out.unit_text.insert(out.unit_text.end(), name.text.begin(), name.text.end());
    out.unit_name_end.push_back(static_cast<std::uint32_t>(out.unit_text.size()));
    out.unit_of_name.push_back(name.unit);
  }
  std::vector<std::uint32_t> number_of_file(input.source.files().size(), none);
  for (std::uint32_t number = 0; number < input.order.files.size(); ++number) {
    number_of_file[static_cast<std::size_t>(input.order.files[number])] = number;
  }
  for (const owl::LeftOut& left : declared.left_out) {
    auto entry = std::make_unique<form::LeftOutT>();
    entry->construct = left.construct;
    entry->count = left.count;
    entry->file = left.file < number_of_file.size() ? number_of_file[left.file] : none;
    entry->line = left.line;
    out.units_left_out.push_back(std::move(entry));
  }
}

}  // namespace geminga::compiled
