// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Signorini
{
  /// Which columns of the data are vectors and tensors, as deal.II describes them.
  using NonscalarRanges =
    std::vector<std::tuple<unsigned int,
                           unsigned int,
                           std::string,
                           dealii::DataComponentInterpretation::DataComponentInterpretation>>;

  /// A VTU data set of one load step beside its patches.
  struct PieceSettings
  {
    std::string              directory, name; ///< files are NAME_STEP.pvtu, NAME_STEP.RANK.vtu
    unsigned int             step;
    double                   time;
    std::string              names_of; ///< "body": the names that the numbers in this field have
    std::vector<std::string> names;    ///< they stand in the field data, as NAMES_OF_names
  };

  /// Writes one file a rank that has patches (an empty one would lack the fields that readers
  /// expect), and the record of all, whose name is returned. The field data hold the time
  /// (`TimeValue`) and the names. Throws std::runtime_error on all ranks if a file cannot be
  /// written. Collective.
  template <int dim, int spacedim>
  std::string
  write_pieces(const std::vector<dealii::DataOutBase::Patch<dim, spacedim>> &patches,
               const std::vector<std::string>                               &data_names,
               const NonscalarRanges                                        &ranges,
               const PieceSettings                                          &settings,
               MPI_Comm                                                      comm);
} // namespace Signorini
