// SPDX-License-Identifier: Apache-2.0
#include "output/pieces.h"

#include "output/directory.h"
#include "output/pvd.h"

#include <deal.II/base/mpi.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return words in the ASCII form of VTK's string arrays: the codes of all characters, with a
    /// zero after each word.
    std::string
    codes(const std::vector<std::string> &words)
    {
      std::ostringstream out;
      for (const std::string &word : words)
        {
          for (const char c : word)
            out << static_cast<unsigned int>(static_cast<unsigned char>(c)) << ' ';
          out << "0\n";
        }
      return out.str();
    }

    /// @return the XML of time and names.
    std::string
    field_data(const PieceSettings &settings)
    {
      std::ostringstream out;
      out.precision(17);
      out << "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
             "format=\"ascii\">\n"
          << settings.time << "\n</DataArray>\n<DataArray type=\"String\" Name=\""
          << settings.names_of << "_names\" NumberOfTuples=\"" << settings.names.size()
          << "\" format=\"ascii\">\n"
          << codes(settings.names) << "</DataArray>\n</FieldData>\n";
      return out.str();
    }

    /// Whether this rank has nothing to write, has written, or could not.
    enum State : unsigned int
    {
      nothing,
      written,
      failed
    };

    // The states of all ranks are exchanged, so that all of them throw if one could not write, and
    // the record lists existing files only.
    std::string
    write_files(const bool                                 has_cells,
                const std::function<void(std::ostream &)> &write_piece,
                const std::function<std::string(const std::vector<std::string> &files)> &record_of,
                const PieceSettings                                                     &settings,
                const MPI_Comm                                                           comm)
    {
      // File names: NAME_STEP.RANK.vtu with as many digits of the rank as the last one needs.
      const unsigned int n_digits =
        Utilities::needed_digits(Utilities::MPI::n_mpi_processes(comm) - 1);
      const std::string stem = settings.name + "_" + Utilities::int_to_string(settings.step, 4);
      const auto        file = [&](const unsigned int rank) {
        return stem + "." + Utilities::int_to_string(rank, n_digits) + ".vtu";
      };
      const unsigned int me    = Utilities::MPI::this_mpi_process(comm);
      State              state = nothing;
      // Each rank with cells writes its own file. An I/O error is only noted here, since the other
      // ranks wait in the following exchange.
      if (has_cells)
        {
          std::ofstream out(settings.directory + "/" + file(me), std::ios::binary);
          try
            {
              DataOutBase::write_vtu_header(out, vtk_flags());
              out << field_data(settings);
              write_piece(out);
              DataOutBase::write_vtu_footer(out);
              out.close();
            }
          catch (const ExcIO &)
            {
              out.setstate(std::ios::failbit);
            }
          state = out ? written : failed;
        }
      const auto states = Utilities::MPI::all_gather(comm, static_cast<unsigned int>(state));

      std::vector<std::string> files;
      for (unsigned int rank = 0; rank < states.size(); ++rank)
        if (states[rank] == failed)
          throw OutputError(settings.directory + "/" + file(rank), true);
        else if (states[rank] == written)
          files.push_back(file(rank));
      // The record NAME_STEP.pvtu refers to all pieces, and is replaced in one step so that it is
      // never incomplete on disk.
      if (me == 0)
        {
          replace_file(settings.directory + "/" + stem + ".pvtu", record_of(files));
        }
      return stem + ".pvtu";
    }
  } // namespace



  std::string
  write_pieces(const UnstructuredGrid &grid, const PieceSettings &settings, const MPI_Comm comm)
  {
    return write_files(
      !grid.types.empty(),
      [&](std::ostream &out) { grid.write(out); },
      [&](const std::vector<std::string> &files) { return grid.record(files); },
      settings,
      comm);
  }



  template <int dim, int spacedim>
  std::string
  write_pieces(const std::vector<DataOutBase::Patch<dim, spacedim>> &patches,
               const std::vector<std::string>                       &data_names,
               const NonscalarRanges                                &ranges,
               const PieceSettings                                  &settings,
               const MPI_Comm                                        comm)
  {
    return write_files(
      !patches.empty(),
      [&](std::ostream &out) {
        DataOutBase::write_vtu_main(patches, data_names, ranges, vtk_flags(), out);
      },
      [&](const std::vector<std::string> &files) {
        std::ostringstream record;
        DataOutBase::write_pvtu_record(record, files, data_names, ranges, vtk_flags());
        return record.str();
      },
      settings,
      comm);
  }



  template std::string
  write_pieces(const std::vector<DataOutBase::Patch<1, 2>> &,
               const std::vector<std::string> &,
               const NonscalarRanges &,
               const PieceSettings &,
               MPI_Comm);
  template std::string
  write_pieces(const std::vector<DataOutBase::Patch<2, 3>> &,
               const std::vector<std::string> &,
               const NonscalarRanges &,
               const PieceSettings &,
               MPI_Comm);
  template std::string
  write_pieces(const std::vector<DataOutBase::Patch<2, 2>> &,
               const std::vector<std::string> &,
               const NonscalarRanges &,
               const PieceSettings &,
               MPI_Comm);
  template std::string
  write_pieces(const std::vector<DataOutBase::Patch<3, 3>> &,
               const std::vector<std::string> &,
               const NonscalarRanges &,
               const PieceSettings &,
               MPI_Comm);
} // namespace Signorini
