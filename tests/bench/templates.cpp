// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/templates.hpp"
#include "properties/runner/source_tree.hpp"

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace oplus {

namespace {

using Text = kainjow::mustache::mustache::string_type;

std::string template_named(const std::string& name) {
  const std::string path = source_root() / "tests/bench/pages" / name;
  std::ifstream file(path);
  if (!file) throw std::invalid_argument("cannot open " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The library itself leaves out unknown names.
class Known : public kainjow::mustache::context<Text> {
 public:
  using context::context;

  const PageData* get(const Text& name) const override {
    const PageData* found = context::get(name);
    if (found == nullptr) throw std::invalid_argument("unknown name {{" + name + "}}");
    return found;
  }

  const PageData* get_partial(const Text& name) const override {
    std::string text = template_named(name + ".mustache");
    text.pop_back();  // the including line has its own line end
    return &partials_.try_emplace(name, text).first->second;
  }

 private:
  mutable std::map<Text, PageData> partials_;
};

}  // namespace

PageData page_data(const std::vector<std::string>& texts) {
  return kainjow::mustache::list(texts.begin(), texts.end());
}

PageData page_data(const Table& table) {
  kainjow::mustache::list rows;
  for (const auto& cells : table.rows) rows.emplace_back("cells", page_data(cells));
  return kainjow::mustache::object{{"head", page_data(table.head)}, {"rows", rows}};
}

PageData table_section(const Rows& rows, const std::vector<std::string>& names) {
  return PageData([=](const Text& text) {
    std::vector<Column> columns;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::vector<std::string> once{""};
      for (const std::string& name : line.find('*') == std::string::npos ? once : names)
        for (const Column& column : columns_of(std::regex_replace(line, std::regex("\\*"), name)))
          columns.push_back(column);
    }
    std::string table = rendered("markdown_table.mustache", page_data(table_of(rows, columns)));
    table.pop_back();  // the section's last line has its own line end
    return table;
  });
}

std::string rendered_text(const std::string& text, const PageData& data) {
  kainjow::mustache::mustache page(text);
  page.set_custom_escape([](const Text& any) { return any; });
  Known context(&data);
  std::string result = page.render(context);
  if (!page.is_valid()) throw std::invalid_argument(page.error_message());
  return result;
}

std::string rendered(const std::string& name, const PageData& data) {
  return rendered_text(template_named(name), data);
}

}  // namespace oplus
