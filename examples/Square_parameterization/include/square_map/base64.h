// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_BASE64_H
#define SQUARE_MAP_BASE64_H

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <string>

namespace square_map {

/// bytes in the letters that text may hold
inline std::string base64(const std::string& bytes)
{
  using namespace boost::archive::iterators;
  typedef base64_from_binary<transform_width<std::string::const_iterator, 6, 8>> Letters;
  std::string text(Letters(bytes.begin()), Letters(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

} // namespace square_map

#endif // SQUARE_MAP_BASE64_H
