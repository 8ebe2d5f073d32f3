// Runs an intersect function of yours on hard cases with exact answers (C++17):
//
//     #include "graze_cases.hpp"
//     int main(int argc, char** argv) { return graze::run(argc, argv, my_intersect); }
//
//     ./program cases.json [--junit FILE] [--report FILE] [--ulps N]
//
// `npm run cases` writes cases.json. The function gets the shape, and origin and direction; it
// returns every t of the whole line, ascending, a tangent once. For a kind that it does not know
// it throws graze::Unknown: the case is skipped. A case fails if the number of roots is wrong, or
// a root is off by more than N units in the last place, counted from the double that is nearest
// to the exact root. The exit code is 1 where a case failed, 2 where the file cannot be read.
#pragma once
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace graze {

using Vec3 = std::array<double, 3>;

struct Shape {
  std::string kind;
  std::map<std::string, Vec3> vectors;       // center, vertex, normal, point, corner
  std::map<std::string, double> numbers;     // radius, slope, flare, width, side
  std::map<std::string, std::string> words;  // axis
};

struct Unknown : std::exception {};

using Intersect = std::function<std::vector<double>(const Shape&, const Vec3&, const Vec3&)>;

// As much JSON as the file has.
struct Json {
  enum Type { text, number, list, object } type = text;
  std::string words;
  double value = 0;
  std::vector<Json> items;
  std::vector<std::pair<std::string, Json>> fields;

  const Json& at(const std::string& key) const {
    for (const auto& field : fields)
      if (field.first == key) return field.second;
    throw std::runtime_error("no " + key);
  }
};

class Reader {
 public:
  explicit Reader(const std::string& source) : at_(source.c_str()) {}

  Json read() {
    Json found;
    const char first = peek();
    if (first == '{') {
      found.type = Json::object;
      for (bool more = enter('}'); more; more = next('}')) {
        std::string key = string();
        expect(':');
        found.fields.emplace_back(key, read());
      }
    } else if (first == '[') {
      found.type = Json::list;
      for (bool more = enter(']'); more; more = next(']')) found.items.push_back(read());
    } else if (first == '"') {
      found.words = string();
    } else {
      char* end = nullptr;
      found.type = Json::number;
      found.value = std::strtod(at_, &end);
      if (end == at_) throw std::runtime_error(std::string("a value is missing before ") + first);
      at_ = end;
    }
    return found;
  }

 private:
  char peek() {
    while (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t') ++at_;
    return *at_;
  }
  void expect(char wanted) {
    if (peek() != wanted) throw std::runtime_error(std::string("expected ") + wanted);
    ++at_;
  }
  bool enter(char end) {
    ++at_;
    if (peek() != end) return true;
    ++at_;
    return false;
  }
  bool next(char end) {
    if (peek() == end) {
      ++at_;
      return false;
    }
    expect(',');
    return true;
  }
  std::string string() {
    expect('"');
    std::string found;
    for (; *at_ != '"'; ++at_) {
      if (*at_ == '\0') throw std::runtime_error("a text does not end");
      if (*at_ == '\\') ++at_;
      found += *at_;
    }
    ++at_;
    return found;
  }
  const char* at_;
};

struct Result {
  std::string id, family, state, words;
  double ulps;
};

inline Vec3 vector(const Json& json) {
  return {json.items.at(0).value, json.items.at(1).value, json.items.at(2).value};
}

inline Shape shape(const Json& json) {
  Shape found;
  for (const auto& [key, value] : json.fields) {
    if (key == "kind") found.kind = value.words;
    else if (value.type == Json::list) found.vectors[key] = vector(value);
    else if (value.type == Json::number) found.numbers[key] = value.value;
    else found.words[key] = value.words;
  }
  return found;
}

inline double ulps_off(double t, double exact) {
  const double infinite = std::numeric_limits<double>::infinity();
  if (!std::isfinite(t) || !std::isfinite(exact)) return infinite;
  const double size = std::fabs(exact);
  const double place = size < std::numeric_limits<double>::max()
                           ? std::nextafter(size, infinite) - size
                           : size - std::nextafter(size, 0.0);
  return std::fabs(t - exact) / place;
}

inline Result judge(const Json& one, const Intersect& intersect, double most) {
  const Json& ray = one.at("ray");
  const std::string name = one.at("class").words;
  const std::size_t wanted = name == "two" ? 2 : name == "tangent" || name == "one" ? 1 : 0;
  Result result{one.at("id").words, one.at("family").words, "failed", "", 0};
  std::vector<double> found;
  try {
    found = intersect(shape(one.at("shape")), vector(ray.at("origin")), vector(ray.at("direction")));
  } catch (const Unknown&) {
    result.state = "skipped";
    return result;
  } catch (const std::exception& error) {  // what their program throws is its answer
    result.words = error.what();
    return result;
  }
  if (found.size() != wanted) {
    result.words = std::to_string(found.size()) + " roots, exactly " + std::to_string(wanted) +
                   " (" + name + ")";
    return result;
  }
  for (std::size_t k = 0; k < wanted; ++k) {
    const double exact = std::strtod(one.at("hits").items[k].at("t").words.c_str(), nullptr);
    result.ulps = std::fmax(result.ulps, ulps_off(found[k], exact));
  }
  if (result.ulps <= most) result.state = "passed";
  else result.words = "off by " + std::to_string(result.ulps) + " ulps";
  return result;
}

inline std::string escaped(const std::string& words) {
  std::string found;
  for (const char c : words) {
    if (c == '&') found += "&amp;";
    else if (c == '<') found += "&lt;";
    else if (c == '"') found += "&quot;";
    else found += c;
  }
  return found;
}

inline int count(const std::vector<Result>& results, const std::string& state) {
  int found = 0;
  for (const Result& one : results) found += one.state == state ? 1 : 0;
  return found;
}

inline void junit(const std::string& file, const std::vector<Result>& results) {
  std::ofstream out(file);
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"graze\" tests=\""
      << results.size() << "\" failures=\"" << count(results, "failed") << "\" skipped=\""
      << count(results, "skipped") << "\">\n";
  for (const Result& one : results) {
    out << "  <testcase classname=\"" << one.family << "\" name=\"" << one.id << "\"";
    if (one.state == "passed") out << "/>\n";
    else if (one.state == "skipped") out << "><skipped/></testcase>\n";
    else out << "><failure message=\"" << escaped(one.words) << "\"/></testcase>\n";
  }
  out << "</testsuite>\n";
}

inline void report(const std::string& file, const std::vector<Result>& results) {
  std::vector<std::string> families;
  std::map<std::string, std::vector<Result>> own;
  for (const Result& one : results) {
    if (own[one.family].empty()) families.push_back(one.family);
    own[one.family].push_back(one);
  }
  std::ofstream out(file);
  out << "| family | cases | wrong | skipped | ulps: worst of the right ones | first that is wrong |\n"
      << "| --- | ---: | ---: | ---: | ---: | --- |\n";
  for (const std::string& family : families) {
    double worst = 0;
    std::string first;
    for (const Result& one : own[family]) {
      if (one.state == "passed") worst = std::fmax(worst, one.ulps);
      if (one.state == "failed" && first.empty()) first = one.id + ": " + one.words;
    }
    out << "| " << family << " | " << own[family].size() << " | " << count(own[family], "failed")
        << " | " << count(own[family], "skipped") << " | " << worst << " | " << first << " |\n";
  }
}

inline int run(int argc, char** argv, const Intersect& intersect) {
  std::map<std::string, std::string> options{{"--ulps", "4503599627370496"}};
  std::string file;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.rfind("--", 0) == 0 && i + 1 < argc) options[word] = argv[++i];
    else file = word;
  }
  try {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot be read");
    const std::string source{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const Json given = Reader(source).read();
    if (given.at("graze").words != "hard-cases" || given.at("version").value != 1)
      throw std::runtime_error("has no hard cases of version 1");
    std::vector<Result> results;
    const double most = std::strtod(options["--ulps"].c_str(), nullptr);
    for (const Json& one : given.at("cases").items) results.push_back(judge(one, intersect, most));
    if (options.count("--junit")) junit(options["--junit"], results);
    if (options.count("--report")) report(options["--report"], results);
    const int failed = count(results, "failed");
    std::cout << count(results, "passed") << " passed, " << failed << " failed, "
              << count(results, "skipped") << " skipped\n";
    return failed ? 1 : 0;
  } catch (const std::exception& error) {
    std::cerr << file << ": " << error.what() << "\n";
    return 2;
  }
}

}  // namespace graze
