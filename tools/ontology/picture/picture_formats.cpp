// Pictures in the languages of Graphviz and Mermaid.
#include "base/text.hpp"
#include "ontology/picture/picture.hpp"

namespace geminga::ontology {
namespace {

/// The characters of a line in a box. Most names are shorter; longer ones are broken at the beginning of a word.
constexpr std::size_t line_length = 22;

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '"' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}

/// Whether a line may be broken before this octet: before a capital that follows a small letter, and behind '_', '-',
/// '/', '#' and blanks. Never inside a character of several octets.
bool may_break(std::string_view text, std::size_t at) {
  const auto is = [&](std::size_t position, int (*kind)(int)) {
    return kind(static_cast<unsigned char>(text[position])) != 0;
  };
  if (is(at, std::isupper) && is(at - 1, std::islower)) return true;
  return std::string_view("_-/# ").find(text[at - 1]) != std::string_view::npos;
}

/// The lines of a name in a box.
std::vector<std::string> wrapped(std::string_view text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  std::size_t last_break = 0;
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (!may_break(text, at)) continue;
    if (at - begin > line_length && last_break > begin) {
      lines.emplace_back(text.substr(begin, last_break - begin));
      begin = last_break;
    }
    last_break = at;
  }
  if (text.size() - begin > line_length && last_break > begin) {
    lines.emplace_back(text.substr(begin, last_break - begin));
    begin = last_break;
  }
  lines.emplace_back(text.substr(begin));
  return lines;
}

/// Shortens a long `<IRI>` to its document and name behind an ellipsis: `<...usd.owl#Joint>`.
std::string without_path(const std::string& name) {
  if (!name.starts_with('<') || name.size() <= line_length) return name;
  const std::size_t slash = name.rfind('/', name.rfind('#'));
  return slash == std::string::npos ? name : "<\xe2\x80\xa6" + name.substr(slash + 1);
}

std::string hidden_label(const Box& box) { return "\xe2\x80\xa6 " + std::to_string(box.hidden_count) + " more"; }

/// The label of a box. Sets `is_broken` where a name is not shown in one line.
std::string dot_label(const Box& box, bool& is_broken) {
  std::string label;
  for (const std::string& name : box.names) {
    const std::string shown = without_path(name);
    const std::vector<std::string> lines = wrapped(shown);
    is_broken |= lines.size() > 1 || shown != name;
    label += label.empty() ? "" : "\\n= ";
    for (std::size_t line = 0; line < lines.size(); ++line) label += (line == 0 ? "" : "\\n") + escaped(lines[line]);
  }
  return label;
}

/// The label of a list: several names a line, the lines as long as those of a small paragraph.
std::string list_label(const Box& box) {
  constexpr std::size_t paragraph_length = 44;
  std::string label;
  std::size_t length = 0;
  for (std::size_t at = 0; at < box.names.size(); ++at) {
    const std::string name = without_path(box.names[at]);
    if (length > 0 && length + name.size() > paragraph_length) {
      label += "\\l";
      length = 0;
    } else if (length > 0) {
      label += "  ";
    }
    label += escaped(name) + (at + 1 < box.names.size() ? "," : "");
    length += name.size() + 3;
  }
  return label + "\\l";
}

/// The attributes beside the label. A broken name has the whole name as its tooltip, so that it can be searched for.
std::string dot_attributes(const Box& box, bool is_broken) {
  std::string attributes;
  if (is_broken) attributes += ", tooltip=\"" + escaped(base::joined(box.names, " = ")) + '"';
  switch (box.kind) {
    case BoxKind::one:
      break;
    case BoxKind::leaves:
      attributes += ", style=filled, fillcolor=\"#fbfbfd\", color=\"#b9c2d3\", fontsize=10";
      break;
    case BoxKind::several:
      attributes += ", fillcolor=\"#e3ecdb\", color=\"#6d8554\"";
      break;
    case BoxKind::unsatisfiable:
      attributes += ", fillcolor=\"#f9dcd6\", color=\"#a8412f\", fontcolor=\"#7d2416\"";
      break;
    case BoxKind::hidden:
      attributes += ", shape=plaintext, style=\"\", fontcolor=\"#6b7280\"";
      break;
  }
  return attributes;
}

/// Escapes by character references, which alone are special inside the quotes of Mermaid.
std::string for_mermaid(std::string_view name) {
  std::string safe;
  for (const char c : name) {
    if (std::string_view("\"<>&#;").find(c) != std::string_view::npos) {
      safe += '#' + std::to_string(static_cast<int>(c)) + ';';
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::string as_dot(const Picture& picture) {
  std::string text =
      "digraph taxonomy {\n  rankdir=RL;\n  ranksep=0.45;\n  nodesep=0.09;\n  bgcolor=white;\n"
      "  node [shape=box, style=\"rounded,filled\", fillcolor=\"#f4f6fa\", color=\"#5b6b8c\", fontname=\"Helvetica\", "
      "fontsize=11, height=0.26, margin=\"0.09,0.035\"];\n"
      "  edge [color=\"#8896b3\", arrowhead=empty, arrowsize=0.55, headport=e, tailport=w];\n";
  for (const Box& box : picture) {
    bool is_broken = false;
    const std::string label = box.kind == BoxKind::hidden   ? hidden_label(box)
                              : box.kind == BoxKind::leaves ? list_label(box)
                                                            : dot_label(box, is_broken);
    text.append("  ").append(box.id).append(" [label=\"").append(label).append("\"");
    text.append(dot_attributes(box, is_broken)).append("];\n");
  }
  for (const Box& box : picture) {
    const std::string style = box.kind == BoxKind::hidden ? " [style=dotted, arrowhead=none]" : "";
    for (const std::string& parent : box.parents)
      text.append("  ").append(box.id).append(" -> ").append(parent).append(style).append(";\n");
  }
  return text + "}\n";
}

std::string as_mermaid(const Picture& picture) {
  std::string text = "graph RL\n";
  std::string unsatisfiable;
  std::string hidden;
  for (const Box& box : picture) {
    text += "  " + box.id + "[\"";
    if (box.kind == BoxKind::hidden) text += hidden_label(box);
    for (std::size_t name = 0; name < box.names.size(); ++name)
      text += (name == 0 ? "" : box.kind == BoxKind::leaves ? "<br/>" : "<br/>= ") + for_mermaid(box.names[name]);
    text += "\"]\n";
    if (box.kind == BoxKind::unsatisfiable) unsatisfiable += (unsatisfiable.empty() ? "" : ",") + box.id;
    if (box.kind == BoxKind::hidden) hidden += (hidden.empty() ? "" : ",") + box.id;
  }
  for (const Box& box : picture) {
    for (const std::string& parent : box.parents)
      text += "  " + box.id + (box.kind == BoxKind::hidden ? " -.- " : " --> ") + parent + "\n";
  }
  if (!unsatisfiable.empty())
    text += "  classDef unsatisfiable fill:#f9dcd6,stroke:#a8412f,color:#7d2416\n  class " + unsatisfiable +
            " unsatisfiable\n";
  if (!hidden.empty()) text += "  classDef hidden fill:none,stroke:none,color:#6b7280\n  class " + hidden + " hidden\n";
  return text;
}

}  // namespace geminga::ontology
