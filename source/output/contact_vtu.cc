// SPDX-License-Identifier: Apache-2.0
#include "fields/friction_fields.h"
#include "fields/nodal_fields.h"
#include "fields/recovered_pressure.h"
#include "output/files.h"
#include "output/pieces.h"

#include <deal.II/base/quadrature.h>
#include <deal.II/hp/fe_values.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return for each face of the reference cell the points at which it is drawn, the first
    /// parameter of the face running fastest; of triangles corners and middles of sides in the
    /// order of VTK. The faces of hypercubes, then those of simplices.
    template <int dim>
    hp::QCollection<dim>
    points_of_faces(const unsigned int n_subdivisions)
    {
      hp::QCollection<dim> result;
      for (const auto &cell :
           {ReferenceCells::get_hypercube<dim>(), ReferenceCells::get_simplex<dim>()})
        for (const unsigned int face : cell.face_indices())
          {
            std::vector<Point<dim>> points;
            const ReferenceCell     shape   = shape_of_faces(cell);
            auto                    lattice = face_lattice<dim>(shape, n_subdivisions);
            if (is_triangle(shape) && n_subdivisions == 2)
              lattice = {lattice[0], lattice[2], lattice[5], lattice[1], lattice[4], lattice[3]};
            for (const Point<dim - 1> &xi : lattice)
              points.push_back(unit_point<dim>(cell, face, xi));
            result.push_back(Quadrature<dim>(points));
          }
      return result;
    }



    /// The nodal fields of one pair with ghost values.
    template <int dim>
    struct Fields
    {
      LA::Vector displacement, pressure, gap, status, coverage, stick, bond;
      /// The components of the traction, of its tangential part, and of the slip.
      std::vector<LA::Vector> traction, tangential, slip;

      Fields(const Snapshot<dim> &snapshot, const unsigned int pair)
      {
        const auto with_ghosts = [&](const std::vector<LA::Vector> &components) {
          std::vector<LA::Vector> result;
          for (const LA::Vector &component : components)
            result.push_back(snapshot.elasticity.with_ghosts(component));
          return result;
        };
        const auto nodal = [&](const LA::Vector &values) {
          return snapshot.elasticity.with_ghosts(nodal_field(snapshot, values, pair));
        };
        displacement                = snapshot.elasticity.with_ghosts(snapshot.displacement);
        const LA::Vector &recovered = recovered_pressure(snapshot, pair);
        pressure                    = snapshot.elasticity.with_ghosts(recovered);
        gap                         = nodal(snapshot.gap);
        status                      = nodal(snapshot.active);
        coverage = snapshot.elasticity.with_ghosts(nodal_coverage(snapshot, pair));
        std::vector<LA::Vector>       sum;
        const std::vector<LA::Vector> along = tangential_traction(snapshot, pair);
        for (unsigned int d = 0; d < dim; ++d)
          {
            sum.push_back(nodal_field(snapshot, snapshot.contact.geometry.normal[d], pair));
            sum.back().scale(recovered);
            if (!along.empty())
              sum.back() += along[d];
          }
        traction = with_ghosts(sum);
        if (along.empty())
          return;
        tangential = with_ghosts(along);
        slip       = with_ghosts(slip_since_contact(snapshot, pair));
        stick      = nodal(sticks(snapshot.contact_state.status));
        bond       = nodal(sticks(snapshot.contact.coefficients.least_status));
      }
    };



    /// The slave faces of locally owned cells as patches.
    template <int dim>
    class ContactFaces : public DataOutInterface<dim - 1, dim>
    {
    public:
      using Patch = DataOutBase::Patch<dim - 1, dim>;

      /// Evaluate all pairs. Collective.
      ContactFaces(const Snapshot<dim> &snapshot);

      /// Write the files.
      /// @return the name of the record
      std::string
      write(const PieceSettings &settings, const MPI_Comm comm) const
      {
        return write_pieces(
          patches, get_dataset_names(), get_nonscalar_data_ranges(), settings, comm);
      }

    private:
      // Rows of the data: the components of the displacement and of the traction, then these, then
      // with friction the components of the tangential traction and of the slip, and the indicator
      // of stick, and that of intact bonds if bonds can fail; deal.II expects the positions last.
      enum Row : unsigned int
      {
        traction = dim,
        pressure = 2 * dim,
        gap,
        status,
        pair,
        frictionless_end,
        tangential = frictionless_end,
        slip       = tangential + dim,
        stick      = slip + dim,
        frictional_end,
        bond = frictional_end,
        bonded_end
      };

      /// The first of the rows of the positions.
      unsigned int
      position() const
      {
        return has_strength ? bonded_end : has_friction ? frictional_end : frictionless_end;
      }

      const std::vector<Patch> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        std::vector<std::string> names(dim, "displacement");
        names.insert(names.end(), dim, "traction");
        names.insert(names.end(), {"pressure", "gap", "status", "pair"});
        if (!has_friction)
          return names;
        names.insert(names.end(), dim, "tangential_traction");
        names.insert(names.end(), dim, "slip");
        names.push_back("stick");
        if (has_strength)
          names.push_back("bond");
        return names;
      }

      NonscalarRanges
      get_nonscalar_data_ranges() const override
      {
        NonscalarRanges result;
        const auto      add = [&result](const unsigned int first, const std::string &name) {
          result.emplace_back(first,
                              first + dim - 1,
                              name,
                              DataComponentInterpretation::component_is_part_of_vector);
        };
        add(0, "displacement");
        add(Row::traction, "traction");
        if (has_friction)
          {
            add(Row::tangential, "tangential_traction");
            add(Row::slip, "slip");
          }
        return result;
      }

      /// Add the slave faces of one pair.
      void
      add_pair(const Snapshot<dim> &snapshot, unsigned int pair);
      /// Add one face, with which `values` have been reinitialised.
      void
      add_patch(const FEValues<dim> &values,
                const ReferenceCell &shape,
                const Fields<dim>   &fields,
                unsigned int         pair);
      /// Evaluate the fields at the points of one face.
      void
      set_fields(const FEValues<dim> &values,
                 const Fields<dim>   &fields,
                 Table<2, float>     &data) const;

      const unsigned int n_subdivisions;
      const bool         has_friction, has_strength;
      /// Evaluation at the points of a face: rule f is that of face f.
      hp::FEValues<dim>  values_on_faces;
      std::vector<Patch> patches;
    };



    template <int dim>
    ContactFaces<dim>::ContactFaces(const Snapshot<dim> &snapshot)
      : n_subdivisions(snapshot.elasticity.degree())
      , has_friction(snapshot.contact.n_components() > 1)
      , has_strength(std::any_of(snapshot.pairs.begin(),
                                 snapshot.pairs.end(),
                                 [](const auto &pair) { return pair.strength.given(); }))
      , values_on_faces(snapshot.elasticity.mesh().mappings(),
                        snapshot.elasticity.finite_elements(),
                        points_of_faces<dim>(n_subdivisions),
                        update_values | update_quadrature_points)
    {
      for (unsigned int p = 0; p < snapshot.pairs.size(); ++p)
        add_pair(snapshot, p);
    }



    template <int dim>
    void
    ContactFaces<dim>::add_pair(const Snapshot<dim> &snapshot, const unsigned int pair)
    {
      const Fields<dim>  fields(snapshot, pair);
      const BoundaryIds &ids = snapshot.elasticity.mesh().boundary_ids(snapshot.pairs[pair].slave);
      for (const auto &cell : snapshot.elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() && ids.count(cell->face(f)->boundary_id()) > 0)
              {
                const bool is_simplex = cell->reference_cell().is_simplex();
                values_on_faces.reinit(cell,
                                       f + (is_simplex ? GeometryInfo<dim>::faces_per_cell : 0));
                add_patch(values_on_faces.get_present_fe_values(),
                          shape_of_faces(cell->reference_cell()),
                          fields,
                          pair);
              }
    }



    template <int dim>
    void
    ContactFaces<dim>::add_patch(const FEValues<dim> &values,
                                 const ReferenceCell &shape,
                                 const Fields<dim>   &fields,
                                 const unsigned int   number)
    {
      // Triangles are not subdivided; with six points they are written as cells of second order.
      Patch patch;
      patch.patch_index          = patches.size();
      patch.n_subdivisions       = is_triangle(shape) ? 1 : n_subdivisions;
      patch.reference_cell       = shape;
      patch.points_are_available = true;
      patch.data.reinit(position() + dim, values.n_quadrature_points);
      set_fields(values, fields, patch.data);
      for (const unsigned int q : values.quadrature_point_indices())
        {
          patch.data[Row::pair][q] = number;
          for (unsigned int d = 0; d < dim; ++d)
            patch.data[position() + d][q] = values.quadrature_point(q)[d];
        }
      for (const unsigned int v : shape.vertex_indices())
        patch.vertices[v] = values.quadrature_point(
          is_triangle(shape) ? v : n_subdivisions * (v % 2 + (v / 2) * (n_subdivisions + 1)));
      patches.push_back(std::move(patch));
    }



    // Evaluate all nodal fields at the points, and store them in the rows of the data.
    template <int dim>
    void
    ContactFaces<dim>::set_fields(const FEValues<dim> &values,
                                  const Fields<dim>   &fields,
                                  Table<2, float>     &data) const
    {
      std::vector<Tensor<1, dim>> u(values.n_quadrature_points);
      std::vector<double>         p(u.size()), g(u.size()), active(u.size()), coverage(u.size()),
        component(u.size());
      // Nodal fields are stored at the first component of each node.
      const FEValuesExtractors::Scalar first(0);
      values[FEValuesExtractors::Vector(0)].get_function_values(fields.displacement, u);
      values[first].get_function_values(fields.pressure, p);
      values[first].get_function_values(fields.gap, g);
      values[first].get_function_values(fields.status, active);
      values[first].get_function_values(fields.coverage, coverage);
      const auto set = [&](const unsigned int row, const LA::Vector &field) {
        values[first].get_function_values(field, component);
        for (unsigned int q = 0; q < u.size(); ++q)
          data[row][q] = component[q];
      };
      for (unsigned int d = 0; d < dim; ++d)
        set(Row::traction + d, fields.traction[d]);
      for (unsigned int d = 0; d < fields.tangential.size(); ++d)
        {
          set(Row::tangential + d, fields.tangential[d]);
          set(Row::slip + d, fields.slip[d]);
        }
      if (has_friction)
        set(Row::stick, fields.stick);
      if (has_strength)
        set(Row::bond, fields.bond);
      for (unsigned int q = 0; q < u.size(); ++q)
        {
          for (unsigned int d = 0; d < dim; ++d)
            data[d][q] = u[q][d];
          data[Row::pressure][q] = p[q];
          data[Row::status][q]   = active[q] >= 1.5 ? 2 : active[q] >= 0.5 ? 1 : 0;
          // A gap of zero would look like contact where there is no projection.
          data[Row::gap][q] =
            coverage[q] > 1 - 1e-6 ? g[q] : std::numeric_limits<double>::quiet_NaN();
        }
    }
  } // namespace



  template <int dim>
  std::string
  write_contact(const Snapshot<dim> &snapshot,
                const std::string   &directory,
                const std::string   &name)
  {
    std::vector<std::string> names;
    for (const ContactPair<dim> &pair : snapshot.pairs)
      names.push_back(pair.name);
    return ContactFaces<dim>(snapshot).write(
      {directory, name, snapshot.step, snapshot.time, "pair", names},
      snapshot.elasticity.mesh().communicator());
  }



  template std::string
  write_contact(const Snapshot<2> &, const std::string &, const std::string &);
  template std::string
  write_contact(const Snapshot<3> &, const std::string &, const std::string &);
} // namespace Signorini
