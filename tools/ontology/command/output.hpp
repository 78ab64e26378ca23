// The output of a command: a file that is replaced as a whole, or standard output.
#ifndef GEMINGA_ONTOLOGY_COMMAND_OUTPUT_HPP
#define GEMINGA_ONTOLOGY_COMMAND_OUTPUT_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/command/exit_status.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::ontology {

/// The name of standard output behind -o. No file is written then.
inline constexpr std::string_view to_standard_output = "-";

/// Writes the output, or says why it cannot be written.
[[nodiscard]] Exit put(const std::string& out, std::span<const std::byte> bytes);

/// Takes the next piece of an output; false: it cannot be written.
using PutPiece = std::function<bool(std::string_view piece)>;
/// Writes an output piece by piece. `write` returns why there is none, in one line; then a file stays as it was, and
/// only standard output may have got a part.
[[nodiscard]] Exit put_pieces(const std::string& out,
                              const std::function<std::optional<std::string>(const PutPiece&)>& write);

/// Says so and returns true where writing to `out` would destroy a file that was read, under whatever name. `flag` is
/// the one behind which `out` stands.
[[nodiscard]] bool would_destroy_source(const std::string& out, const std::vector<std::string>& files,
                                        const owl::Ontology& source, std::string_view flag = "-o");

}  // namespace geminga::ontology

#endif
