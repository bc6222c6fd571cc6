#include <signorini/solve/preconditioners/contact_filter.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Nonzero at the degrees of freedom that active contact points touch.
    LA::Vector
    touched(const ContactSystem &system)
    {
      LA::Vector marker;
      marker.reinit(system.zero().block(0));
      if (system.gap_operator().empty())
        return marker;
      const Epetra_CrsMatrix &B = system.gap_operator().B_free.trilinos_matrix();
      Epetra_Vector           columns(B.ColMap());
      int                     row = 0;
      for (const auto i : system.gap_operator().weight.locally_owned_elements())
        {
          int     n, *indices;
          double *values;
          B.ExtractMyRowView(row++, n, values, indices);
          if (system.spring()(i) != 0 || system.coupling()(i) != 0)
            for (int k = 0; k < n; ++k)
              if (values[k] != 0)
                columns[indices[k]] = 1;
        }
      // Columns may belong to other ranks: tell them.
      Epetra_MultiVector &owned = marker.trilinos_vector();
      const int error = owned.Export(columns, Epetra_Import(B.ColMap(), B.DomainMap()), AbsMax);
      AssertThrow(error == 0, ExcTrilinosError(error));
      return marker;
    }
  } // namespace



  ContactFilter::ContactFilter(const ContactSystem &system,
                               const AMG           &amg,
                               const std::string   &direct_solver)
    : system(system)
    , amg(amg)
    , direct_solver(direct_solver)
  {}



  void
  ContactFilter::update()
  {
    zone = std::make_unique<ZoneSolver>(system, touched(system), direct_solver);
    if (zone->size() > 0)
      zone->update();
  }



  void
  ContactFilter::start(LA::BlockVector &x, const LA::BlockVector &rhs) const
  {
    if (zone->size() > 0)
      zone->add_correction(x, rhs);
  }



  void
  ContactFilter::vmult(LA::BlockVector &dst, const LA::BlockVector &src) const
  {
    dst = 0;
    amg.vmult(dst.block(0), src.block(0));
    if (zone->size() > 0)
      zone->correct(dst, src);
  }
} // namespace Signorini
