// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PACKED_ARRAYS_H
#define SQUARE_MAP_PACKED_ARRAYS_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace square_map {

/// arrays of numbers one after the other, as the typed arrays of a script read them, and where each of them is
class Packed_arrays
{
public:
  template <class Number>
  void add(const std::string& name, const std::vector<Number>& numbers)
  {
    m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0'); // a typed array begins at a multiple of the size of its numbers
    m_layout.push_back(
        {{"name", name}, {"type", type_name<Number>()}, {"offset", m_bytes.size()}, {"size", numbers.size()}});
    m_bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  }

  const std::string& bytes() const { return m_bytes; }
  const nlohmann::ordered_json& layout() const { return m_layout; }

private:
  template <class Number>
  static const char* type_name()
  {
    if constexpr(std::is_same_v<Number, float>)
      return "float32";
    else if constexpr(std::is_same_v<Number, std::int8_t>)
      return "int8";
    else if constexpr(std::is_same_v<Number, std::int32_t>)
      return "int32";
    else {
      static_assert(std::is_same_v<Number, std::uint32_t>);
      return "uint32";
    }
  }

  std::string m_bytes;
  nlohmann::ordered_json m_layout = nlohmann::ordered_json::array();
};

} // namespace square_map

#endif // SQUARE_MAP_PACKED_ARRAYS_H
