// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/values.h"
#include "mesh_import/cells.h"
#include "mesh_import/division/cell_shape.h"
#include "output/files.h"
#include "output/pieces.h"
#include "solid/cell_displacement.h"
#include "solid/cell_nodes.h"
#include "solid/scalar_elements.h"
#include "solid/stress.h"
#include <signorini/solid/model.h>

#include <array>
#include <cmath>
#include <unordered_map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A cell type of VTK, and the unit coordinates of its nodes.
    template <int dim>
    struct VtkCell
    {
      std::uint8_t            type;
      std::vector<Point<dim>> nodes;
    };

    /// The corners in the order of VTK: those of hypercubes go around.
    template <int dim>
    std::vector<Point<dim>>
    corners_of(const ReferenceCell &shape)
    {
      std::vector<Point<dim>> result;
      for (const unsigned int v : shape.vertex_indices())
        result.push_back(shape.template vertex<dim>(v));
      if (shape.is_hyper_cube())
        for (unsigned int v = 2; v < result.size(); v += 4)
          std::swap(result[v], result[v + 1]);
      return result;
    }

    /// Nodes are means of corners, in the order of mesh files, which is that of VTK.
    /// @param element scalar, of degree 1 or 2
    template <int dim>
    VtkCell<dim>
    vtk_cell(const FiniteElement<dim> &element)
    {
      AssertThrow(element.degree == 1 || element.degree == 2, ExcNotImplemented());
      const bool is_cube = element.reference_cell().is_hyper_cube();
      const auto types =
        dim == 2 ?
          (is_cube ? std::array<std::uint8_t, 2>{{9, 28}} : std::array<std::uint8_t, 2>{{5, 22}}) :
          (is_cube ? std::array<std::uint8_t, 2>{{12, 29}} : std::array<std::uint8_t, 2>{{10, 24}});
      const auto   corners = corners_of<dim>(element.reference_cell());
      const auto  &nodes   = CellShape::of(is_cube ? cell_shape<dim> : simplex_shape<dim>).nodes;
      VtkCell<dim> result{types[element.degree - 1], {}};
      for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
        {
          Tensor<1, dim> sum;
          unsigned int   n = 0;
          for (unsigned int corner = 0; corner < corners.size(); ++corner)
            if (nodes[i] & (1u << corner))
              {
                sum += Tensor<1, dim>(corners[corner]);
                ++n;
              }
          result.nodes.emplace_back(sum / n);
        }
      return result;
    }

    /// How the nodes of an element appear in files.
    template <int dim>
    struct ElementNodes
    {
      VtkCell<dim> cell;
      /// For each node of the VTK cell, the numbers of its components in the element.
      std::vector<std::array<unsigned int, dim>> dofs;
    };

    template <int dim>
    ElementNodes<dim>
    nodes_of(const FiniteElement<dim> &fe)
    {
      ElementNodes<dim> result{vtk_cell(fe.base_element(0)), {}};
      const auto       &points = fe.base_element(0).get_unit_support_points();
      for (const Point<dim> &node : result.cell.nodes)
        {
          const auto found = std::find_if(points.begin(), points.end(), [&](const Point<dim> &x) {
            return x.distance(node) < 1e-10;
          });
          AssertThrow(found != points.end(), ExcInternalError());
          auto &dofs = result.dofs.emplace_back();
          for (unsigned int d = 0; d < dim; ++d)
            dofs[d] = fe.component_to_system_index(d, found - points.begin());
        }
      return result;
    }

    /// For each material, how many materials of its body are before it.
    template <int dim>
    std::vector<unsigned int>
    layers_of_materials(const Mesh<dim> &mesh)
    {
      std::vector<unsigned int> result, n_of_body(mesh.n_bodies(), 0);
      for (unsigned int id = 0; id < mesh.n_materials(); ++id)
        result.push_back(n_of_body[mesh.body_of_material(id)]++);
      return result;
    }

    /// The bodies with displacement and tensors at nodes. Tensors jump between cells: at a node
    /// they are the mean over the cells around it, weighted with the Jacobian determinants there.
    /// Bodies jump at interfaces of their materials, where each material has points of its own:
    /// layer k is the k-th material of each body.
    template <int dim>
    class NodalGrid
    {
    public:
      NodalGrid(const Snapshot<dim> &snapshot, const bool with_strain)
        : elasticity(snapshot.elasticity)
        , displacement(elasticity.with_ghosts(snapshot.displacement))
        , n_values(with_strain ? 12 : 6)
        , layers(layers_of_materials(elasticity.mesh()))
      {
        for (const auto &fe : elasticity.finite_elements())
          elements.push_back(nodes_of(fe));
        grid.of_points.push_back({"displacement", 3, {}});
        for (const std::string &tensor : with_strain ?
                                           std::vector<std::string>{"stress", "strain"} :
                                           std::vector<std::string>{"stress"})
          {
            grid.of_points.push_back({tensor, 9, {}});
            for (const char *number : {"1", "2", "3"})
              grid.of_points.push_back({"principal_" + tensor + "_" + number, 1, {}});
          }
        grid.of_points.push_back({"von_mises", 1, {}});
        grid.of_cells               = {{"body", 1, {}}, {"subdomain", 1, {}}};
        const unsigned int n_layers = *std::max_element(layers.begin(), layers.end()) + 1;
        for (unsigned int layer = 0; layer < n_layers; ++layer)
          add(layer);
      }

      UnstructuredGrid grid;

    private:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;
      /// The degrees of freedom of a node.
      using Node = std::array<types::global_dof_index, dim>;

      /// The points of a layer, and the integrals of their tensors.
      struct Layer
      {
        std::unordered_map<types::global_dof_index, unsigned int>
                            numbers; ///< by the first of a Node
        std::vector<Node>   nodes;
        std::vector<double> weights, sums; ///< n_values sums a point
      };

      /// The rule of each element whose points are its nodes, with the weight 1.
      hp::QCollection<dim>
      rules() const
      {
        hp::QCollection<dim> result;
        for (const auto &element : elements)
          result.push_back(Quadrature<dim>(element.cell.nodes,
                                           std::vector<double>(element.cell.nodes.size(), 1.)));
        return result;
      }

      /// Add the cells, points and fields of a layer. Collective.
      void
      add(const unsigned int number)
      {
        const Mesh<dim>                     &mesh = elasticity.mesh();
        CellDisplacement<dim>                at(elasticity, displacement, rules());
        Layer                                layer;
        std::vector<types::global_dof_index> indices;
        const unsigned int                   first = grid.points.size() / 3;
        for (const Cell &cell : elasticity.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() && layers[cell->material_id()] == number)
            {
              const ElementNodes<dim> &element = elements[cell->active_fe_index()];
              read_indices<dim>(cell, indices);
              const FEValues<dim> &values = at.reinit(cell);
              for (unsigned int q = 0; q < element.dofs.size(); ++q)
                {
                  Node node;
                  for (unsigned int d = 0; d < dim; ++d)
                    node[d] = indices[element.dofs[q][d]];
                  const unsigned int i = point(layer, node, values.quadrature_point(q), at.u[q]);
                  grid.connectivity.push_back(first + i);
                  add_tensors(layer,
                              i,
                              values.JxW(q),
                              cell,
                              at.gradient[q],
                              at.u[q],
                              values.quadrature_point(q));
                }
              grid.offsets.push_back(grid.connectivity.size());
              grid.types.push_back(element.cell.type);
              grid.of_cells[0].values.push_back(mesh.body(cell));
              grid.of_cells[1].values.push_back(mesh.triangulation().locally_owned_subdomain());
            }
        add_means(layer);
      }

      /// The number of a node in its layer; a new one becomes a point.
      unsigned int
      point(Layer &layer, const Node &node, const Point<dim> &x, const Tensor<1, dim> &u)
      {
        const auto [found, is_new] = layer.numbers.try_emplace(node[0], layer.nodes.size());
        if (is_new)
          {
            layer.nodes.push_back(node);
            layer.weights.push_back(0);
            layer.sums.resize(layer.sums.size() + n_values, 0.);
            for (unsigned int d = 0; d < 3; ++d)
              {
                grid.points.push_back(d < dim ? x[d] : 0.);
                grid.of_points[0].values.push_back(d < dim ? u[d] : 0.);
              }
          }
        return found->second;
      }

      void
      add_tensors(Layer                &layer,
                  const unsigned int    i,
                  const double          weight,
                  const Cell           &cell,
                  const Tensor<2, dim> &gradient,
                  const Tensor<1, dim> &u,
                  const Point<dim>     &x) const
      {
        layer.weights[i] += weight;
        for (unsigned int first = 0; first < n_values; first += 6)
          {
            const SymmetricTensor<2, 3> tensor = first == 0 ?
                                                   elasticity.stress(*cell, gradient, u, x) :
                                                   elasticity.strain(*cell, gradient, u, x);
            for (unsigned int c = 0; c < 6; ++c)
              layer.sums[i * n_values + first + c] += weight * tensor.access_raw_entry(c);
          }
      }

      /// Add the fields of the tensors at the points of a layer. Sums and weights of several ranks
      /// are added up at the degrees of freedom of their nodes, dim values at a time. A hanging
      /// node has the value between the nodes that determine its displacement, so that fields are
      /// continuous there. Collective.
      void
      add_means(const Layer &layer)
      {
        const unsigned int n_blocks = (n_values + dim - 1) / dim;
        const LA::Vector   weights =
          added_up(layer, [&](const unsigned int i, unsigned int) { return layer.weights[i]; });
        std::vector<LA::Vector> means;
        for (unsigned int block = 0; block < n_blocks; ++block)
          {
            means.push_back(added_up(layer, [&](const unsigned int i, const unsigned int d) {
              const unsigned int c = block * dim + d;
              return c < n_values ? layer.sums[i * n_values + c] : 0.;
            }));
            double *const       values = LA::values_of(means.back());
            const double *const weight = LA::values_of(weights);
            for (unsigned int i = 0; i < weights.locally_owned_size(); ++i)
              values[i] /= weight[i] > 0 ? weight[i] : 1;
            means.back() = elasticity.with_ghosts(means.back());
          }
        const LA::Vector weights_around = elasticity.with_ghosts(weights);
        for (const Node &node : layer.nodes)
          {
            std::array<double, 12> values{};
            for (unsigned int c = 0; c < n_values; ++c)
              values[c] = mean(node[c % dim], means[c / dim], weights_around);
            add_fields(values);
          }
      }

      /// A vector of the values of the points of all ranks. @param value of point and component
      template <typename Value>
      LA::Vector
      added_up(const Layer &layer, const Value &value) const
      {
        LA::Vector result = elasticity.zero_vector();
        for (unsigned int i = 0; i < layer.nodes.size(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            result(layer.nodes[i][d]) += value(i, d);
        result.compress(VectorOperation::add);
        return result;
      }

      /// The mean at a degree of freedom; at hanging nodes from those that all belong to the layer.
      double
      mean(const types::global_dof_index dof,
           const LA::Vector             &means,
           const LA::Vector             &weights) const
      {
        const auto *const entries = elasticity.hanging_nodes().get_constraint_entries(dof);
        if (!entries || std::any_of(entries->begin(), entries->end(), [&](const auto &entry) {
              return !(weights(entry.first) > 0);
            }))
          return means(dof);
        double result = 0;
        for (const auto &[other, factor] : *entries)
          result += factor * means(other);
        return result;
      }

      /// Add the fields of one point.
      void
      add_fields(const std::array<double, 12> &values)
      {
        auto field = grid.of_points.begin() + 1;
        for (unsigned int first = 0; first < n_values; first += 6)
          {
            SymmetricTensor<2, 3> tensor;
            for (unsigned int c = 0; c < 6; ++c)
              tensor.access_raw_entry(c) = values[first + c];
            for (unsigned int c = 0; c < 9; ++c)
              field->values.push_back(tensor[c / 3][c % 3]);
            for (const double principal : eigenvalues(tensor)) // the largest first
              (++field)->values.push_back(principal);
            ++field;
            if (first == 0)
              grid.of_points.back().values.push_back(von_mises(tensor));
          }
      }

      const Elasticity<dim>          &elasticity;
      const LA::Vector                displacement;
      const unsigned int              n_values; ///< six for each tensor
      const std::vector<unsigned int> layers;   ///< by material id
      std::vector<ElementNodes<dim>>  elements; ///< by active FE index
    };

    /// @return the names of all bodies.
    template <int dim>
    std::vector<std::string>
    names_of_bodies(const Mesh<dim> &mesh)
    {
      std::vector<std::string> names;
      for (unsigned int b = 0; b < mesh.n_bodies(); ++b)
        names.push_back(mesh.body_name(b));
      return names;
    }
  } // namespace



  template <int dim>
  std::string
  write_bodies(const Snapshot<dim> &snapshot, const std::string &directory, const bool with_strain)
  {
    const Mesh<dim>     &mesh = snapshot.elasticity.mesh();
    const NodalGrid<dim> bodies(snapshot, with_strain);
    return write_pieces(
      bodies.grid,
      {directory, "solution", snapshot.step, snapshot.time, "body", names_of_bodies(mesh)},
      mesh.communicator());
  }



  template std::string
  write_bodies(const Snapshot<2> &, const std::string &, bool);
  template std::string
  write_bodies(const Snapshot<3> &, const std::string &, bool);
} // namespace Signorini
