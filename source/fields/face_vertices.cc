// SPDX-License-Identifier: Apache-2.0
#include "fields/recovery_steps.h"
#include "geometry/face_functions.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  FaceVertices<dim>::Functions::Functions(const ReferenceCell &shape, const Point<dim - 1> &xi)
  {
    const FaceFunctions<dim> functions(shape, 1, xi);
    for (unsigned int c = 0; c < functions.size(); ++c)
      {
        value[c] = functions.value(c);
        slope[c] = functions.gradient(c);
      }
  }



  // The vertices of all faces with points are numbered consecutively, first those of rank 0, then
  // those of rank 1 and so on; a temporary vector of the displacement layout transports the numbers
  // to ranks that do not own a vertex.
  template <int dim>
  FaceVertices<dim>::FaceVertices(const Elasticity<dim>             &elasticity,
                                  const std::vector<SlaveFace<dim>> &faces)
  {
    const MPI_Comm comm = elasticity.mesh().communicator();
    // Mark the vertices that any rank uses; their owners count them.
    LA::Vector number = elasticity.zero_vector();
    for (const SlaveFace<dim> &face : faces)
      for (unsigned int c = 0; c < (face.degree > 0 ? n : 0); ++c)
        number(face.nodes[node(c, face)]) += 1;
    number.compress(VectorOperation::add);
    std::vector<types::global_dof_index> own;
    for (const auto i : number.locally_owned_elements())
      if (number(i) > 0)
        own.push_back(i);
    const auto              counts = Utilities::MPI::all_gather(comm, own.size());
    types::global_dof_index next   = 0;
    for (unsigned int rank = 0; rank < Utilities::MPI::this_mpi_process(comm); ++rank)
      next += counts[rank];
    const types::global_dof_index first = next;
    // Replace the marks by consecutive numbers, and read those of the vertices of this rank's
    // faces.
    for (const auto i : own)
      number(i) = next++;
    number.compress(VectorOperation::insert);
    const LA::Vector numbers = elasticity.with_ghosts(number);

    IndexSet owned(Utilities::MPI::sum(own.size(), comm)), readable(owned.size());
    owned.add_range(first, next);
    std::vector<types::global_dof_index> others; // of other ranks
    my_vertices.resize(faces.size());
    for (unsigned int f = 0; f < my_vertices.size(); ++f)
      for (unsigned int c = 0; c < (faces[f].degree > 0 ? n : 0); ++c)
        {
          my_vertices[f][c] = std::lround(numbers(faces[f].nodes[node(c, faces[f])]));
          if (!owned.is_element(my_vertices[f][c]))
            others.push_back(my_vertices[f][c]);
        }
    // Vertices of other ranks become ghost entries of fields.
    readable.add_indices(others.begin(), others.end());
    layout = std::make_shared<Utilities::MPI::Partitioner>(owned, readable, comm);
  }



  template class FaceVertices<2>;
  template class FaceVertices<3>;
} // namespace Signorini
