// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_elements.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <map>

namespace Signorini
{
  namespace
  {
    using Shape = MeshFile::Shape;
    using Nodes = MeshFile::Nodes;

    /// @return the three-dimensional shape with a number of nodes.
    Shape
    solid_with(const unsigned int n_nodes)
    {
      switch (n_nodes)
        {
          case 4:
          case 10:
            return Shape::tetrahedron;
          case 5:
          case 13:
            return Shape::pyramid;
          case 6:
          case 15:
            return Shape::wedge;
          case 8:
          case 20:
          case 27:
            return Shape::hexahedron;
          default:
            return Shape::unknown;
        }
    }



    /// @return the two-dimensional shape with a number of nodes.
    Shape
    plane_with(const unsigned int n_nodes)
    {
      switch (n_nodes)
        {
          case 3:
          case 6:
            return Shape::triangle;
          case 4:
          case 8:
          case 9:
            return Shape::quadrilateral;
          default:
            return Shape::unknown;
        }
    }



    /// Element types whose names have a common start, and the dimension of their shapes.
    struct Family
    {
      std::string  start;
      unsigned int dimension;
    };

    /// The longer of two names with a common start comes first. The names of points and lines may
    /// continue in any way, those of other types with the number of nodes.
    const std::vector<Family> families = {{"C3D", 3},    {"DC3D", 3},  {"F3D", 3},  {"AC3D", 3},
                                          {"SC", 3},     {"CPEG", 2},  {"CPE", 2},  {"CPS", 2},
                                          {"CAX", 2},    {"CGAX", 2},  {"DC2D", 2}, {"DCAX", 2},
                                          {"AC2D", 2},   {"SFM3D", 2}, {"M3D", 2},  {"R3D", 2},
                                          {"STRI", 2},   {"DS", 2},    {"S", 2},    {"T2D", 1},
                                          {"T3D", 1},    {"R2D", 1},   {"RAX", 1},  {"RB2D", 1},
                                          {"SPRING", 1}, {"CONN", 1},  {"GAP", 1},  {"DASHPOT", 1},
                                          {"PIPE", 1},   {"B2", 1},    {"B3", 1},   {"MASS", 0},
                                          {"ROTARY", 0}, {"DCOUP", 0}};
  } // namespace



  // The start of the name determines the family, the digits after it the number of nodes.
  AbaqusType
  abaqus_type(const std::string &name)
  {
    for (const auto &[start, dimension] : families)
      {
        if (name.compare(0, start.size(), start) != 0)
          continue;
        if (dimension < 2)
          return {dimension == 0 ? Shape::point : Shape::line, 0};
        unsigned int n = std::strtoul(name.c_str() + start.size(), nullptr, 10);
        if (start == "STRI" && n == 65)
          n = 6; // of five degrees of freedom each
        const Shape shape = dimension == 3 ? solid_with(n) : plane_with(n);
        if (shape != Shape::unknown && std::isdigit(name[start.size()]))
          return {shape, n};
      }
    return {};
  }



  MeshFile::Nodes
  reordered(const AbaqusType &type, Nodes nodes)
  {
    // Abaqus lists the centre of C3D27 before the centres of the faces, and these in the order S1
    // to S6.
    if (type.shape == Shape::hexahedron && type.n_nodes == 27)
      {
        static const std::array<unsigned int, 7> place{{26, 24, 25, 22, 21, 23, 20}};
        const Nodes                              old = nodes;
        for (unsigned int i = 0; i < place.size(); ++i)
          nodes[place[i]] = old[20 + i];
      }
    return nodes;
  }



  namespace
  {
    using Faces = std::vector<std::pair<std::string, Nodes>>;

    /// @return corners of all faces of a shape with their labels, as in Abaqus.
    const Faces &
    labelled_faces(const Shape shape)
    {
      static const std::map<Shape, Faces> faces = {
        {Shape::tetrahedron,
         {{"S1", {0, 1, 2}}, {"S2", {0, 3, 1}}, {"S3", {1, 3, 2}}, {"S4", {2, 3, 0}}}},
        {Shape::pyramid,
         {{"S1", {0, 1, 2, 3}},
          {"S2", {0, 4, 1}},
          {"S3", {1, 4, 2}},
          {"S4", {2, 4, 3}},
          {"S5", {3, 4, 0}}}},
        {Shape::wedge,
         {{"S1", {0, 1, 2}},
          {"S2", {3, 5, 4}},
          {"S3", {0, 3, 4, 1}},
          {"S4", {1, 4, 5, 2}},
          {"S5", {2, 5, 3, 0}}}},
        {Shape::hexahedron,
         {{"S1", {0, 1, 2, 3}},
          {"S2", {4, 7, 6, 5}},
          {"S3", {0, 4, 5, 1}},
          {"S4", {1, 5, 6, 2}},
          {"S5", {2, 6, 7, 3}},
          {"S6", {3, 7, 4, 0}}}},
        {Shape::triangle,
         {{"S1", {0, 1}},
          {"S2", {1, 2}},
          {"S3", {2, 0}},
          {"SPOS", {0, 1, 2}},
          {"SNEG", {0, 2, 1}}}},
        {Shape::quadrilateral,
         {{"S1", {0, 1}},
          {"S2", {1, 2}},
          {"S3", {2, 3}},
          {"S4", {3, 0}},
          {"SPOS", {0, 1, 2, 3}},
          {"SNEG", {0, 3, 2, 1}}}}};
      static const Faces none;
      const auto         found = faces.find(shape);
      return found == faces.end() ? none : found->second;
    }
  } // namespace



  // Labels E1 to E4 of plane cells are synonyms of S1 to S4.
  std::vector<MeshFile::Nodes>
  abaqus_faces(const MeshFile::Element &element, const std::string &label)
  {
    std::string wanted = label;
    if (wanted.size() == 2 && wanted[0] == 'E')
      wanted[0] = 'S';
    std::vector<Nodes> faces;
    for (const auto &[name, corners] : labelled_faces(element.shape))
      if (wanted.empty() || name == wanted)
        {
          // Faces of collapsed elements have repeated corners, or are no faces any more.
          Nodes face;
          for (const unsigned int corner : corners)
            if (std::count(face.begin(), face.end(), element.nodes[corner]) == 0)
              face.push_back(element.nodes[corner]);
          if (face.size() >= dimension_of(element.shape))
            faces.push_back(face);
        }
    return faces;
  }
} // namespace Signorini
