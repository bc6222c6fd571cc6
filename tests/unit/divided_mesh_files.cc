// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/import_steps.h"

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <sstream>

#include "mesh_helpers.h"

using namespace dealii;
using namespace Signorini;
using namespace MeshTests;

namespace
{
  using Nodes   = std::vector<unsigned int>;
  using Pairs   = std::vector<std::pair<unsigned int, unsigned int>>;
  using Triples = std::vector<std::array<unsigned int, 3>>;

  /// Cells with corners; nodes of second order are added by the writers. The names are those that
  /// the tables below know.
  struct Cells
  {
    std::vector<Point<3>>                      corners;
    std::vector<std::pair<std::string, Nodes>> cells;
  };

  struct Kind
  {
    std::string        abaqus[2];       ///< of first and second order
    unsigned int       gmsh[3], vtk[3]; ///< the third is with the centers of the faces
    std::vector<Nodes> abaqus_edges, gmsh_edges;
    std::vector<Nodes> abaqus_faces, gmsh_faces; ///< whose centers the third has
  };

  /// As the manuals of the programs have it; VTK lists as Abaqus does, where it has no more
  /// nodes.
  const std::map<std::string, Kind> kinds = {
    {"triangle",
     {{"CPE3", "CPS6M"},
      {2, 9, 9},
      {5, 22, 22},
      {{0, 1}, {1, 2}, {2, 0}},
      {{0, 1}, {1, 2}, {2, 0}},
      {},
      {}}},
    {"square",
     {{"CPE4", "CPS8R"},
      {3, 16, 10},
      {9, 23, 28},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
      {{0, 1, 2, 3}},
      {{0, 1, 2, 3}}}},
    {"tetrahedron",
     {{"C3D4H", "C3D10M"},
      {4, 11, 11},
      {10, 24, 24},
      {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}},
      {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}},
      {},
      {}}},
    {"pyramid",
     {{"C3D5", "C3D13"},
      {7, 19, 14},
      {14, 27, 27},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}},
      {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}},
      {},
      {{0, 1, 2, 3}}}},
    {"wedge",
     {{"C3D6", "C3D15"},
      {6, 18, 13},
      {13, 26, 32},
      {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}},
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}},
      {{0, 1, 3, 4}, {1, 2, 4, 5}, {2, 0, 5, 3}},
      {{0, 1, 3, 4}, {0, 2, 3, 5}, {1, 2, 4, 5}}}},
    {"cube",
     {{"C3D8I", "C3D20R"},
      {5, 17, 12},
      {12, 25, 29},
      {{0, 1},
       {1, 2},
       {2, 3},
       {3, 0},
       {4, 5},
       {5, 6},
       {6, 7},
       {7, 4},
       {0, 4},
       {1, 5},
       {2, 6},
       {3, 7}},
      {{0, 1},
       {0, 3},
       {0, 4},
       {1, 2},
       {1, 5},
       {2, 3},
       {2, 6},
       {3, 7},
       {4, 5},
       {4, 7},
       {5, 6},
       {6, 7}},
      {{0, 3, 4, 7},
       {1, 2, 5, 6},
       {0, 1, 4, 5},
       {2, 3, 6, 7},
       {0, 1, 2, 3},
       {4, 5, 6, 7},
       {0, 1, 2, 3, 4, 5, 6, 7}},
      {{0, 1, 2, 3},
       {0, 1, 4, 5},
       {0, 3, 4, 7},
       {1, 2, 5, 6},
       {2, 3, 6, 7},
       {4, 5, 6, 7},
       {0, 1, 2, 3, 4, 5, 6, 7}}}}};

  using Map = std::function<Point<3>(const Point<3> &)>;

  /// Writes cells in each format; order 3 stands for second order with centers of faces.
  class Writer
  {
  public:
    Writer(const Cells &cells, const unsigned int order, const Map &map)
      : mesh(cells)
      , order(order)
      , map(map)
    {
      for (const Point<3> &corner : mesh.corners)
        points.push_back(map(corner));
    }

    std::string
    inp()
    {
      std::string elements;
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        {
          const auto &[name, corners] = mesh.cells[c];
          const Kind &kind            = kinds.at(name);
          elements +=
            "*ELEMENT, TYPE=" + kind.abaqus[order > 1] + ", ELSET=all\n" + std::to_string(c + 1);
          for (const unsigned int node : nodes(corners, kind.abaqus_edges, {}))
            elements += ",\n" + std::to_string(node + 1);
          elements += "\n";
        }
      return "*NODE\n" + list(", ", 1) + elements;
    }

    std::string
    msh()
    {
      std::string elements;
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        {
          const auto &[name, corners] = mesh.cells[c];
          const Kind &kind            = kinds.at(name);
          elements += std::to_string(c + 1) + " " + std::to_string(kind.gmsh[order - 1]) + " 2 1 1";
          for (const unsigned int node : nodes(corners, kind.gmsh_edges, kind.gmsh_faces))
            elements += " " + std::to_string(node + 1);
          elements += "\n";
        }
      return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(points.size()) +
             "\n" + list(" ", 1) + "$EndNodes\n$Elements\n" + std::to_string(mesh.cells.size()) +
             "\n" + elements + "$EndElements\n";
    }

    std::string
    vtk()
    {
      std::string  elements, types;
      unsigned int n = 0;
      for (const auto &[name, corners] : mesh.cells)
        {
          const Kind &kind = kinds.at(name);
          const Nodes list = nodes(corners, kind.abaqus_edges, kind.abaqus_faces, kind.vtk);
          elements += std::to_string(list.size());
          for (const unsigned int node : list)
            elements += " " + std::to_string(node);
          elements += "\n";
          types += std::to_string(kind.vtk[order - 1]) + "\n";
          n += 1 + list.size();
        }
      return "# vtk DataFile Version 3.0\ncells\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
             std::to_string(points.size()) + " double\n" + list(" ") + "CELLS " +
             std::to_string(mesh.cells.size()) + " " + std::to_string(n) + "\n" + elements +
             "CELL_TYPES " + std::to_string(mesh.cells.size()) + "\n" + types;
    }

    std::string
    vtu()
    {
      std::string  elements, types, ends;
      unsigned int n = 0;
      for (const auto &[name, corners] : mesh.cells)
        {
          const Kind &kind = kinds.at(name);
          const Nodes list = nodes(corners, kind.abaqus_edges, kind.abaqus_faces, kind.vtk);
          for (const unsigned int node : list)
            elements += std::to_string(node) + " ";
          types += std::to_string(kind.vtk[order - 1]) + " ";
          ends += std::to_string(n += list.size()) + " ";
        }
      const auto array = [](const std::string &name, const std::string &text) {
        return "<DataArray type=\"Float64\" Name=\"" + name + "\" format=\"ascii\">" + text +
               "</DataArray>";
      };
      return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece><Points>" +
             array("Points", list(" ")) + "</Points><Cells>" + array("connectivity", elements) +
             array("offsets", ends) + array("types", types) +
             "</Cells></Piece></UnstructuredGrid></VTKFile>";
    }

  private:
    Nodes
    nodes(const Nodes              &corners,
          const std::vector<Nodes> &edges,
          const std::vector<Nodes> &faces,
          const unsigned int       *types = nullptr)
    {
      Nodes result = corners;
      for (const Nodes &edge : edges)
        if (order > 1)
          result.push_back(middle(corners, edge));
      for (const Nodes &face : faces)
        if (order > 2 && !(types && types[2] == types[1]))
          result.push_back(middle(corners, face));
      return result;
    }

    unsigned int
    middle(const Nodes &corners, const Nodes &places)
    {
      std::vector<unsigned int> key;
      Point<3>                  center;
      for (const unsigned int place : places)
        {
          key.push_back(corners[place]);
          center += mesh.corners[corners[place]] / static_cast<double>(places.size());
        }
      std::sort(key.begin(), key.end());
      const auto [entry, is_new] = middles.insert({key, points.size()});
      if (is_new)
        points.push_back(map(center));
      return entry->second;
    }

    std::string
    list(const std::string &separator, const unsigned int first_number = 0) const
    {
      std::ostringstream out;
      out.precision(17);
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          if (first_number > 0)
            out << i + first_number << separator;
          out << points[i][0] << separator << points[i][1] << separator << points[i][2] << "\n";
        }
      return out.str();
    }

    const Cells                   mesh;
    const unsigned int            order;
    const Map                     map;
    std::vector<Point<3>>         points;
    std::map<Nodes, unsigned int> middles;
  };



  /// A unit cube of n cells a side, or a square, whose nodes are numbered at random.
  class Lattice
  {
  public:
    Lattice(const unsigned int n, const unsigned int dim, const unsigned int seed)
      : n(n)
      , dim(dim)
    {
      const unsigned int n_nodes = std::pow(n + 1, dim);
      for (unsigned int i = 0; i < n_nodes; ++i)
        number.push_back(i);
      std::shuffle(number.begin(), number.end(), std::mt19937(seed));
      mesh.corners.resize(n_nodes);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n + 1)
          mesh.corners[number[i]][d] = rest % (n + 1) / static_cast<double>(n);
    }

    unsigned int
    node(const unsigned int x, const unsigned int y, const unsigned int z) const
    {
      return number[x + (n + 1) * (y + (n + 1) * z)];
    }

    /// The corners of a cell, around the bottom and around the top.
    Nodes
    corners(const unsigned int x, const unsigned int y, const unsigned int z = 0) const
    {
      Nodes result;
      for (unsigned int top = 0; top + 1 < dim; ++top)
        for (const auto &[i, j] : Pairs{{0, 0}, {1, 0}, {1, 1}, {0, 1}})
          result.push_back(node(x + i, y + j, z + top));
      return result;
    }

    const unsigned int n, dim;
    Nodes              number;
    Cells              mesh;
  };

  /// Six around the line from the first to the seventh corner; neighbours fit.
  void
  add_tetrahedra(Cells &mesh, const Nodes &c)
  {
    for (const auto &[a, b] : Pairs{{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
      mesh.cells.push_back({"tetrahedron", {c[0], c[a], c[b], c[6]}});
  }

  /// Six around the center, or tetrahedra instead of those on sides that are to be cut.
  void
  add_pyramids(Cells &mesh, const Nodes &c, const unsigned int cut)
  {
    Point<3> sum;
    for (const unsigned int node : c)
      sum += mesh.corners[node] / 8.;
    const unsigned int apex = mesh.corners.size();
    mesh.corners.push_back(sum);
    unsigned int side = 0;
    for (const auto &face : std::vector<std::array<unsigned int, 4>>{{{0, 4, 7, 3}},
                                                                     {{1, 2, 6, 5}},
                                                                     {{0, 1, 5, 4}},
                                                                     {{3, 7, 6, 2}},
                                                                     {{0, 3, 2, 1}},
                                                                     {{4, 5, 6, 7}}})
      {
        const Nodes f{c[face[3]], c[face[2]], c[face[1]], c[face[0]]};
        if (cut & (1u << side++))
          {
            mesh.cells.push_back({"tetrahedron", {f[0], f[1], f[2], apex}});
            mesh.cells.push_back({"tetrahedron", {f[0], f[2], f[3], apex}});
          }
        else
          mesh.cells.push_back({"pyramid", {f[0], f[1], f[2], f[3], apex}});
      }
  }

  Cells
  tetrahedra(const unsigned int seed)
  {
    Lattice lattice(2, 3, seed);
    for (unsigned int z = 0; z < 2; ++z)
      for (unsigned int y = 0; y < 2; ++y)
        for (unsigned int x = 0; x < 2; ++x)
          add_tetrahedra(lattice.mesh, lattice.corners(x, y, z));
    return lattice.mesh;
  }

  /// Columns of wedges and columns of cubes; with pyramids, some cubes become these, and at the
  /// side x = 0 tetrahedra.
  Cells
  mixed(const unsigned int seed, const bool with_pyramids)
  {
    Lattice      lattice(3, 3, seed);
    std::mt19937 random(seed);
    for (unsigned int y = 0; y < 3; ++y)
      for (unsigned int x = 0; x < 3; ++x)
        {
          const unsigned int kind = (x == 1 && y == 1) ? 0 : random() % 3;
          for (unsigned int z = 0; z < 3; ++z)
            {
              const Nodes c = lattice.corners(x, y, z);
              if (kind == 0)
                for (const auto &[i, j, k] : Triples{{{0, 1, 2}}, {{0, 2, 3}}})
                  lattice.mesh.cells.push_back(
                    {"wedge", {c[i], c[j], c[k], c[i + 4], c[j + 4], c[k + 4]}});
              else if (with_pyramids && random() % 2 == 0)
                add_pyramids(lattice.mesh, c, x == 0);
              else
                lattice.mesh.cells.push_back({"cube", c});
            }
        }
    return lattice.mesh;
  }

  Cells
  plane(const unsigned int seed)
  {
    Lattice      lattice(4, 2, seed);
    std::mt19937 random(seed);
    for (unsigned int y = 0; y < 4; ++y)
      for (unsigned int x = 0; x < 4; ++x)
        {
          const Nodes c = lattice.corners(x, y);
          if (random() % 2 == 0)
            lattice.mesh.cells.push_back({"square", c});
          else
            for (const auto &[i, j, k] : Triples{{{0, 1, 2}}, {{0, 2, 3}}})
              lattice.mesh.cells.push_back({"triangle", {c[i], c[j], c[k]}});
        }
    return lattice.mesh;
  }



  /// Linear and quadratic, different in all directions. The volume of the image of the unit cube is
  /// the integral of the determinant: it is 1 + a linear function in x, y, z.
  Point<3>
  bent(const Point<3> &p, const unsigned int dim)
  {
    const double x = p[0], y = p[1], z = p[2];
    return dim == 2 ? Point<3>(x + 0.1 * y * y, y + 0.12 * x * x + 0.1 * x * y, 0) :
                      Point<3>(x + 0.1 * y * y + 0.05 * y * z,
                               y + 0.08 * z * z + 0.06 * z,
                               z + 0.1 * z * z + 0.07 * z);
  }

  /// In 2D det = 1 + 0.1 x - 0.2 y (0.24 x + 0.1 y); in 3D it is 1.07 + 0.2 z.
  double
  volume_of_bent(const unsigned int dim)
  {
    return dim == 2 ? 1 + 0.05 - 0.2 * (0.24 / 4 + 0.1 / 3) : 1.07 + 0.1;
  }

  Point<3>
  linear(const Point<3> &p, const unsigned int dim)
  {
    return Point<3>(1.5 * p[0] + 0.2 * p[1], p[1], dim == 2 ? 0 : p[2] + 0.3 * p[0] - 0.1 * p[1]);
  }

  Map
  linear_map(const unsigned int dim)
  {
    return [dim](const Point<3> &p) { return linear(p, dim); };
  }

  Map
  bent_map(const unsigned int dim)
  {
    return [dim](const Point<3> &p) { return bent(p, dim); };
  }

  Point<3>
  same(const Point<3> &p)
  {
    return p;
  }



  /// The volume that the boundary encloses, by the divergence theorem.
  template <int dim>
  double
  enclosed(const Triangulation<dim> &triangulation)
  {
    const MappingQ<dim>   mapping(2);
    const FE_Nothing<dim> fe;
    FEFaceValues<dim>     values(mapping,
                             fe,
                             QGauss<dim - 1>(5),
                             update_quadrature_points | update_normal_vectors | update_JxW_values);
    double                sum = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          {
            values.reinit(cell, f);
            for (const unsigned int q : values.quadrature_point_indices())
              sum += values.quadrature_point(q) * values.normal_vector(q) * values.JxW(q) / dim;
          }
    return sum;
  }

  /// Areas of the boundaries.
  template <int dim>
  std::map<std::string, double>
  areas(const CoarseMesh<dim> &mesh)
  {
    Triangulation<dim> triangulation;
    create(triangulation, mesh);
    const MappingQ<dim>           mapping(2);
    const FE_Nothing<dim>         fe;
    FEFaceValues<dim>             values(mapping, fe, QGauss<dim - 1>(4), update_JxW_values);
    std::map<std::string, double> result;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          {
            values.reinit(cell, f);
            for (const unsigned int q : values.quadrature_point_indices())
              result[mesh.boundaries[cell->face(f)->boundary_id()]] += values.JxW(q);
          }
    return result;
  }

  template <int dim>
  CoarseMesh<dim>
  mesh_of(const std::string &text, const std::string &extension, Keys keys = {})
  {
    const TemporaryFile file(text, extension);
    keys.push_back({"File", file.path});
    return generator<dim>("file", keys)->generate();
  }

  template <int dim>
  void
  check(const std::string &text, const std::string &extension, const double exact)
  {
    CAPTURE(extension);
    const CoarseMesh<dim> mesh = mesh_of<dim>(text, extension);
    Triangulation<dim>    triangulation;
    create(triangulation, mesh);
    CHECK(std::abs(volume(triangulation) - exact) < 1e-11);
    // Conforming: the boundary is closed, and nothing is left out or there twice inside.
    CHECK(std::abs(enclosed(triangulation) - exact) < 1e-11);
    // The shape is that of the map on finer meshes too, whose cells are placed by the manifolds.
    triangulation.refine_global(1);
    CHECK(std::abs(volume(triangulation) - exact) < 1e-11);
  }

  template <int dim>
  void
  check_all_formats(const Cells &cells, const std::vector<unsigned int> &orders)
  {
    for (const unsigned int order : orders)
      {
        CAPTURE(order);
        const Map    map   = order == 1 ? linear_map(dim) : bent_map(dim);
        const double exact = order == 1 ? 1.5 : volume_of_bent(dim);
        if (order < 3) // Abaqus has no such nodes in wedges and pyramids
          check<dim>(Writer(cells, order, map).inp(), ".inp", exact);
        check<dim>(Writer(cells, order, map).msh(), ".msh", exact);
        check<dim>(Writer(cells, order, map).vtk(), ".vtk", exact);
        check<dim>(Writer(cells, order, map).vtu(), ".vtu", exact);
      }
  }



  const std::string four_nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n";

  /// The cube of tetrahedra, and sets of its nodes and faces.
  std::string
  cube_with(const std::string &sets)
  {
    return Writer(tetrahedra(7), 1, same).inp() + sets;
  }

  /// Numbers of the nodes of that cube where a condition holds, as a node set.
  std::string
  node_set(const std::string &name, const std::function<bool(const Point<3> &)> &wanted)
  {
    const Cells cells = tetrahedra(7);
    std::string text  = "*NSET, NSET=" + name + "\n";
    for (unsigned int i = 0; i < cells.corners.size(); ++i)
      if (wanted(cells.corners[i]))
        text += std::to_string(i + 1) + "\n";
    return text;
  }
} // namespace



TEST_CASE("divided: tetrahedra in all formats and orders have the volume of the map, and no holes")
{
  check_all_formats<3>(tetrahedra(1), {1, 2});
}

TEST_CASE("divided: wedges and hexahedra together")
{
  check_all_formats<3>(mixed(2, false), {1, 2, 3});
}

TEST_CASE("divided: wedges, hexahedra, pyramids and tetrahedra together")
{
  check_all_formats<3>(mixed(3, true), {1, 2});
}

TEST_CASE("divided: triangles and quadrilaterals in all formats and orders")
{
  check_all_formats<2>(plane(4), {1, 2, 3});
}

TEST_CASE("divided: mixed meshes whose nodes are numbered at random")
{
  for (unsigned int seed = 10; seed < 16; ++seed)
    {
      CAPTURE(seed);
      const Cells solid = mixed(seed, seed % 2 == 0), flat = plane(seed);
      check<3>(Writer(solid, 1, linear_map(3)).vtk(), ".vtk", 1.5);
      check<3>(Writer(solid, 2, bent_map(3)).msh(), ".msh", volume_of_bent(3));
      check<2>(Writer(flat, 1, same).inp(), ".inp", 1);
    }
}



TEST_CASE("divided: linear fields at the nodes stay linear")
{
  const auto linear = [](const Point<3> &x) { return 3 + 2 * x[0] - 5 * x[1] + 7 * x[2]; };
  for (const bool pyramids : {false, true})
    for (const unsigned int order : {1u, 2u})
      {
        const TemporaryFile  text(Writer(mixed(5, pyramids), order, linear_map(3)).vtk(), ".vtk");
        MeshFile             file   = read_mesh_file(text.path);
        std::vector<double> &values = file.fields["T"];
        for (const Point<3> &x : file.nodes)
          values.push_back(linear(x));
        divide_cells(file, 3, "", true);
        REQUIRE(values.size() == file.nodes.size());
        double largest = 0;
        for (unsigned int i = 0; i < values.size(); ++i)
          largest = std::max(largest, std::abs(values[i] - linear(file.nodes[i])));
        CHECK(largest < 1e-12);
      }
}



TEST_CASE("divided: cells that are there twice, and quadrilaterals on triangles, are refused")
{
  const std::string nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n"
                            "6, 1, 0, 1\n7, 1.2, 1.3, 1\n8, 0, 1, 1\n9, 0.5, 0.5, 2\n";
  const auto        what  = [&](const std::string &elements) {
    const TemporaryFile file(nodes + elements, ".inp");
    return message_of([&] { generator<3>("file", {{"File", file.path}})->generate(); });
  };
  says(what("*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 5\n2, 2, 3, 1, 5\n"), "twice");
  // Two tetrahedra on a cube: the upper face of the cube is a quadrilateral, theirs are triangles.
  const std::string cube = "*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
  says(what(cube + "*ELEMENT, TYPE=C3D4\n2, 5, 6, 7, 9\n3, 5, 7, 8, 9\n"),
       "has a quadrilateral face of element 1");
  CHECK(what(cube + "*ELEMENT, TYPE=C3D5\n2, 5, 6, 7, 8, 9\n").empty());
}



TEST_CASE("cells of different sizes that do not share their nodes are refused")
{
  const std::string nodes =
    "*NODE\n1, 0, 0\n2, 2, 0\n3, 2, 1\n4, 0, 1\n5, 1, 1\n6, 0, 2\n7, 1, 2\n"
    "8, 2, 2\n*ELEMENT, TYPE=CPE4\n1, 1, 2, 3, 4\n2, 4, 5, 7, 6\n3, 5, 3, 8, 7\n";
  const TemporaryFile file(nodes, ".inp");
  const auto          what = [&](const std::string &coinciding) {
    return message_of([&] {
      generator<2>("file", {{"File", file.path}, {"Coinciding nodes", coinciding}})->generate();
    });
  };
  says(what("error"), "has a node at (1 1) on the edge of a cell");
  CHECK(what("keep").empty());
}



TEST_CASE("divided: how many cells each shape gives")
{
  const auto n = [](const std::string &name, const Nodes &corners) {
    Cells cells;
    cells.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}};
    cells.cells   = {{name, corners}};
    return mesh_of<3>(Writer(cells, 1, same).inp(), ".inp").cells.size();
  };
  CHECK(n("tetrahedron", {0, 1, 2, 4}) == 4);
  CHECK(n("wedge", {0, 1, 2, 4, 5, 6}) == 6);
  CHECK(n("pyramid", {0, 1, 2, 3, 4}) == 8);
  Cells cells;
  cells.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  cells.cells   = {{"triangle", {0, 1, 2}}};
  CHECK(mesh_of<2>(Writer(cells, 1, same).msh(), ".msh").cells.size() == 3);
}



TEST_CASE("divided: sets of nodes, surfaces and elements on faces name the parts of these faces")
{
  const auto on = [](const unsigned int d, const double value) {
    return [=](const Point<3> &p) { return p[d] == value; };
  };
  const std::string sets = node_set("base", on(2, 0)) + node_set("top", on(2, 1)) +
                           node_set("Nall", [](const Point<3> &) { return true; });
  auto found = areas(mesh_of<3>(cube_with(sets), ".inp"));
  CHECK(std::abs(found.at("base") - 1) < 1e-12);
  CHECK(std::abs(found.at("top") - 1) < 1e-12);
  CHECK(std::abs(found.at("unnamed") - 4) < 1e-12);
  CHECK(found.size() == 3); // a set of all nodes is no boundary

  // Without one corner, the faces there are left out, with all of their parts: the corner at the
  // middle of the side has six triangles of 1/8 around it.
  const std::string hole =
    node_set("side", [](const Point<3> &p) { return p[0] == 1 && !(p[1] == 0.5 && p[2] == 0.5); });
  found = areas(mesh_of<3>(cube_with(hole), ".inp"));
  CHECK(std::abs(found.at("side") - 2. / 8) < 1e-12);

  // Faces of elements, and triangles beside the cells.
  std::string surface = "*SURFACE, NAME=skin\nall\n";
  found               = areas(mesh_of<3>(cube_with(surface), ".inp"));
  CHECK(std::abs(found.at("skin") - 6) < 1e-12);
  const TemporaryFile one(
    four_nodes + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=STRI65, ELSET=none\n"
                 "*ELEMENT, TYPE=S3, ELSET=shell\n2, 3, 1, 2\n*ELSET, ELSET=body\n1\n"
                 "*SURFACE, NAME=x\nbody, S4\n*SURFACE, NAME=slope\nbody, S3\n"
                 "*SURFACE, NAME=y\nbody, S2\n",
    ".inp");
  found = areas(generator<3>("file", {{"File", one.path}})->generate());
  CHECK(found.size() == 4);
  CHECK(std::abs(found.at("shell") - 0.5) < 1e-12);
  CHECK(std::abs(found.at("x") - 0.5) < 1e-12);
  CHECK(std::abs(found.at("y") - 0.5) < 1e-12);
  CHECK(std::abs(found.at("slope") - std::sqrt(0.75)) < 1e-12);
}



TEST_CASE("divided: labels of the faces of wedges and pyramids")
{
  const TemporaryFile wedge(
    four_nodes + "5, 1, 0, 2\n6, 0, 1, 2\n7, 0, 0, 2\n*ELEMENT, TYPE=C3D6, ELSET=a\n"
                 "1, 1, 2, 3, 7, 5, 6\n*SURFACE, NAME=one\na, S1\n*SURFACE, NAME=two\na, S2\n"
                 "*SURFACE, NAME=three\na, S3\n*SURFACE, NAME=four\na, S4\n"
                 "*SURFACE, NAME=five\na, S5\n",
    ".inp");
  auto found = areas(generator<3>("file", {{"File", wedge.path}})->generate());
  CHECK(std::abs(found.at("one") - 0.5) < 1e-12);
  CHECK(std::abs(found.at("two") - 0.5) < 1e-12);
  CHECK(std::abs(found.at("three") - 2) < 1e-12);
  CHECK(std::abs(found.at("four") - 2 * std::sqrt(2.)) < 1e-12);
  CHECK(std::abs(found.at("five") - 2) < 1e-12);

  const TemporaryFile pyramid(
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n"
    "*ELEMENT, TYPE=C3D5, ELSET=a\n1, 1, 2, 3, 4, 5\n*SURFACE, NAME=base\na, S1\n"
    "*SURFACE, NAME=y0\na, S2\n*SURFACE, NAME=x1\na, S3\n*SURFACE, NAME=y1\na, S4\n"
    "*SURFACE, NAME=x0\na, S5\n",
    ".inp");
  found = areas(generator<3>("file", {{"File", pyramid.path}})->generate());
  CHECK(std::abs(found.at("base") - 1) < 1e-12);
  CHECK(std::abs(found.at("y0") - 0.5) < 1e-12);
  CHECK(std::abs(found.at("x0") - 0.5) < 1e-12);
  CHECK(std::abs(found.at("x1") - std::sqrt(0.5)) < 1e-12);
  CHECK(std::abs(found.at("y1") - std::sqrt(0.5)) < 1e-12);
}



TEST_CASE("divided: pieces and parts of hexahedra alone stay as they are")
{
  // A cube; a tetrahedron apart; and one that shares a face's diagonal with the cube.
  const std::string cube =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n"
    "8, 0, 1, 1\n9, 0.5, 0.5, 3\n10, 2, 0, 3\n11, 2, 1, 3\n12, 2, 0, 4\n"
    "*ELEMENT, TYPE=C3D8, ELSET=cube\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*ELEMENT, TYPE=C3D4, ELSET=apart\n"
    "2, 9, 10, 11, 12\n";
  CHECK(mesh_of<3>(cube, ".inp").cells.size() == 5);
  const std::string wedge = cube +
                            "*NODE\n13, 2, 0, 0\n14, 2, 0, 1\n*ELEMENT, TYPE=C3D6, ELSET=roof\n"
                            "3, 2, 13, 3, 6, 14, 7\n";
  CHECK(mesh_of<3>(wedge, ".inp").cells.size() == 8 + 4 + 6);
  CHECK(mesh_of<3>(wedge, ".inp", {{"Part", "cube"}}).cells.size() == 1);
  CHECK(mesh_of<3>(wedge, ".inp", {{"Part", "roof"}}).cells.size() == 6);
}



TEST_CASE("divided: hexahedra and quadrilaterals that stand for other shapes")
{
  const std::string nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n"
                            "6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n11, .5, 0, 0\n12, 1, .5, 0\n"
                            "13, .5, .5, 0\n14, .5, 0, 1\n15, 1, .5, 1\n16, .5, .5, 1\n"
                            "17, 0, 0, .5\n18, 1, 0, .5\n19, 1, 1, .5\n";
  const auto check = [&](const std::string &element, const double exact, const unsigned int n) {
    const auto       mesh = mesh_of<3>(nodes + "*ELEMENT, TYPE=" + element + "\n", ".inp");
    Triangulation<3> triangulation;
    create(triangulation, mesh);
    CHECK(triangulation.n_active_cells() == n);
    CHECK(std::abs(volume(triangulation) - exact) < 1e-13);
  };
  check("C3D8\n1, 1, 2, 3, 3, 5, 6, 7, 7", 0.5, 6);
  check("C3D8\n1, 1, 2, 6, 5, 4, 3, 3, 4", 0.5, 6);
  check("C3D8\n1, 1, 2, 3, 4, 5, 5, 5, 5", 1. / 3, 8);
  check("C3D8\n1, 1, 2, 3, 3, 5, 5, 5, 5", 1. / 6, 4);
  check("C3D20\n1, 1, 2, 3, 3, 5, 6, 7, 7, 11, 12, 3, 13, 14, 15,\n7, 16, 17, 18, 19, 19", 0.5, 6);
  CHECK(mesh_of<2>("*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n*ELEMENT, TYPE=CPS4\n1, 1, 2, 3, 3\n", ".inp")
          .cells.size() == 3);
  says(message_of([&] { check("C3D8\n1, 1, 2, 3, 3, 1, 2, 3, 3", 0, 0); }), "element 1");
}



TEST_CASE("divided: coinciding nodes are merged before")
{
  // Two wedges with nodes of their own at their common square, whose diagonals would differ.
  const std::string text =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 1, 0, 1\n6, 0, 1, 1\n"
    "7, 1, 1, 0\n8, 1, 1, 1\n19, 1, 0, 0\n18, 0, 1, 0\n17, 1, 0, 1\n16, 0, 1, 1\n9, 0, 0, 2\n"
    "*ELEMENT, TYPE=C3D6\n1, 1, 2, 3, 4, 5, 6\n2, 19, 7, 18, 17, 8, 16\n"
    "*NSET, NSET=square\n1, 2, 3, 7, 18, 19\n";
  CHECK(message_of([&] { mesh_of<3>(text, ".inp"); }).empty()); // two pieces
  const Keys merge{{"Coinciding nodes", "merge"}};
  CHECK(mesh_of<3>(text, ".inp", merge).cells.size() == 12);
  CHECK(std::abs(areas(mesh_of<3>(text, ".inp", merge)).at("square") - 1) < 1e-12);
  CHECK(std::abs(areas(mesh_of<3>(text, ".inp", merge)).at("unnamed") - 5) < 1e-12);
}



TEST_CASE("divided: Mid-side nodes = no gives cells between the corners")
{
  const Map  map = bent_map(2);
  const Keys straight{{"Mid-side nodes", "no"}, {"Curved boundaries", "none"}};
  const auto mesh = mesh_of<2>(Writer(plane(5), 2, map).inp(), ".inp", straight);
  CHECK(mesh.manifolds.empty());
  const auto       corners = mesh_of<2>(Writer(plane(5), 1, map).inp(), ".inp", straight);
  Triangulation<2> one, other;
  create(one, mesh);
  create(other, corners);
  CHECK(one.n_active_cells() == other.n_active_cells());
  CHECK(std::abs(volume(one) - volume(other)) < 1e-12);
}



TEST_CASE("divided: cells listed the other way round are turned, folded and flat ones refused")
{
  const auto attempt = [](const std::string &elements) {
    return message_of([&] { mesh_of<3>(four_nodes + elements, ".inp"); });
  };
  const auto       turned = mesh_of<3>(four_nodes + "*ELEMENT, TYPE=C3D4\n1, 1, 3, 2, 4\n", ".inp");
  Triangulation<3> triangulation;
  create(triangulation, turned);
  CHECK(std::abs(volume(triangulation) - 1. / 6) < 1e-14);

  says(attempt("5, 0.5, 0.5, 0\n*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n17, 1, 2, 3, 5\n"),
       "1 cell that is folded or flat: element 17 of type C3D4");
  says(attempt("5, 0.5, 0.5, 0\n*ELEMENT, TYPE=C3D4\n17, 1, 2, 3, 5\n"), "in one plane");
  says(attempt("*ELEMENT, TYPE=C3D4\n17, 1, 2, 3, 3\n"), "element 17 of type C3D4");
  says(attempt("5, 0.3, 0.3, -1\n6, 1, 1, 2\n*ELEMENT, TYPE=C3D6\n18, 1, 2, 3, 4, 5, 6\n"),
       "element 18 of type C3D6");
  // The middle of the first edge beyond its end.
  says(attempt("5, 1.5, 0, 0\n6, .5, .5, 0\n7, 0, .5, 0\n8, 0, 0, .5\n9, .5, 0, .5\n10, 0, .5, .5\n"
               "*ELEMENT, TYPE=C3D10\n19, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n"),
       "Mid-side nodes = no");
  // Neighbours with middles of their own at a common edge.
  says(message_of([&] {
         mesh_of<2>("*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n4, 1, 1\n5, .5, 0\n6, .5, .5\n7, 0, .5\n"
                    "8, 1, .5\n9, .5, 1\n10, .5, .5\n*ELEMENT, TYPE=CPS6\n1, 1, 2, 3, 5, 6, 7\n"
                    "2, 2, 4, 3, 8, 9, 10\n",
                    ".inp");
       }),
       "where a neighbour has another one");
}



TEST_CASE("divided: new nodes on curved boundaries are moved onto these")
{
  // Straight triangles whose corners are on the unit circle: an octagon.
  std::string text = "*NODE\n100, 0, 0\n", triangles = "*ELEMENT, TYPE=CPS3\n",
              rim = "*NSET, NSET=rim\n";
  for (unsigned int i = 0; i < 8; ++i)
    {
      const double       angle = numbers::PI / 4 * i;
      std::ostringstream line;
      line.precision(17);
      line << i + 1 << ", " << std::cos(angle) << ", " << std::sin(angle) << "\n";
      text += line.str();
      triangles += std::to_string(i + 1) + ", 100, " + std::to_string(i + 1) + ", " +
                   std::to_string((i + 1) % 8 + 1) + "\n";
      rim += std::to_string(i + 1) + "\n";
    }
  const auto mesh =
    mesh_of<2>(text + triangles + rim, ".inp", {{"Curved boundaries", "rim circle 0 0"}});
  Triangulation<2> triangulation;
  create(triangulation, mesh);
  CHECK(std::abs(volume(triangulation) - numbers::PI) < 1e-3);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      CHECK(std::abs(face->vertex(0).norm() - 1) < 1e-12);
}



TEST_CASE("divided: the notes count cells and name the worst")
{
  const auto notes = [](const std::string &text, const unsigned int dim) {
    const TemporaryFile file(text, ".inp");
    MeshFile            mesh = read_mesh_file(file.path);
    return divide_cells(mesh, dim, "", true);
  };
  // A regular tetrahedron; and one that is nearly flat.
  const std::string nodes = "*NODE\n1, 1, 1, 1\n2, -1, -1, 1\n3, -1, 1, -1\n4, 1, -1, -1\n"
                            "5, 5, 0, 0\n6, 6, 0, 0\n7, 5, 1, 0\n8, 5, 0, 1e-4\n";
  auto              said  = notes(nodes + "*ELEMENT, TYPE=C3D4\n5, 1, 2, 3, 4\n", 3);
  REQUIRE(said.size() == 2);
  CHECK(said[0] == "1 tetrahedron divided into 4 hexahedra");
  says(said[1], "the worst shape has element 5 (C3D4) 0.71");
  said = notes(nodes + "*ELEMENT, TYPE=C3D4\n5, 1, 2, 3, 4\n6, 5, 6, 7, 8\n", 3);
  CHECK(said[0] == "2 tetrahedra divided into 8 hexahedra");
  says(said[1], "warning: 1 cell is nearly flat");
  says(said[1], "element 6 (C3D4)");
  says(notes(Writer(mixed(3, true), 1, linear_map(3)).inp(), 3)[0],
       "divided into tetrahedra first");
  CHECK(notes("*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*ELEMENT, TYPE=S4\n1, 1, 2, 3, 4\n", 2)
          .empty());
}



TEST_CASE("coordinates that are no finite decimal numbers are refused with their place")
{
  for (const std::string word : {"nan", "inf", "-inf", "0x1p4", "1e999", "NAN(1)"})
    {
      CAPTURE(word);
      const auto attempt = [&](const std::string &text, const std::string &extension) {
        return message_of([&] { mesh_of<2>(text, extension); });
      };
      says(attempt("*NODE\n1, 0, 0\n2, " + word + ", 1\n", ".inp"), "line 3");
      const std::string rest = "\n$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n",
                        head =
                          "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n";
      says(attempt(head + "3 0 " + word + " 0" + rest, ".msh"), "line 8");
      says(attempt(head + "3 0 1 " + word + rest, ".msh"), "$Nodes");
      says(attempt("# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 "
                   "double\n0 0 0\n1 " +
                     word + " 0 0 1 0\n",
                   ".vtk"),
           "line 7");
      says(attempt("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece><Points>"
                   "<DataArray Name=\"Points\" format=\"ascii\">0 0 0 " +
                     word + " 1 0</DataArray></Points></Piece></UnstructuredGrid></VTKFile>",
                   ".vtu"),
           "'Points' behind"); // of 0x1p4 the 0 is still a number
    }
  // Not a number in binary: two floats of 1 and then the bits of it.
  std::string       bytes;
  const std::string one("\x3f\x80\x00\x00", 4), none("\x7f\xc0\x00\x00", 4);
  for (unsigned int i = 0; i < 9; ++i)
    bytes += i == 5 ? none : one;
  const std::string cell("\x00\x00\x00\x03\x00\x00\x00\x00\x00\x00\x00\x01\x00\x00\x00\x02", 16),
    type("\x00\x00\x00\x05", 4);
  says(message_of([&] {
         mesh_of<2>(
           "# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 "
           "float\n" +
             bytes + "\nCELLS 1 4\n" + cell + "\nCELL_TYPES 1\n" + type + "\n",
           ".vtk");
       }),
       "point 1, counted from 0, whose z is no finite number");
}
