// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OUTPUT_SET_H
#define SQUARE_MAP_OUTPUT_SET_H

#include "Output_file.h"
#include "signals.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace square_map {

/// the outputs of a run: all of them are replaced, or none
class Output_set
{
public:
  typedef std::function<void(std::ostream&)> Write_text;

  /// adds an output, which is checked at once; nothing is added for an empty name. Throws `Output_error`.
  /// \param write_text writes the text when all work is done
  void add(const std::string& name, Write_text write_text)
  {
    if(!name.empty())
      m_outputs.push_back({std::make_unique<Output_file>(name), std::move(write_text)});
  }

  /// writes the texts in the order in which the outputs were added, and when all are written, lets them take their
  /// places. Throws `Output_error`, and whatever else fails, such as an allocation; all files are as they were then.
  void write_and_commit()
  {
    for(const Output& output : m_outputs)
      output.file->write(output.write_text);
    begin_commit();
    std::size_t begun = 0;
    try {
      for(const Output& output : m_outputs)
        output.file->replace(++begun < m_outputs.size()); // no output can fail after the last
    } catch(...) {
      while(begun > 0)
        m_outputs[--begun].file->restore();
      end_commit();
      throw;
    }
    for(const Output& output : m_outputs)
      output.file->forget_former();
    end_commit();
  }

private:
  struct Output
  {
    std::unique_ptr<Output_file> file;
    Write_text write_text;
  };

  std::vector<Output> m_outputs;
};

} // namespace square_map

#endif // SQUARE_MAP_OUTPUT_SET_H
