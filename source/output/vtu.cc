#include <signorini/elasticity/model.h>
#include <signorini/elasticity/stress.h>
#include <signorini/output/pvd.h>
#include <signorini/output/vtu.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A component of the stress in space, and its name.
    struct Component
    {
      const char  *name;
      unsigned int i, j;
    };

    // The last two vanish in 2D.
    constexpr Component components[] = {{"stress_xx", 0, 0},
                                        {"stress_yy", 1, 1},
                                        {"stress_zz", 2, 2},
                                        {"stress_xy", 0, 1},
                                        {"stress_yz", 1, 2},
                                        {"stress_xz", 0, 2}};

    template <int dim>
    constexpr unsigned int n_components = dim == 2 ? 4 : 6;



    /// Von Mises stress and the components of the stress, from the displacement.
    template <int dim>
    class StressPostprocessor : public DataPostprocessor<dim>
    {
    public:
      StressPostprocessor(const Elasticity<dim> &elasticity)
        : elasticity(elasticity)
      {}

      void
      evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &inputs,
                            std::vector<Vector<double>>                &computed) const override
      {
        const auto      cell     = inputs.template get_cell<dim>();
        const Material &material = elasticity.material(cell->material_id());
        for (unsigned int q = 0; q < computed.size(); ++q)
          {
            Tensor<2, dim> gradient;
            for (unsigned int d = 0; d < dim; ++d)
              gradient[d] = inputs.solution_gradients[q][d];
            Tensor<1, dim> u;
            for (unsigned int d = 0; d < dim; ++d)
              u[d] = inputs.solution_values[q][d];
            const SymmetricTensor<2, 3> sigma = stress(
              material,
              strain(elasticity.model(), material, gradient, u, inputs.evaluation_points[q]));
            computed[q][0] = von_mises(sigma);
            for (unsigned int c = 0; c < n_components<dim>; ++c)
              computed[q][1 + c] = sigma[components[c].i][components[c].j];
          }
      }

      std::vector<std::string>
      get_names() const override
      {
        std::vector<std::string> names = {"von_mises"};
        for (unsigned int c = 0; c < n_components<dim>; ++c)
          names.emplace_back(components[c].name);
        return names;
      }

      // Scalars, because a tensor in a VTU file has nine components and no place for sigma_zz of
      // plane strain or the hoop.
      std::vector<DataComponentInterpretation::DataComponentInterpretation>
      get_data_component_interpretation() const override
      {
        return {1 + n_components<dim>, DataComponentInterpretation::component_is_scalar};
      }

      UpdateFlags
      get_needed_update_flags() const override
      {
        return update_values | update_gradients | update_quadrature_points;
      }

    private:
      const Elasticity<dim> &elasticity;
    };



    template <int dim>
    Vector<float>
    body_of_cells(const Triangulation<dim> &triangulation)
    {
      Vector<float> bodies(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          bodies[cell->active_cell_index()] = cell->material_id();
      return bodies;
    }
  } // namespace



  template <int dim>
  std::string
  write_bodies(const Snapshot<dim> &snapshot, const std::string &directory)
  {
    const Elasticity<dim>         &elasticity    = snapshot.elasticity;
    const auto                    &triangulation = elasticity.mesh().triangulation();
    const LA::Vector               displacement  = elasticity.with_ghosts(snapshot.displacement);
    const StressPostprocessor<dim> stresses(elasticity);
    const Vector<float>            bodies = body_of_cells<dim>(triangulation);
    Vector<float>                  subdomain(triangulation.n_active_cells());
    subdomain = triangulation.locally_owned_subdomain();

    const std::vector<DataComponentInterpretation::DataComponentInterpretation> is_vector(
      dim, DataComponentInterpretation::component_is_part_of_vector);
    DataOut<dim> out;
    out.set_flags(vtk_flags());
    out.attach_dof_handler(elasticity.dof_handler());
    out.add_data_vector(displacement,
                        std::vector<std::string>(dim, "displacement"),
                        DataOut<dim>::type_dof_data,
                        is_vector);
    out.add_data_vector(displacement, stresses);
    out.add_data_vector(bodies, "body", DataOut<dim>::type_cell_data);
    out.add_data_vector(subdomain, "subdomain", DataOut<dim>::type_cell_data);
    out.build_patches(elasticity.mesh().mapping(),
                      elasticity.degree(),
                      DataOut<dim>::curved_inner_cells);
    return out.write_vtu_with_pvtu_record(
      directory + "/", "solution", snapshot.step, elasticity.mesh().communicator(), 4);
  }



  template std::string
  write_bodies(const Snapshot<2> &, const std::string &);
  template std::string
  write_bodies(const Snapshot<3> &, const std::string &);
} // namespace Signorini
