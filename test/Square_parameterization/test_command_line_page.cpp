// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"
#include "test_command_line_closed.h"

#include <cstring>

// The page of --report: what it holds is read back and measured here; check_page.py opens it in a browser.

namespace {

/// what stands in the script element with an identifier
std::string script(const std::string& page, const std::string& id)
{
  const std::size_t found = page.find("id='" + id + "'>");
  REQUIRE(found != std::string::npos);
  const std::size_t first = page.find('>', found) + 1;
  return page.substr(first, page.find("</script>", first) - first);
}

std::string base64_decoded(const std::string& letters)
{
  static const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned int bits = 0;
  int count = 0;
  for(char letter : letters)
    if(letter != '=') {
      const std::size_t value = alphabet.find(letter);
      REQUIRE(value != std::string::npos);
      bits = bits << 6 | static_cast<unsigned int>(value);
      if((count += 6) >= 8)
        bytes += static_cast<char>(bits >> (count -= 8) & 255u);
    }
  return bytes;
}

struct Page
{
  explicit Page(const std::string& html)
    : text(html), data(nlohmann::json::parse(script(html, "page"))), bytes(base64_decoded(script(html, "arrays")))
  {}

  template <class Number>
  std::vector<Number> array(const std::string& name) const
  {
    for(const nlohmann::json& place : data["arrays"])
      if(place["name"] == name) {
        std::vector<Number> numbers(place["size"].get<std::size_t>());
        const std::size_t offset = place["offset"].get<std::size_t>();
        REQUIRE(offset % sizeof(Number) == 0);
        REQUIRE(offset + numbers.size() * sizeof(Number) <= bytes.size());
        std::memcpy(numbers.data(), bytes.data() + offset, numbers.size() * sizeof(Number));
        return numbers;
      }
    FAIL("the page has no array " << name);
    return {};
  }

  /// the map that the page draws
  Map map(const std::string& uv_name) const
  {
    Map map;
    const auto points = array<float>("points"), uv = array<float>(uv_name);
    const auto triangles = array<unsigned int>("triangles");
    for(std::size_t v = 0; 3 * v < points.size(); ++v) {
      map.points.push_back({points[3 * v], points[3 * v + 1], points[3 * v + 2]});
      map.uv.push_back({uv[2 * v], uv[2 * v + 1]});
    }
    for(std::size_t f = 0; 3 * f < triangles.size(); ++f)
      map.faces.push_back({long(triangles[3 * f]), long(triangles[3 * f + 1]), long(triangles[3 * f + 2])});
    return map;
  }

  std::string text;
  nlohmann::json data;
  std::string bytes;
};

Page make_page(const Soup& soup, const Arguments& options = {}, const std::string& name = "in.off")
{
  const Temporary_folder folder;
  const Finished_process result =
      square_map(Arguments{folder.add(name, off(soup)), "--report", folder / "page.html"} + options);
  INFO(result.err);
  REQUIRE(result.status == DONE);
  return Page(read_file(folder / "page.html"));
}

} // namespace

TEST_CASE("a page holds the best map and that of the first candidate")
{
  for(const Soup& soup : {sheet(12, 5), soup_of(ellipsoid(3, 2)), soup_of(torus(16, 12))}) {
    const Page page = make_page(soup);
    CAPTURE(page.data["report"].dump(1));
    // 32 bits tell seven digits of a place, and fewer of what is computed from it
    const Measures best = measure(page.map("places"));
    CHECK(best.flipped == 0);
    CHECK(page.data["report"]["best"]["l2"].get<double>() == Approx(double(best.l2)).epsilon(1e-4));
    REQUIRE(page.data["first"].is_object());
    const Measures first = measure(page.map("places_first"));
    CHECK(first.flipped == 0);
    CHECK(page.data["first"]["l2"].get<double>() == Approx(double(first.l2)).epsilon(1e-4));
    // it is the candidate that the search knows, minimised to the end
    const nlohmann::json& sample = page.data["report"]["curve"][0];
    REQUIRE(sample["candidate"] == 0);
    CHECK(page.data["first"]["l2"].get<double>() == Approx(sample["l2"].get<double>()).epsilon(0.01));
    CHECK(page.data["first"]["input_corners"] != page.data["report"]["best"]["input_corners"]);
    CHECK(page.array<float>("stretch").size() == page.map("places").faces.size());
    CHECK(page.array<float>("stretch_first").size() == page.map("places").faces.size());
  }
}

TEST_CASE("a page draws both maps on their rectangles")
{
  const Page page = make_page(sheet(12, 5), {"--aspect", "best"});
  for(const auto& [name, report] :
      {std::make_pair("places", page.data["report"]["best"]), std::make_pair("places_first", page.data["first"])}) {
    CAPTURE(name);
    const Map map = page.map(name);
    std::array<double, 2> largest{};
    for(const auto& [x, y] : map.uv)
      largest = {std::max(largest[0], std::abs(double(x))), std::max(largest[1], std::abs(double(y)))};
    CHECK(largest[0] / largest[1] == Approx(report["aspect"].get<double>()).epsilon(1e-6));
    CHECK(4 * largest[0] * largest[1] == Approx(1).epsilon(1e-6));
    CHECK(double(measure(map).l2) == Approx(report["l2"].get<double>()).epsilon(1e-4));
  }
  CHECK(page.data["report"]["best"]["aspect"] != page.data["first"]["aspect"]);
}

TEST_CASE("the first candidate is said to be the best where its corners are")
{
  int moved = 0;
  for(int columns = 4; columns < 12; ++columns) {
    CAPTURE(columns);
    const Page page = make_page(sheet(columns, 4), {"--aspect", "best"});
    const nlohmann::json& best = page.data["report"]["best"];
    const bool is_first = best["candidate"] == 0 && best["has_moved_corners"] == false;
    CHECK((page.data["no_first"] == "The first candidate is the best.") == is_first);
    CHECK(page.data["first"].is_object() == !is_first);
    if(best["candidate"] == 0 && !is_first) {
      ++moved;
      CHECK(page.data["first"]["input_corners"] != best["input_corners"]);
    }
  }
  CHECK(moved > 0);
}

TEST_CASE("the border of a page has the two sides of every seam")
{
  const Page page = make_page(soup_of(torus(16, 12)));
  const auto ends = page.array<unsigned int>("border");
  const auto seams = page.array<int>("seam");
  const auto points = page.array<float>("points");
  REQUIRE(ends.size() == 2 * seams.size());
  CHECK(seams.size() == page.data["report"]["conditioned"]["border_edges"]);
  typedef std::array<float, 3> Place;
  std::map<std::set<Place>, std::vector<int>> sides;
  for(std::size_t e = 0; e < seams.size(); ++e) {
    std::set<Place> edge;
    for(std::size_t v : {ends[2 * e], ends[2 * e + 1]})
      edge.insert({points[3 * v], points[3 * v + 1], points[3 * v + 2]});
    sides[edge].push_back(seams[e]);
  }
  for(const auto& [edge, numbers] : sides) {
    CHECK(numbers.size() == 2); // the surface is closed
    CHECK(numbers.front() == numbers.back());
    CHECK(numbers.front() >= 0);
  }
  for(int seam : make_page(small).array<int>("seam"))
    CHECK(seam == -1);
}

TEST_CASE("a page is the same for any number of threads, and asks for nothing")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(soup_of(ellipsoid(3, 2))));
  for(const char* threads : {"1", "2"})
    REQUIRE(square_map({input, "--report", folder / (threads + std::string(".html")), "--threads", threads}).status ==
            DONE);
  const std::string page = read_file(folder / "1.html");
  CHECK(page == read_file(folder / "2.html"));
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(page.find("The MIT License") != std::string::npos);
  for(const char* request : {"src=\"", "src='", "<link", "<img", "@import", "url("})
    CHECK(page.find(request) == std::string::npos);
}

TEST_CASE("a page without another candidate says why")
{
  const Page given = make_page(small, {"--corners", corner_option({0, 6, 34, 28})});
  CHECK(given.data["first"].is_null());
  CHECK(given.data["no_first"].get<std::string>().find("corners were given") != std::string::npos);
  const Page first = make_page(small, {"--strategy", "none"});
  CHECK(first.data["first"].is_null());
  CHECK(first.data["no_first"] == "The first candidate is the best.");
  CHECK(first.text.find("id='curve'") == std::string::npos);
}

TEST_CASE("the name of a file cannot end the scripts of a page")
{
  const std::string name = "<script>alert(1)< \" & ' \\u003c.off";
  const Page page = make_page(small, {}, name);
  const std::string file = page.data["report"]["input"]["file"];
  CHECK(file.substr(file.size() - name.size()) == name);
  CHECK(page.text.find("alert(1)<") == std::string::npos);
}

TEST_CASE("a page of another name is refused")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  for(const std::string& name : {folder / "page.pdf", folder / "page", std::string("-")})
    check_refusal(folder, {input, "--report", name}, BAD_COMMAND_LINE, "must end in .html or .htm");
  check_refusal(folder, {input, "--report", folder / "a.html", "--svg", folder / "a.html"}, BAD_COMMAND_LINE,
                "are the same file");
}
