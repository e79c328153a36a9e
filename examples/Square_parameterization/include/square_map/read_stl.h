// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_STL_H
#define SQUARE_MAP_READ_STL_H

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include "Byte_scanner.h"
#include "Passed_over.h"
#include "Text_scanner.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace square_map {

// CGAL's reader takes keywords in lower case alone, a file that is cut off in its first facet as an empty one, and the
// word facet in the name of a solid as a facet.

/// the triangles of an STL file, whose corners with equal coordinates are one point. Points are numbered as they come.
class Stl_facets
{
public:
  /// makes room for a number of facets, which a file must be large enough to hold
  void reserve(std::size_t facets)
  {
    m_soup.faces.reserve(facets);
    m_indices.reserve(facets / 2); // as many as the points of a closed surface
  }

  void add(const std::array<std::array<double, 3>, 3>& corners)
  {
    std::vector<std::size_t>& face = m_soup.faces.emplace_back();
    face.reserve(3);
    for(const auto& corner : corners) {
      if(!std::all_of(corner.begin(), corner.end(), [](double x) { return std::isfinite(x); }))
        throw Malformed_file("facet " + std::to_string(size() - 1) + " has a coordinate that is not finite");
      face.push_back(index_of(corner));
    }
  }

  std::size_t size() const { return m_soup.faces.size(); }

  CGAL_ext::internal::Surface_soup& soup() { return m_soup; }

private:
  /// coordinates of four bytes leave half of the bits of a double zero: a product spreads the others
  struct Hash
  {
    std::size_t operator()(const std::array<double, 3>& p) const
    {
      std::uint64_t hash = 0;
      for(const double& x : p) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
      }
      return static_cast<std::size_t>(hash);
    }
  };

  std::size_t index_of(std::array<double, 3> p)
  {
    const auto [found, is_new] = m_indices.emplace(std::array<double, 3>{p[0] + 0., p[1] + 0., p[2] + 0.}, // -0 is 0
                                                   m_soup.points.size());
    if(is_new)
      m_soup.points.emplace_back(p[0], p[1], p[2]);
    return found->second;
  }

  CGAL_ext::internal::Surface_soup m_soup;
  std::unordered_map<std::array<double, 3>, std::size_t, Hash> m_indices;
};

constexpr std::size_t STL_HEADER_BYTES = 84, STL_FACET_BYTES = 50;

/// the number of facets that the header of a binary STL file gives
inline std::size_t binary_stl_size(std::string_view bytes)
{
  Byte_scanner scanner(bytes, boost::endian::order::little);
  scanner.skip(STL_HEADER_BYTES - sizeof(std::uint32_t), "the header of facet", 0);
  return scanner.next<std::uint32_t>("the header of facet", 0);
}

/// indicates whether the bytes are as many as the header of a binary STL file promises
inline bool has_size_of_binary_stl(std::string_view bytes)
{
  return bytes.size() >= STL_HEADER_BYTES &&
         bytes.size() == STL_HEADER_BYTES + STL_FACET_BYTES * binary_stl_size(bytes);
}

/// reads a binary STL file: little-endian. What follows the last facet is added to \p passed_over.
inline CGAL_ext::internal::Surface_soup read_binary_stl(std::string_view bytes, Passed_over& passed_over)
{
  const std::size_t facets = binary_stl_size(bytes);
  Byte_scanner scanner(bytes.substr(STL_HEADER_BYTES), boost::endian::order::little);
  Stl_facets result;
  result.reserve(std::min(facets, scanner.bytes_left() / STL_FACET_BYTES));
  for(std::size_t f = 0; f < facets; ++f) {
    if(scanner.bytes_left() < STL_FACET_BYTES)
      throw Malformed_file("it is incomplete: it ends in facet " + std::to_string(f) + " of " + std::to_string(facets));
    scanner.skip(3 * sizeof(float), "facet", f); // the normal
    std::array<std::array<double, 3>, 3> corners{};
    for(auto& corner : corners)
      for(double& x : corner)
        x = scanner.next<float>("facet", f);
    scanner.skip(sizeof(std::uint16_t), "facet", f);
    result.add(corners);
  }
  if(facets > 0)
    pass_over_rest("bytes", scanner.bytes_left(), "facet " + std::to_string(facets - 1), passed_over);
  return std::move(result.soup());
}

/// the facets of an STL file in text, with keywords in any case and line ends anywhere
class Ascii_stl_reader
{
public:
  /// \param text must live as long as the reader
  explicit Ascii_stl_reader(std::string_view text) : m_scanner(text) {}

  /// reads all solids; lines outside them are added to \p passed_over
  CGAL_ext::internal::Surface_soup read(Passed_over& passed_over)
  {
    expect("solid");
    do {
      skip_name();
      for(std::string_view word = next(); !boost::iequals(word, "endsolid"); word = next()) {
        if(!boost::iequals(word, "facet"))
          m_scanner.refuse(word, "facet or endsolid");
        read_facet();
      }
      skip_end_name();
    } while(find_solid(passed_over));
    return std::move(m_facets.soup());
  }

private:
  /// the next word of a solid, the last of which is endsolid
  std::string_view next() { return checked(m_scanner.next_word_anywhere()); }

  /// a word of a solid; refuses a file that ends before or with it
  std::string_view checked(std::string_view word) const
  {
    if(word.empty() || (m_scanner.bytes_left() == 0 && !boost::iequals(word, "endsolid")))
      throw Malformed_file("it is incomplete: it ends " +
                           (m_is_in_facet ? "in facet " + std::to_string(m_facets.size())
                                          : "without endsolid after " + counted(m_facets.size(), "facet", "facets")));
    return word;
  }

  /// after a solid, goes past the word with which the next one begins; false when there is none
  bool find_solid(Passed_over& passed_over)
  {
    const std::string_view keyword = "solid";
    for(; m_scanner.find_word(); m_scanner.skip_line()) {
      const std::string_view word = m_scanner.next_word();
      if(boost::iequals(word, keyword))
        return true;
      if(boost::iequals(word, "facet"))
        m_scanner.refuse(word, "solid");
      if(word.size() < keyword.size() && m_scanner.bytes_left() == 0 && boost::istarts_with(keyword, word))
        throw Malformed_file("it is incomplete: it ends in the word solid");
      ++passed_over["lines outside solids"];
    }
    return false;
  }

  void expect(const std::string& keyword)
  {
    const std::string_view word = next();
    if(!boost::iequals(word, keyword))
      m_scanner.refuse(word, keyword);
  }

  /// passes over the name of a solid: the rest of the line, or what is before a facet on it
  void skip_name()
  {
    while(!m_scanner.is_line_end()) {
      const std::size_t place = m_scanner.place();
      if(boost::iequals(m_scanner.next_word(), "facet") && continues_facet(m_scanner)) {
        m_scanner.go_back(place);
        return;
      }
    }
  }

  /// passes over the name after endsolid: the rest of the line, or what is before another solid with a facet on it
  void skip_end_name()
  {
    std::optional<std::size_t> solid; // the place of the first word of that name
    while(!m_scanner.is_line_end()) {
      const std::size_t place = m_scanner.place();
      const std::string_view word = m_scanner.next_word();
      if(boost::iequals(word, "solid") && !solid)
        solid = place;
      if(!boost::iequals(word, "facet") || !continues_facet(m_scanner))
        continue;
      if(!solid)
        m_scanner.refuse(word, "solid");
      m_scanner.go_back(*solid);
      return;
    }
  }

  /// indicates whether the next words are those of a facet behind the word facet, which may be part of a name, too
  static bool continues_facet(Text_scanner scanner)
  {
    return boost::iequals(word_after_normal(scanner), "outer") &&
           boost::iequals(scanner.next_word_anywhere(), "loop") &&
           boost::iequals(scanner.next_word_anywhere(), "vertex");
  }

  /// passes over a normal, which is not needed: some writers leave it out, or write one that is no number as `1.#QNAN`
  /// \return the next word, which is outer in a facet
  static std::string_view word_after_normal(Text_scanner& scanner)
  {
    std::string_view word = scanner.next_word_anywhere();
    if(boost::iequals(word, "normal")) {
      word = scanner.next_word_anywhere();
      for(int component = 0; component < 3 && !boost::iequals(word, "outer"); ++component)
        word = scanner.next_word_anywhere();
    }
    return word;
  }

  /// reads what follows the word facet
  void read_facet()
  {
    m_is_in_facet = true;
    if(const std::string_view word = checked(word_after_normal(m_scanner)); !boost::iequals(word, "outer"))
      m_scanner.refuse(word, "normal or outer loop");
    expect("loop");
    std::array<std::array<double, 3>, 3> corners{};
    for(auto& corner : corners) {
      expect("vertex");
      for(double& x : corner) {
        const std::string_view word = next();
        const auto number = parse_real(word);
        if(!number)
          m_scanner.refuse(word, "a coordinate");
        x = *number;
      }
    }
    expect("endloop");
    expect("endfacet");
    m_facets.add(corners);
    m_is_in_facet = false;
  }

  Text_scanner m_scanner;
  Stl_facets m_facets;
  bool m_is_in_facet = false;
};

/// indicates whether a text begins with the word solid
inline bool begins_with_solid(std::string_view text)
{
  return boost::iequals(Text_scanner(text.substr(0, text.find_first_not_of(" \t\r\n\v\f") + 6)).next_word_anywhere(),
                        "solid");
}

/// reads an STL file. A binary one may begin with the word solid, too: its size tells, or a byte that no text has.
inline CGAL_ext::internal::Surface_soup read_stl(std::string_view bytes, Passed_over& passed_over)
{
  const bool is_text = begins_with_solid(bytes) && !has_size_of_binary_stl(bytes) &&
                       bytes.substr(0, STL_HEADER_BYTES).find('\0') == std::string_view::npos;
  if(is_text)
    return Ascii_stl_reader(bytes).read(passed_over);
  if(bytes.size() < STL_HEADER_BYTES)
    throw Malformed_file("it neither begins with the word solid nor has the 84 bytes of a binary header");
  return read_binary_stl(bytes, passed_over);
}

} // namespace square_map

#endif // SQUARE_MAP_READ_STL_H
