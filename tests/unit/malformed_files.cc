// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/triangle_surface.h"
#include "mesh_import/mesh_file.h"
#include "parameters/values.h"
#include <signorini/parameters/raw.h>

#include <chrono>
#include <cstdlib>

#include "mesh_helpers.h"

using namespace dealii;
using namespace Signorini;
using namespace MeshTests;

// What mutants of files (tests/fuzz) have found once.

namespace
{
  /// The message of a mesh file that is refused, at once.
  std::string
  refusal(const std::string &text, const std::string &extension)
  {
    const TemporaryFile file(text, extension);
    const auto          begin   = std::chrono::steady_clock::now();
    const std::string   message = message_of([&] { read_mesh_file(file.path); });
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
    return message;
  }

  const std::string cube = "*NODE, NSET=A\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n"
                           "5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n"
                           "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
} // namespace

TEST_CASE("Gmsh: counts of what is not there")
{
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", many = "99999999999999";
  const std::string mesh = head + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
                                  "$Elements\n1\n1 3 2 1 1 1 2 3 4\n$EndElements\n";
  // The tag has no positive counterpart.
  CHECK(refusal(head + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n"
                       "1 15 1 -2147483648 1\n$EndElements\n",
                ".msh")
          .empty());
  says(refusal(head + "$Elements\n1\n1 3 4294967295\n$EndElements\n", ".msh"),
       "without its 4 nodes");
  says(refusal(mesh + "$NodeData\n1\n\"T\"\n" + many + "\n0\n", ".msh"),
       "without its three whole numbers");
  says(refusal(mesh + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n" + many + "\n4\n1 2\n", ".msh"),
       "in $NodeData");
  says(refusal(mesh + "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n0\n4\n1 2\n", ".msh"),
       "without its three whole numbers");
}

TEST_CASE("VTK: numbers of components and of points that cannot be")
{
  const std::string points = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                             "POINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\nCELLS 1 5\n4 0 1 2 ",
                    data   = "\nCELL_TYPES 1\n9\nPOINT_DATA 4\nSCALARS T float ";
  says(refusal(points + "3" + data + "many\nLOOKUP_TABLE default\n1 2 3 4\n", ".vtk"),
       "SCALARS T with 'many' components");
  says(refusal(points + "3" + data + std::string(30, '9') + "\nLOOKUP_TABLE default\n", ".vtk"),
       "components; there are 1 to 4");
  // Not point 3.
  says(refusal(points + "4294967299" + data, ".vtk"), "unknown point 4294967299");
}

TEST_CASE("VTU: arrays that are no base64, too short, or of an impossible size")
{
  const auto vtu = [](const std::string &attributes, const std::string &array) {
    return "<VTKFile type=\"UnstructuredGrid\" " + attributes +
           "><UnstructuredGrid><Piece><Points>"
           "<DataArray type=\"Float64\" format=\"binary\">" +
           array + "</DataArray></Points></Piece></UnstructuredGrid></VTKFile>";
  };
  const std::string packed = "header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"";
  says(refusal(vtu("", "!!!!"), ".vtu"), "not base64");
  says(refusal(vtu("", "AAA="), ".vtu"), "ends too early");
  says(refusal(vtu(packed, "////PwAAAAAAAAAA"), ".vtu"), "ends too early");
  // One block of 2 GiB in four bytes.
  says(refusal(vtu(packed, "AQAAAAAAAIAAAAAABAAAAA==eJwDAA=="), ".vtu"), "larger than it can be");
}

TEST_CASE("Abaqus: a few words that ask for more than there is")
{
  const std::string many = "99999999999999999", asks = "more than the memory of this machine";
  says(refusal(cube + "*NODE\n" + many + ", 2\n*NGEN\n1, " + many + "\n", ".inp"), asks);
  says(refusal(cube + "*NFILL\nA, A, " + many + "\n", ".inp"), asks);
  says(refusal(cube + "*NCOPY, CHANGE NUMBER=0, OLD SET=A, SHIFT, MULTIPLE=" + many + "\n0\n",
               ".inp"),
       asks);
  says(refusal(cube + "*ELGEN\n1, " + many + ", 0, 1\n", ".inp"), asks);

  // To name all that may be there is fine.
  const TemporaryFile file(cube +
                             "*NSET, NSET=all, GENERATE\n1, 18446744073709551615\n"
                             "*NSET, NSET=odd, GENERATE\n1, " +
                             many + ", 2\n*NSET, NSET=some, GENERATE\n2, 6, 2\n",
                           ".inp");
  const MeshFile      mesh  = read_mesh_file(file.path);
  const auto          nodes = [&](const std::string &name) {
    for (const auto &group : mesh.groups)
      if (group.name == name)
        return group.nodes;
    return MeshFile::Nodes();
  };
  CHECK(nodes("all") == MeshFile::Nodes{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(nodes("odd") == MeshFile::Nodes{0, 2, 4, 6});
  CHECK(nodes("some") == MeshFile::Nodes{1, 3, 5});
}

TEST_CASE("Abaqus: elements made of those of an instance")
{
  const std::string part = "*PART, NAME=P\n" + cube + "*END PART\n*INSTANCE, NAME=I, PART=P\n";
  says(refusal(part + "*ELGEN\n1, 2, 1, 1\n", ".inp"), "nodes of an instance");
}

TEST_CASE("directories in place of files")
{
  const std::string folder = std::filesystem::temp_directory_path().string();
  says(message_of([&] { read_stl(folder); }), "is a directory");
  says(refusal("*INCLUDE, INPUT=.\n", ".inp"), "is a directory");
  const TemporaryFile file("", ".vtu"); // gives a name
  std::filesystem::remove(file.path);
  std::filesystem::create_directory(file.path);
  says(message_of([&] { read_mesh_file(file.path); }), "is a directory");
}

TEST_CASE("settings in sections without end, numbers that are hardly any")
{
  RawSection root;
  says(message_of([&] { override_value(root, std::string(100000, '/') + "Key=1"); }), "deep");
  for (const double x : {1e-310, 5e-324, 1.7976931348623157e308, -1.7976931348623157e308})
    CHECK(std::strtod(to_text(x).c_str(), nullptr) == x);
}
