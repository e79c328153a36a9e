// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_COMPLAINT_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_COMPLAINT_H

#include <CGAL_ext/Square_parameterization/internal/common/Unmappable.h>

#include <string>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// gathers what is wrong with a surface into one sentence that names numbers and first places
class Complaint
{
public:
  /// adds a sentence
  void say(const std::string& text) { m_text += (m_text.empty() ? "" : "; ") + text; }

  /// adds `count` things, none for 0, of which `places` are the first few
  void add(std::size_t count, const std::string& singular, const std::string& plural,
           const std::vector<std::string>& places = {})
  {
    if(count == 0)
      return;
    std::string text = std::to_string(count) + " " + (count == 1 ? singular : plural);
    for(std::size_t i = 0; i < places.size(); ++i)
      text += (i == 0 ? " (" : ", ") + places[i];
    if(!places.empty())
      text += count > places.size() ? ", ...)" : ")";
    say(text);
    m_has_places |= !places.empty();
  }

  /// all that was said; empty for nothing
  const std::string& text() const { return m_text; }

  void throw_if_any(CGAL::Surface_mesh_parameterization::Error_code code) const
  {
    if(!m_text.empty())
      throw Unmappable(code, "the surface cannot be mapped: " + m_text +
                                 (m_has_places ? "; vertices and faces are counted from 0" : ""));
  }

private:
  std::string m_text;
  bool m_has_places = false;
};

constexpr std::size_t NAMED_PLACES = 3; // as many places are named in a message

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_COMPLAINT_H
