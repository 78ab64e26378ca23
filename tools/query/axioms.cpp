#include "query/axioms.hpp"

#include <algorithm>
#include <iostream>
#include <string>

#include "shell/report.hpp"

namespace geminga::query {

void print_axioms(const Context& context, const Answer& answer) {
  std::size_t widest = 0;
  for (const auto& record : answer.records) {
    widest = std::max(widest, shell::width(shell::printable(record["axiom"])));
  }
  for (const auto& record : answer.records) {
    const std::string axiom = shell::printable(record["axiom"]);
    const std::string place = shell::printable(std::string(record["file"]) + ':' + std::string(record["line"]));
    std::cout << "  " << axiom << std::string(widest - shell::width(axiom) + 2, ' ')
              << coloured(context.terminal, shell::Colour::dim, place) << '\n';
  }
}

}  // namespace geminga::query
