// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_BYTE_SCANNER_H
#define SQUARE_MAP_BYTE_SCANNER_H

#include "Malformed_file.h"

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace square_map {

/// binary numbers one after the other. Where the bytes end too early, the message says in which element.
class Byte_scanner
{
public:
  /// \param bytes must live as long as the scanner
  Byte_scanner(std::string_view bytes, boost::endian::order order) : m_bytes(bytes), m_order(order) {}

  /// the next number. \param element says what it belongs to, "facet " for example, and \p index which one it is
  template <class Number>
  Number next(const char* element, std::size_t index)
  {
    typedef std::conditional_t<
        sizeof(Number) == 1, std::uint8_t,
        std::conditional_t<sizeof(Number) == 2, std::uint16_t,
                           std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>>
        Bits;
    demand(sizeof(Number), element, index);
    Bits bits;
    std::memcpy(&bits, m_bytes.data() + m_place, sizeof bits);
    m_place += sizeof bits;
    if(m_order != boost::endian::order::native)
      boost::endian::endian_reverse_inplace(bits);
    Number number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

  /// passes over bytes; \p element and \p index say what they belong to
  void skip(std::size_t count, const char* element, std::size_t index)
  {
    demand(count, element, index);
    m_place += count;
  }

  std::size_t bytes_left() const { return m_bytes.size() - m_place; }

private:
  void demand(std::size_t count, const char* element, std::size_t index) const
  {
    if(count > bytes_left())
      throw Malformed_file("it is incomplete: it ends in " + std::string(element) + ' ' + std::to_string(index));
  }

  std::string_view m_bytes;
  boost::endian::order m_order;
  std::size_t m_place = 0;
};

} // namespace square_map

#endif // SQUARE_MAP_BYTE_SCANNER_H
