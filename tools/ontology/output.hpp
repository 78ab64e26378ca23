// Where what a command makes goes: a file that is replaced as a whole, or standard output.
#ifndef GEMINGA_ONTOLOGY_OUTPUT_HPP
#define GEMINGA_ONTOLOGY_OUTPUT_HPP

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::ontology {

/// Behind -o: standard output, and no file is written at all.
inline constexpr std::string_view to_standard_output = "-";

/// Adds `-o OUT`, required, and `--to FORMAT`.
void add_output(CLI::App& command, std::string& out, std::string& format);
/// Adds `--memory-limit`.
void add_memory_limit(CLI::App& command, Choice& choice);
/// Adds it and a `--time-limit` beyond which nothing is written, for those that search for nothing.
void add_run_limits(CLI::App& command, Choice& choice);

/// Writes it, or says why it cannot.
[[nodiscard]] Exit put(const std::string& out, std::span<const std::byte> bytes);

/// Whether writing would destroy what was read, under whatever name.
[[nodiscard]] bool is_source(const std::string& target, const std::vector<std::string>& files,
                             const owl::Ontology& source);

}  // namespace geminga::ontology

#endif
