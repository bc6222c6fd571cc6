// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/unstructured_grid.h"

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Signorini
{
  /// The columns of the data that are vectors and tensors, as deal.II describes them.
  using NonscalarRanges =
    std::vector<std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>>;

  /// The properties of a VTU data set of one load step, besides its patches.
  struct PieceSettings
  {
    /// Directory and stem of the files, which are NAME_STEP.pvtu and NAME_STEP.RANK.vtu.
    std::string  directory, name;
    unsigned int step;
    double       time;
    /// The field whose numbers have names, such as "body".
    std::string names_of;
    /// The names, which are written to the field data NAMES_OF_names.
    std::vector<std::string> names;
  };

  /// Write one file for each rank that has cells (an empty file would lack the fields that
  /// readers expect), and the record of all. The field data contain the time (`TimeValue`) and the
  /// names. Throws OutputError on all ranks if a file cannot be written. Collective.
  /// @param grid of this rank
  /// @param settings of the data set
  /// @param comm the ranks
  /// @return the name of the record
  std::string
  write_pieces(const UnstructuredGrid &grid, const PieceSettings &settings, MPI_Comm comm);

  /// The same for patches. @param patches of this rank
  /// @param data_names names of the columns
  /// @param ranges vectors and tensors among the columns
  /// @param settings of the data set
  /// @param comm the ranks
  /// @return the name of the record
  template <int dim, int spacedim>
  std::string
  write_pieces(const std::vector<dealii::DataOutBase::Patch<dim, spacedim>> &patches,
               const std::vector<std::string>                               &data_names,
               const NonscalarRanges                                        &ranges,
               const PieceSettings                                          &settings,
               MPI_Comm                                                      comm);
} // namespace Signorini
