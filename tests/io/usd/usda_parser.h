// A reader of USDA, independent of the writer, as far as what it writes goes.
#pragma once

#include <cctype>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace craze::test {

/// A prim: its properties as text, and its children.
struct UsdPrim {
  std::string type, name;
  std::map<std::string, std::string> metadata;
  std::map<std::string, std::string> values;  ///< "points" → "[(0, 0, 0), …]"
  std::map<std::string, std::string> types;   ///< "points" → "point3f[]"
  std::map<std::string, std::string> interpolation;
  std::vector<UsdPrim> children;

  const UsdPrim& at(const std::string& child) const {
    for (const UsdPrim& c : children) {
      if (c.name == child) return c;
    }
    throw std::out_of_range("no prim " + child + " in " + name);
  }
  /// All numbers of a value, in order.
  std::vector<double> numbers(const std::string& property) const {
    std::vector<double> all;
    const std::string& text = values.at(property);
    for (const char* p = text.c_str(); *p != 0;) {
      const bool begins = std::isdigit(static_cast<unsigned char>(*p)) || *p == '-';
      if (!begins) {
        ++p;
        continue;
      }
      char* end = nullptr;
      all.push_back(std::strtod(p, &end));
      p = end;
    }
    return all;
  }
};

class UsdaParser {
 public:
  explicit UsdaParser(std::string text) : text_(std::move(text)) {}

  /// The root, whose children are the file's prims. Throws std::runtime_error.
  UsdPrim parse() {
    UsdPrim root;
    if (text_.rfind("#usda 1.0\n", 0) != 0) fail("no magic line");
    at_ = 10;
    if (peek() == '(') root.metadata = parse_metadata();
    while (peek() != 0) root.children.push_back(parse_prim());
    return root;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(why + " at byte " + std::to_string(at_) + ": " +
                             text_.substr(at_, 40));
  }
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void expect(char c) {
    if (peek() != c) fail(std::string("expected ") + c);
    ++at_;
  }
  std::string word() {
    peek();
    std::string w;
    while (at_ < text_.size() && !std::isspace(static_cast<unsigned char>(text_[at_])) &&
           std::string("=()\"{}").find(text_[at_]) == std::string::npos) {
      w += text_[at_++];
    }
    if (w.empty()) fail("expected a word");
    return w;
  }
  /// A string, asset, path, tuple, array, dictionary or number.
  std::string value() {
    const char c = peek();
    const std::size_t begin = at_;
    if (c == '"' || c == '@' || c == '<') {
      const char end = c == '<' ? '>' : c;
      for (++at_; at_ < text_.size() && text_[at_] != end; ++at_) {
        if (c == '"' && text_[at_] == '\\') ++at_;
      }
      ++at_;
    } else if (c == '(' || c == '[' || c == '{') {
      int depth = 0;
      do {
        if (text_[at_] == '"') {
          value();
          continue;
        }
        depth += std::string("([{").find(text_[at_]) != std::string::npos;
        depth -= std::string(")]}").find(text_[at_]) != std::string::npos;
        ++at_;
      } while (depth > 0 && at_ < text_.size());
    } else {
      return word();
    }
    if (at_ > text_.size()) fail("the file ends in a value");
    return text_.substr(begin, at_ - begin);
  }
  std::map<std::string, std::string> parse_metadata() {
    std::map<std::string, std::string> metadata;
    expect('(');
    while (peek() != ')') {
      std::string key = word();
      if (key == "prepend") key = word();
      expect('=');
      metadata[key] = value();
      if (peek() == ';') ++at_;
    }
    expect(')');
    return metadata;
  }
  UsdPrim parse_prim() {
    UsdPrim prim;
    if (word() != "def") fail("expected def");
    prim.type = word();
    const std::string quoted = value();
    prim.name = quoted.substr(1, quoted.size() - 2);
    if (peek() == '(') prim.metadata = parse_metadata();
    expect('{');
    while (peek() != '}') {
      const std::size_t back = at_;
      std::string type = word();
      if (type == "def") {
        at_ = back;
        prim.children.push_back(parse_prim());
        for (std::size_t i = 0; i + 1 < prim.children.size(); ++i) {
          if (prim.children[i].name == prim.children.back().name) fail("a name is given twice");
        }
        continue;
      }
      if (type == "uniform") type = word();
      const std::string name = word();
      prim.types[name] = type;
      if (peek() != '=') continue;  // declared alone
      expect('=');
      if (!prim.values.emplace(name, value()).second) fail("a property is given twice");
      if (peek() == '(') prim.interpolation[name] = parse_metadata()["interpolation"];
    }
    expect('}');
    return prim;
  }

  std::string text_;
  std::size_t at_ = 0;
};

inline UsdPrim parse_usda(const std::string& text) {
  return UsdaParser(text).parse();
}

}  // namespace craze::test
