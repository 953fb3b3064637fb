// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/man_page.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "checked/cli/version.hpp"

namespace oplus {

namespace {

/// A backslash and a hyphen mean something to roff, and so does what starts a line with a dot or a
/// quote.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

/// Lines that an editor shows, each escaped.
std::string prose(const std::string& text) {
  constexpr std::size_t longest = 72;
  std::string lines, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > longest) {
      lines += escaped(line) + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + escaped(line) + "\n";
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

/// A sentence of its own: "Print the sum."
std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.back() == '.' ? text : text + ".";
}

std::string head(const std::string& page, const std::string& what) {
  std::string small = what;
  small[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(small[0])));
  if (small.back() == '.') small.pop_back();
  return ".TH " + upper(escaped(page)) + " 1 " + version_date + " \"oplus " + version +
         "\" \"User Commands\"\n.SH NAME\n" + escaped(page) + " \\- " + escaped(small) + "\n";
}

std::string paragraph(const DescribedOption& option, bool is_argument) {
  std::string tag;
  for (const std::string& name : option.names)
    tag += (tag.empty() ? "" : ", ") + (is_argument ? italic(name) : bold(name));
  if (!is_argument && !option.value.empty()) tag += " " + italic(option.value);
  return ".TP\n" + tag + "\n" + prose(sentence(full_description(option)));
}

std::string section(const std::string& title, const std::vector<DescribedOption>& options,
                    bool are_arguments = false) {
  std::string text;
  for (const DescribedOption& option : options) text += paragraph(option, are_arguments);
  return text.empty() ? text : ".SH " + title + "\n" + text;
}

bool is_indented(const std::string& line) { return line.starts_with("  "); }

/// "  key  what it means"; empty key: no such line.
std::pair<std::string, std::string> key_and_meaning(const std::string& line) {
  const std::size_t key_end = line.find("  ", 2);
  if (!is_indented(line) || key_end == std::string::npos) return {};
  const std::size_t meaning = line.find_first_not_of(' ', key_end);
  if (meaning == std::string::npos) return {};
  return {line.substr(2, key_end - 2), line.substr(meaning)};
}

/// A footer, section by section.
std::string footer_sections(const std::string& footer) {
  std::string text;
  bool verbatim = false, starts_paragraph = true, in_entry = false;
  const auto set_verbatim = [&](bool wanted) {
    if (verbatim != wanted) text += wanted ? ".EX\n" : ".EE\n";
    verbatim = wanted;
  };
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    const auto [key, meaning] = key_and_meaning(line);
    in_entry = !key.empty() || (in_entry && line.starts_with("      "));
    if (line.empty()) {
      set_verbatim(false);
      starts_paragraph = true;
    } else if (!is_indented(line) && line.ends_with(':')) {
      set_verbatim(false);
      const std::string title = upper(line.substr(0, line.size() - 1));
      text += ".SH " +
              (title == "EXIT CODES" ? "EXIT STATUS"
               : title == "EXAMPLE"  ? "EXAMPLES"
                                     : title) +
              "\n";
      starts_paragraph = false;
    } else if (!key.empty()) {
      set_verbatim(false);
      text += ".TP\n" + bold(key) + "\n" + prose(meaning);
    } else if (in_entry && line.starts_with("      ")) {  // which goes on
      text += prose(line);
    } else if (is_indented(line)) {
      set_verbatim(true);
      text += escaped(line.substr(2)) + "\n";
    } else {
      set_verbatim(false);
      if (starts_paragraph) text += text.empty() ? ".SH NOTES\n" : ".PP\n";
      text += prose(line);
      starts_paragraph = false;
    }
  }
  set_verbatim(false);
  return text;
}

std::string reference(const std::string& page) { return ".BR " + escaped(page) + " (1)"; }

std::string see_also(const DescribedProgram& program) {
  std::string text = ".SH SEE ALSO\n" + reference(program.name);
  for (const DescribedCommand& command : program.commands)
    text += " ,\n" + reference(program.name + "-" + command.name);
  return text + "\n";
}

std::vector<DescribedOption> for_every_command(const DescribedProgram& program) {
  std::vector<DescribedOption> result = program.options;
  std::erase_if(result, [](const DescribedOption& option) {
    return std::find(option.names.begin(), option.names.end(), "--help") != option.names.end() ||
           option.names.front() == "--version";
  });
  return result;
}

}  // namespace

std::string man_page(const DescribedProgram& program) {
  std::string text = head(program.name, program.what) + ".SH SYNOPSIS\n" + bold(program.name) +
                     " [" + italic("OPTION") + "...] " + italic("COMMAND") + " [" +
                     italic("ARGUMENT") + "...]\n.SH DESCRIPTION\n" +
                     prose(sentence(program.what)) + ".SH COMMANDS\n";
  for (const DescribedCommand& command : program.commands)
    text += ".TP\n" + bold(command.name) + "\n" + prose(sentence(command.what));
  return text + section("OPTIONS", program.options) + footer_sections(program.footer) +
         see_also(program);
}

std::string man_page(const DescribedProgram& program, const DescribedCommand& command) {
  const std::string page = program.name + "-" + command.name;
  std::string text = head(page, command.what) + ".SH SYNOPSIS\n" + bold(program.name) + " " +
                     bold(command.name) + " [" + italic("OPTION") + "...]";
  for (const DescribedOption& argument : command.arguments) {
    const std::string name =
        italic(argument.names.front()) + (argument.repeats ? "..." : std::string());
    text += " " + (argument.required ? name : "[" + name + "]");
  }
  return text + "\n.SH DESCRIPTION\n" + prose(sentence(command.what)) +
         section("ARGUMENTS", command.arguments, true) + section("OPTIONS", command.options) +
         section("OPTIONS OF EVERY COMMAND", for_every_command(program)) +
         footer_sections(command.footer) + see_also(program);
}

}  // namespace oplus
