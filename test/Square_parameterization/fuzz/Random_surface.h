// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_FUZZ_RANDOM_SURFACE_H
#define CGAL_EXT_FUZZ_RANDOM_SURFACE_H

#include "damage_surface.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// a surface of the kinds that go wrong, from a seed: a body on which things grow, and to which damage is done
class Random_surface
{
public:
  /// \param most_faces about; at least 4, and small surfaces are as likely as large ones
  Random_surface(unsigned int seed, int most_faces) : m_random(seed)
  {
    const std::vector<Random_body>& bodies = random_bodies();
    const Random_body& body = bodies[static_cast<std::size_t>(m_random.below(static_cast<int>(bodies.size())))];
    m_soup = body.make(m_random, static_cast<int>(random_magnitude(m_random, 4, most_faces)));
    m_name = body.name;
    change(growths(), 0.25);
    const bool is_polygonal = m_random(0, 1) < 0.15;
    if(!is_polygonal)
      split_polygons(m_random, m_soup);
    change(damages(), 0.2);
    change(defects(), 0.04);
    m_name += is_polygonal ? ", of polygons" : "";
  }

  const Surface_soup& soup() const { return m_soup; }

  /// what it is: "torus, with nails, snapped"
  const std::string& name() const { return m_name; }

private:
  /// something that is done to a surface
  struct Change
  {
    const char* name;
    void (*make)(Random_numbers& random, Surface_soup& soup);
  };

  static const std::vector<Change>& growths()
  {
    static const std::vector<Change> changes{{"with nails", grow_nails}, {"with handles", add_handles}};
    return changes;
  }

  /// what a map can be made of
  static const std::vector<Change>& damages()
  {
    static const std::vector<Change> changes{{"with holes", make_holes},
                                             {"with ears", add_ears},
                                             {"with spikes", draw_out_spikes},
                                             {"moved together", move_together},
                                             {"crumpled", crumple},
                                             {"flattened", flatten},
                                             {"snapped", snap},
                                             {"scaled", scale}};
    return changes;
  }

  /// what is refused, or put right
  static const std::vector<Change>& defects()
  {
    static const std::vector<Change> changes{{"with faces turned round", turn_faces},
                                             {"with faces doubled", double_faces},
                                             {"pinched", pinch},
                                             {"torn", tear},
                                             {"of components", add_component}};
    return changes;
  }

  void change(const std::vector<Change>& changes, double likelihood)
  {
    for(const Change& change : changes)
      if(m_random(0, 1) < likelihood) {
        change.make(m_random, m_soup);
        m_name += std::string(", ") + change.name;
      }
  }

  Random_numbers m_random;
  Surface_soup m_soup;
  std::string m_name;
};

#endif // CGAL_EXT_FUZZ_RANDOM_SURFACE_H
