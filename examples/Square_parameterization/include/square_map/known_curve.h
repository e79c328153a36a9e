// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_KNOWN_CURVE_H
#define SQUARE_MAP_KNOWN_CURVE_H

#include "Malformed_file.h"
#include "option_values.h"
#include "read_bytes.h"

#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace square_map {

/// the curve of brute force, of which the reports of slices told every point: what is left to do is to map the best
class Known_curve
{
public:
  typedef CGAL_ext::Search_report::Sample Sample;

  /// \param candidates of the surface
  explicit Known_curve(int candidates) : m_candidates(candidates) {}

  int candidates() const { return m_candidates; }

  void add(const Sample& sample)
  {
    if(sample.candidate < 0 || sample.candidate >= m_candidates)
      throw Malformed_file("candidate " + std::to_string(sample.candidate) + " is not one of " +
                           std::to_string(m_candidates));
    const auto [known, is_new] = m_samples.emplace(sample.candidate, sample);
    if(!is_new && (known->second.objective != sample.objective || known->second.l2 != sample.l2))
      throw Malformed_file("candidate " + std::to_string(sample.candidate) + " has another value in another report");
  }

  /// refuses a curve with a gap
  void check_complete() const
  {
    for(int candidate = 0; candidate < m_candidates; ++candidate)
      if(m_samples.count(candidate) == 0)
        throw Malformed_file("the reports of --curve lack candidate " + std::to_string(candidate) + " of " +
                             std::to_string(m_candidates));
  }

  /// a search that evaluates the best of the curve alone, ties as all searches break them: the lowest candidate. Where
  /// brute force would go on to other starts, of which the curve says nothing, this is brute force.
  /// \param brute_force of which this is the curve
  CGAL_ext::Corner_search search(const CGAL_ext::Corner_search& brute_force) const
  {
    const Sample best = best_sample();
    if(!is_enough())
      return brute_force;
    struct Best_alone
    {
      CGAL_ext::Candidate_set set;
      int candidates;
      Sample best;

      CGAL_ext::Candidate_set candidate_set() const { return set; }

      void operator()(const CGAL_ext::Corner_search_problem& problem) const
      {
        if(problem.number_of_candidates != candidates)
          throw Malformed_file("the reports of --curve are of another surface or strategy: they count " +
                               std::to_string(candidates) + " candidates, not " +
                               std::to_string(problem.number_of_candidates));
        const double objective = problem.objective_of({best.candidate}).front();
        constexpr double DIFFERENCE_OF_MACHINES = 1e-6; // of other roundings of the functions of the C library
        if(!(std::abs(objective - best.objective) <= DIFFERENCE_OF_MACHINES * best.objective))
          throw Malformed_file("the reports of --curve are of another surface or of other options: candidate " +
                               std::to_string(best.candidate) + " has another value");
      }
    };
    return Best_alone{brute_force.candidate_set(), m_candidates, best};
  }

  /// puts the whole curve in the place of the one candidate that was mapped
  void complete(CGAL_ext::Search_report& report) const
  {
    if(!is_enough())
      return;
    report.evaluations = m_samples.size();
    report.curve.clear();
    for(const auto& entry : m_samples)
      report.curve.push_back(entry.second);
  }

private:
  /// the lowest; the first of several
  Sample best_sample() const
  {
    Sample best{0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for(const auto& [candidate, sample] : m_samples)
      if(sample.objective < best.objective)
        best = sample;
    return best;
  }

  /// indicates whether the best candidate is mapped from the start that the curve was made from
  bool is_enough() const { return best_sample().objective < CGAL_ext::internal::Minimizer_numbers::HOPELESS_RESULT; }

  int m_candidates;
  std::map<int, Sample> m_samples;
};

/// reads the reports of slices, and puts their curves together
/// \throw Malformed_file for a file that is no report, and for curves that do not fit together or have a gap
inline Known_curve read_curves(const std::vector<std::string>& files)
{
  const auto value = [](const nlohmann::json& json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
  };
  std::optional<Known_curve> curve;
  for(const std::string& file : files)
    try {
      const nlohmann::json report = nlohmann::json::parse(read_bytes(file).bytes);
      const int candidates = report.at("candidates").get<int>();
      if(candidates < 1)
        throw Malformed_file("it has no candidates");
      if(!curve)
        curve.emplace(candidates);
      if(candidates != curve->candidates())
        throw Malformed_file("it counts " + std::to_string(candidates) + " candidates, another " +
                             std::to_string(curve->candidates()));
      for(const nlohmann::json& sample : report.at("curve"))
        curve->add({sample.at("candidate").get<int>(), value(sample.at("energy")), value(sample.at("l2"))});
    } catch(const Malformed_file& error) {
      throw Malformed_file("cannot use the report '" + file + "': " + error.what());
    } catch(const nlohmann::json::exception&) {
      throw Malformed_file("cannot use the report '" + file + "': it is not one of square_map");
    }
  curve->check_complete();
  return *curve;
}

} // namespace square_map

#endif // SQUARE_MAP_KNOWN_CURVE_H
