// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
//
// embed_kernels --root DIR --out FILE.cpp [-I DIR]... KERNEL.cl...
//
// Makes one self-contained OpenCL source of each KERNEL.cl and writes them all into one C++ file (see
// lib/core/kernels.hpp). #include "x" is looked for beside the including file, then in each -I, then in the root; -I is
// relative to the root. #include <x> stays as it is: only host code, between #ifndef __OPENCL_VERSION__, may have it.
//
// A header is pasted once per program. Where an #include stands under a condition other than the file's own include
// guard, the text may be skipped by the compiler, so it does not count as pasted, and the header's guard does that work.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string &message) {
  std::cerr << "embed_kernels: " << message << "\n";
  std::exit(1);
}

std::string trim(const std::string &s) {
  const size_t first = s.find_first_not_of(" \t\r");
  return first == std::string::npos ? std::string() : s.substr(first, s.find_last_not_of(" \t\r") - first + 1);
}

// The directive's name if the line is one ("#  include" gives "include"); rest gets what follows it.
std::string directive(const std::string &line, std::string &rest) {
  const std::string s = trim(line);
  if (s.empty() || s[0] != '#')
    return {};
  const std::string body = trim(s.substr(1));
  size_t end = 0;
  while (end < body.size() && std::isalpha(static_cast<unsigned char>(body[end])))
    ++end;
  rest = trim(body.substr(end));
  return body.substr(0, end);
}

class Program {
public:
  Program(fs::path root, std::vector<fs::path> search) : root_(std::move(root)), search_(std::move(search)) {}

  std::string make(const fs::path &file) {
    paste(fs::canonical(file), false);
    return text_;
  }

private:
  std::string shown(const fs::path &file) const { return file.lexically_relative(root_).generic_string(); }

  fs::path find(const std::string &name, const fs::path &from, size_t line) const {
    std::vector<fs::path> places{from.parent_path()};
    places.insert(places.end(), search_.begin(), search_.end());
    places.push_back(root_);
    for (const fs::path &place : places)
      if (fs::is_regular_file(place / name))
        return fs::canonical(place / name);
    fail(shown(from) + ":" + std::to_string(line) + ": \"" + name + "\" was not found");
  }

  void paste(const fs::path &file, bool conditional) {
    if (pasted_.count(file))
      return;
    if (std::find(open_.begin(), open_.end(), file) != open_.end()) {
      if (conditional)
        return; // a guarded header that includes itself by way of another
      fail(shown(file) + " includes itself");
    }
    open_.push_back(file);
    if (!conditional)
      pasted_.insert(file);

    std::ifstream in(file, std::ios::binary);
    if (!in)
      fail("cannot read " + shown(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);

    const int guard = has_guard(lines) ? 1 : 0;
    int depth = 0;
    text_ += "#line 1 \"" + shown(file) + "\"\n";
    for (size_t i = 0; i < lines.size(); ++i) {
      std::string rest;
      const std::string word = directive(lines[i], rest);
      if (word == "if" || word == "ifdef" || word == "ifndef")
        ++depth;
      else if (word == "endif")
        --depth;

      if (word == "include" && !rest.empty() && rest[0] == '"') {
        const size_t end = rest.find('"', 1);
        if (end == std::string::npos)
          fail(shown(file) + ":" + std::to_string(i + 1) + ": #include without a closing quote");
        const size_t before = text_.size();
        paste(find(rest.substr(1, end - 1), file, i + 1), conditional || depth > guard);
        text_ += text_.size() == before ? "\n" : "#line " + std::to_string(i + 2) + " \"" + shown(file) + "\"\n";
      } else if (word == "pragma" && rest == "once") {
        text_ += "\n";
      } else {
        text_ += lines[i] + "\n";
      }
    }
    open_.pop_back();
  }

  // The first directive is #ifndef X and the next #define X.
  static bool has_guard(const std::vector<std::string> &lines) {
    std::string name;
    for (const std::string &line : lines) {
      std::string rest;
      const std::string word = directive(line, rest);
      if (word.empty())
        continue;
      if (name.empty()) {
        if (word != "ifndef")
          return false;
        name = rest;
      } else {
        return word == "define" && rest.compare(0, name.size(), name) == 0;
      }
    }
    return false;
  }

  fs::path root_;
  std::vector<fs::path> search_;
  std::vector<fs::path> open_;
  std::set<fs::path> pasted_;
  std::string text_;
};

uint64_t fnv1a(const std::string &text) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text)
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

// One literal per line of text; octal escapes end after three digits, so what follows cannot extend them.
void write_literal(std::ostream &out, const std::string &text) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    out << "    \"";
    for (const char c : line) {
      const unsigned char u = static_cast<unsigned char>(c);
      if (c == '"' || c == '\\' || c == '?' || u < 0x20 || u >= 0x7f) {
        char octal[8];
        std::snprintf(octal, sizeof octal, "\\%03o", static_cast<unsigned>(u));
        out << octal;
      } else {
        out << c;
      }
    }
    out << "\\n\"\n";
  }
}

} // namespace

int main(int argc, char **argv) {
  fs::path root, out;
  std::vector<fs::path> search, kernels;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const bool takes_value = arg == "--root" || arg == "--out" || arg == "-I";
    if (takes_value && i + 1 == argc)
      fail(arg + " needs a value");
    if (arg == "--root")
      root = fs::canonical(argv[++i]);
    else if (arg == "--out")
      out = argv[++i];
    else if (arg == "-I")
      search.push_back(root / argv[++i]);
    else
      kernels.push_back(arg);
  }
  if (root.empty() || out.empty())
    fail("usage: embed_kernels --root DIR --out FILE.cpp [-I DIR]... KERNEL.cl...");
  std::sort(kernels.begin(), kernels.end(),
            [](const fs::path &a, const fs::path &b) { return a.stem().string() < b.stem().string(); });

  std::ostringstream code;
  code << "// Written by cmake/embed_kernels.cpp; do not edit.\n"
          "#include \"core/kernels.hpp\"\n\nnamespace tyn {\n\nconst KernelSource kernel_sources[] = {\n";
  for (const fs::path &kernel : kernels) {
    const std::string text = Program(root, search).make(kernel);
    char hash[24];
    std::snprintf(hash, sizeof hash, "0x%016llxu", static_cast<unsigned long long>(fnv1a(text)));
    code << "  {\"" << kernel.stem().string() << "\",\n";
    write_literal(code, text);
    code << "    , " << text.size() << ", " << hash << "},\n";
  }
  if (kernels.empty())
    code << "  {\"\", \"\", 0, 0},\n";
  code << "};\nconst size_t kernel_source_count = " << kernels.size() << ";\n\n} // namespace tyn\n";

  std::ofstream file(out, std::ios::binary);
  file << code.str();
  file.close();
  if (!file)
    fail("cannot write " + out.string());
  return 0;
}
