// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstring>
#include <map>

#include "mesh_helpers.h"

using namespace dealii;
using namespace Signorini;
using namespace MeshTests;

namespace
{
  /// Number of faces of each boundary; a face counts for all its names.
  template <int dim>
  std::map<std::string, unsigned int>
  faces_of(const CoarseMesh<dim> &mesh)
  {
    Triangulation<dim> triangulation;
    create(triangulation, mesh);
    std::map<std::string, unsigned int> count;
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary())
        for (unsigned int name = 0; name < mesh.boundaries.size(); ++name)
          count[mesh.boundaries[name]] += mesh.ids_of(name).count(face->boundary_id());
    return count;
  }



  using Count = std::map<std::string, unsigned int>;

  template <int dim>
  CoarseMesh<dim>
  mesh_of(const TemporaryFile &file, Keys keys = {})
  {
    keys.push_back({"File", file.path});
    return generator<dim>("file", keys)->generate();
  }



  /// Volume on the coarse mesh, and after each of two refinements.
  template <int dim>
  void
  check_volume(const CoarseMesh<dim> &mesh, const double exact, const double tolerance = 1e-13)
  {
    Triangulation<dim> triangulation;
    create(triangulation, mesh);
    for (unsigned int level = 0; level < 3; ++level, triangulation.refine_global())
      CHECK(std::abs(volume(triangulation) - exact) < tolerance);
  }



  /// Two squares side by side: nodes 1 to 6 from below, elements 10 and 11.
  const std::string squares = "*Heading\n two squares, *NODE is no keyword here\n"
                              "*NODE, NSET=all\n1, 0, 0\n2, 1., 0., 0.\n3, 2D0, 0.\n"
                              "** a comment\n4, 0., 1.\n5, 1., 1.\n6, 2.0e+00, 1.\n";
  const std::string cells   = "*ELEMENT, TYPE=CPS4R, ELSET=\"left half\"\n10, 1, 2,\n5, 4\n"
                              "*Element,\n type = cpe4, elset=RIGHT\n11, 2, 3, 6, 5\n";
} // namespace



TEST_CASE("Abaqus: sets, surfaces and all that a line may look like")
{
  const TemporaryFile file(squares + cells +
                             "*NSET, NSET=base, GENERATE\n1, 3\n"
                             "*ELSET, ELSET=both\nleft half, 11\n"
                             "*SURFACE, NAME=roof\nboth, S3\n"
                             "*SURFACE, NAME=sides, TYPE=ELEMENT\n10, S4\nright, E2\n"
                             "*MATERIAL, NAME=steel\n*ELASTIC\n2e5, 0.3\n*STEP\n*END STEP\n",
                           ".inp");
  CHECK(faces_of(mesh_of<2>(file)) == Count{{"roof", 2}, {"sides", 2}, {"base", 2}});
  CHECK(faces_of(mesh_of<2>(file, {{"Part", "left half"}})) ==
        Count{{"roof", 1}, {"sides", 1}, {"base", 1}, {"unnamed", 1}});
  CHECK(mesh_of<2>(file, {{"Part", "RIGHT"}}).vertices.size() == 4);
  CHECK(mesh_of<2>(file, {{"Part", "both"}}).vertices.size() == 6);
}



TEST_CASE("Abaqus: a surface without labels is the rim, one of nodes needs all of a face")
{
  const std::string text =
    squares + cells +
    "*SURFACE, NAME=rim\nleft half,\nRIGHT,\n"
    "*NSET, NSET=corner\n6\n*NSET, NSET=end, ELSET=RIGHT\n"
    "*NSET, NSET=three\n3, corner\n*SURFACE, NAME=tip, TYPE=NODE\nthree, 1.\n";
  const TemporaryFile file(text, ".inp");
  CHECK(faces_of(mesh_of<2>(file)) == Count{{"rim", 6}, {"tip", 1}, {"three", 1}, {"end", 3}});
  CHECK(faces_of(mesh_of<2>(file, {{"Boundaries", "tip, rim"}})) == Count{{"tip", 1}, {"rim", 5}});
  CHECK(faces_of(mesh_of<2>(file, {{"Boundaries", "end, rim"}})) == Count{{"end", 3}, {"rim", 3}});
}



TEST_CASE("Abaqus: springs, masses and shells beside the cells do no harm")
{
  const TemporaryFile file(squares + cells +
                             "*ELEMENT, TYPE=SPRING1, ELSET=ground\n20, 3\n"
                             "*ELEMENT, TYPE=SPRINGA\n21, 1, 6\n*ELEMENT, TYPE=MASS\n22, 5\n"
                             "*ELEMENT, TYPE=T2D2, ELSET=skin\n23, 3, 6\n",
                           ".inp");
  CHECK(faces_of(mesh_of<2>(file)) == Count{{"skin", 1}, {"unnamed", 5}});
}



TEST_CASE("Abaqus: an included file")
{
  const TemporaryFile nodes(squares, ".nodes");
  const TemporaryFile file("*INCLUDE, INPUT=" +
                             std::filesystem::path(nodes.path).filename().string() + "\n" + cells,
                           ".inp");
  CHECK(mesh_of<2>(file).cells.size() == 2);
}



TEST_CASE("Abaqus: what cannot be read is named with its line")
{
  const auto attempt = [](const std::string &text) {
    const TemporaryFile file(text, ".inp");
    const std::string   message = message_of([&] { mesh_of<2>(file); });
    says(message, file.path);
    return message;
  };
  says(attempt(squares), "no elements");
  says(attempt(squares + "*ELEMENT, TYPE=CPS4\n1, 1, 2, 5, 7\n"), "unknown node 7");
  says(attempt(squares + "*ELEMENT, TYPE=CPS4\n1, 1, 2, 5\n"), "line 12: element 1 of type CPS4");
  says(attempt(squares + "*ELEMENT, TYPE=CPS4\n1, 1, 2, 5, 4, 3\n"), "does not have its 4 nodes");
  says(attempt(squares + "*ELEMENT\n1, 1, 2, 5, 4\n"), "TYPE=");
  says(attempt(squares + cells + "*ELEMENT, TYPE=CPS4\n11, 1, 2, 5, 4\n"),
       "element 11 is there twice");
  says(attempt(squares + cells + "*NMAP\n1, 3, 1\n"), "*NMAP is not read here");
  says(attempt(squares + "*NODE, SYSTEM=X\n7, 1., 90.\n"), "SYSTEM=X: R, C and S");
  says(attempt(squares + "*NODE\n7, one, 2.\n"), "'one' should be a number");
  for (const std::string word : {"nan", "inf", "0x1p4", "1e999"})
    says(attempt(squares + "*NODE\n7, " + word + ", 2.\n"), "'" + word + "' should be a number");
  says(attempt(squares + "*ELEMENT, TYPE=XYZ4\n1, 1, 2, 5, 4\n"),
       "not known here: XYZ4, the first is number 1");
  says(attempt("*INCLUDE, INPUT=absent.inp\n"), "absent.inp' cannot be opened");
}



TEST_CASE("a cell that is there twice is refused")
{
  const TemporaryFile file(squares + cells + "*ELEMENT, TYPE=CPS4\n12, 1, 2, 5, 4\n", ".inp");
  says(message_of([&] { mesh_of<2>(file); }),
       "has element 10 (CPS4R) twice, also as element 12 (CPS4), at (0 0)");
  // Without neighbours, all faces have two cells.
  const TemporaryFile alone(squares + "*ELEMENT, TYPE=CPS4\n7, 1, 2, 5, 4\n8, 2, 5, 4, 1\n",
                            ".inp");
  says(message_of([&] { mesh_of<2>(alone); }), "has element 7 (CPS4) twice, also as element 8");
}



TEST_CASE("cells whose nodes are listed the other way round are turned")
{
  const TemporaryFile plane(squares + "*ELEMENT, TYPE=CPS4\n1, 1, 4, 5, 2\n2, 2, 3, 6, 5\n",
                            ".inp");
  check_volume(mesh_of<2>(plane), 2);

  std::string cube = "*NODE\n";
  for (unsigned int i = 0; i < 8; ++i)
    cube += std::to_string(i + 1) + (i % 4 == 1 || i % 4 == 2 ? ", 1" : ", 0") +
            (i % 4 > 1 ? ", 1" : ", 0") + (i > 3 ? ", 1\n" : ", 0\n");
  const TemporaryFile solid(cube + "*ELEMENT, TYPE=C3D8I\n1, 5, 6, 7, 8, 1, 2, 3, 4\n", ".inp");
  check_volume(mesh_of<3>(solid), 1);
}



TEST_CASE("coinciding nodes of cells that are not connected otherwise are kept apart or merged")
{
  const TemporaryFile file("*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 1.0000001, 0\n6, 2, 0\n"
                           "7, 2, 1\n8, 1, 1\n*ELEMENT, TYPE=CPS4\n1, 1, 2, 3, 4\n2, 5, 6, 7, 8\n"
                           "*NSET, NSET=base\n1, 2, 5, 6\n*NSET, NSET=crack\n2, 3\n",
                           ".inp");
  const auto          with = [&](const std::string &word, const std::string &distance = "0") {
    return mesh_of<2>(file, {{"Coinciding nodes", word}, {"Node distance", distance}});
  };
  const auto reason = [&](const std::string &distance) {
    return generator<2>("file", {{"File", file.path}, {"Node distance", distance}})->needs_pair();
  };
  CHECK(with("error").vertices.size() == 8);
  says(reason("0"), "2 pairs, the first at (1 0)");
  CHECK(with("merge").vertices.size() == 6);
  CHECK(faces_of(with("merge")) == Count{{"base", 2}, {"unnamed", 4}});
  CHECK(with("keep").vertices.size() == 8);
  CHECK(faces_of(with("keep")) == Count{{"base", 2}, {"crack", 1}, {"unnamed", 5}});
  CHECK(with("merge", "1e-8").vertices.size() == 7);
  says(reason("1e-8"), "1 pair at (1 1)");
}



TEST_CASE("coinciding nodes of cells that are connected elsewhere are a crack, and refused")
{
  // Two squares with a common node 2; 3 and 8 lie at the same place.
  const TemporaryFile file("*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n6, 2, 0\n7, 2, 1\n"
                           "8, 1, 1\n*ELEMENT, TYPE=CPS4\n1, 1, 2, 3, 4\n2, 2, 6, 7, 8\n",
                           ".inp");
  const std::string   message = message_of([&] { mesh_of<2>(file); });
  says(message, "connected elsewhere are not: 1 pair at (1 1)");
  CHECK(mesh_of<2>(file, {{"Coinciding nodes", "keep"}}).vertices.size() == 7);
  CHECK(mesh_of<2>(file, {{"Coinciding nodes", "merge"}}).vertices.size() == 6);
}



TEST_CASE("notes: nodes that no element uses, and where unnamed boundaries are")
{
  const TemporaryFile file(squares + "*NODE\n20, 5, 5\n21, 6, 5\n" + cells, ".inp");
  FileSelection       selection;
  selection.feature_angle = 30;
  const FilePart<2> part(read_mesh_file(file.path), selection);
  REQUIRE(part.notes.size() == 5);
  says(part.notes[0], "2 nodes without elements are ignored, the first is at (5 5 0)");
  says(part.notes[2], "boundary unnamed2: 2 faces about (1 0)");
  CHECK(part.vertices.size() == 6);
}



TEST_CASE("faces without a name are divided by the feature angle")
{
  const Keys ball{{"File", stored_mesh("ball-second-order.msh")}};
  const auto with = [](Keys keys, const std::string &angle) {
    keys.push_back({"Feature angle", angle});
    return generator<3>("file", keys)->generate();
  };
  // Nothing is unnamed there.
  CHECK(with(ball, "40").boundaries == generator<3>("file", ball)->boundaries());

  const Keys lower{{"File", stored_mesh("blocks.vtu")}, {"Part", "body 1"}};
  CHECK(faces_of(with(lower, "0")) == Count{{"unnamed", 52}});
  CHECK(faces_of(with(lower, "100")) == Count{{"unnamed1", 52}});
  CHECK(faces_of(with(lower, "89")) == Count{{"unnamed1", 6},
                                             {"unnamed2", 8},
                                             {"unnamed3", 12},
                                             {"unnamed4", 12},
                                             {"unnamed5", 8},
                                             {"unnamed6", 6}});

  // A hexagon of three squares' edges: kinks of 26.565 degrees at (1,0) and (1,1.5).
  const TemporaryFile roof("*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, 1.5\n6, 2, 1\n"
                           "*ELEMENT, TYPE=CPS4\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n",
                           ".inp");
  CHECK(mesh_of<2>(roof, {{"Feature angle", "50"}}).boundaries.size() == 5);
  CHECK(mesh_of<2>(roof, {{"Feature angle", "55"}}).boundaries.size() == 4);
}



TEST_CASE("VTK: text and binary, old and new lists of cells")
{
  const std::string head = "# vtk DataFile Version 3.0\na title\n";
  const std::string data =
    "CELL_DATA 3\nSCALARS part int 1\nLOOKUP_TABLE default\n1 2 7\n"
    "VECTORS v double\n1 2 3 4 5 6 7 8 9\nSCALARS t double\nLOOKUP_TABLE default\n.5 1 2\n";
  const std::string points =
    "DATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n0 0 0 1 0 0 2 0 0\n0 1 0 1 1 0 2 1 0\n";
  const std::string types = "CELL_TYPES 3\n9 8 3\n";
  const Count       expected{{"part 7", 1}, {"unnamed", 5}};

  const TemporaryFile old(head + "ASCII\n" + points + "CELLS 3 13\n4 0 1 4 3 4 1 2 4 5 2 5 2\n" +
                            types + data,
                          ".vtk");
  CHECK(faces_of(mesh_of<2>(old)) == expected);
  CHECK(mesh_of<2>(old, {{"Part", "part 2"}}).cells.size() == 1);

  const TemporaryFile fresh(
    "# vtk DataFile Version 5.1\na title\nASCII\n" + points +
      "METADATA\nINFORMATION 0\n\nCELLS 4 10\nOFFSETS vtktypeint64\n0 4 8 10\n"
      "CONNECTIVITY vtktypeint64\n0 1 4 3 1 2 4 5 5 2\n" +
      types + "CELL_DATA 3\nFIELD FieldData 1\npart 1 3 int\n1 2 7\n",
    ".vtk");
  CHECK(faces_of(mesh_of<2>(fresh)) == expected);

  const auto bytes = [](const auto &values) {
    std::string result;
    for (const auto value : values)
      {
        char one[sizeof(value)];
        std::memcpy(one, &value, sizeof(value));
        for (unsigned int i = sizeof(value); i-- > 0;)
          result += one[i];
      }
    return result + "\n";
  };
  const TemporaryFile binary(
    head + "BINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n" +
      bytes(std::vector<float>{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}) +
      "CELLS 3 13\n" + bytes(std::vector<std::int32_t>{4, 0, 1, 4, 3, 4, 1, 2, 4, 5, 2, 5, 2}) +
      "CELL_TYPES 3\n" + bytes(std::vector<std::int32_t>{9, 8, 3}) +
      "CELL_DATA 3\nSCALARS part short\nLOOKUP_TABLE default\n" +
      bytes(std::vector<std::int16_t>{1, 2, 7}),
    ".vtk");
  CHECK(faces_of(mesh_of<2>(binary)) == expected);

  const auto attempt = [](const std::string &text) {
    const TemporaryFile file(text, ".vtk");
    return message_of([&] { mesh_of<2>(file); });
  };
  says(attempt("solid"), "is not a legacy file of VTK");
  says(attempt(head + "ASCII\nDATASET POLYDATA\n"), "no unstructured grid");
  says(attempt(head + "ASCII\n" + points + "CELLS 1 5\n4 0 1 4 6\nCELL_TYPES 1\n9\n"),
       "unknown point 6");
  says(attempt(head + "ASCII\n" + points + "CELLS 1 5\n4 0 1 4\nCELL_TYPES 1\n9\n"), "CELLS");
}



namespace
{
  /// @param arrays points, connectivity, offsets, types and the array `part`
  std::string
  vtu(const std::string              &attributes,
      const std::string              &format,
      const std::vector<std::string> &arrays)
  {
    const auto array = [&](const std::string &type, const std::string &name, const unsigned int i) {
      return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"" + format + "\">\n" +
             arrays[i] + "\n</DataArray>";
    };
    return "<?xml version=\"1.0\"?>\n<!-- a comment -->\n<VTKFile type=\"UnstructuredGrid\" " +
           attributes +
           " byte_order=\"LittleEndian\"><UnstructuredGrid><Piece NumberOfPoints=\"6\" "
           "NumberOfCells=\"3\"><PointData/><Points>" +
           array("Float64", "Points", 0) + "</Points><Cells>" + array("Int64", "connectivity", 1) +
           array("Int64", "offsets", 2) + array("UInt8", "types", 3) + "</Cells><CellData>" +
           array("Int32", "part", 4) + "</CellData></Piece></UnstructuredGrid></VTKFile>";
  }
} // namespace



TEST_CASE("VTU: text, base64, and compressed by zlib in blocks of 32 bytes")
{
  const Count                    expected{{"part 7", 1}, {"unnamed", 5}};
  const std::vector<std::string> words{
    "0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0", "0 1 4 3 1 2 5 4 5 2", "4 8 10", "9 9 3", "1 2 7"};
  const TemporaryFile text(vtu("", "ascii", words), ".vtu");
  CHECK(faces_of(mesh_of<2>(text)) == expected);
  const std::vector<std::string> plain_arrays{
    "kAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAABA"
    "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA8D8AAAAAAAAAAAAAAAAAAPA/AAAAAAAA8D8AAAAA"
    "AAAAAAAAAAAAAABAAAAAAAAA8D8AAAAAAAAAAA==",
    "UAAAAAAAAAAAAAAAAQAAAAAAAAAEAAAAAAAAAAMAAAAAAAAAAQAAAAAAAAACAAAAAAAAAAUAAAAAAAAA"
    "BAAAAAAAAAAFAAAAAAAAAAIAAAAAAAAA",
    "GAAAAAQAAAAAAAAACAAAAAAAAAAKAAAAAAAAAA==",
    "AwAAAAkJAw==",
    "DAAAAAEAAAACAAAABwAAAA=="};
  const TemporaryFile plain(vtu("header_type=\"UInt32\"", "binary", plain_arrays), ".vtu");
  CHECK(faces_of(mesh_of<2>(plain)) == expected);
  check_volume(mesh_of<2>(plain), 2);
  const TemporaryFile packed(
    vtu("header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"",
        "binary",
        {"BQAAAAAAAAAgAAAAAAAAABAAAAAAAAAADgAAAAAAAAAOAAAAAAAAAA8AAAAAAAAAEwAAAAAAAAAQAAAA"
         "AAAAAA==eJxjYMAHPtgDAAI/ATB4nGNgwAocYAwAAmAAQXicY2DABj7Yw1gAC7cBMHicY2AAgQ/2DCg0"
         "HDgAADP2Ap94nGNgAIEP9gxQAAALpwEw",
         "AwAAAAAAAAAgAAAAAAAAABAAAAAAAAAAEwAAAAAAAAATAAAAAAAAAA4AAAAAAAAAeJxjYIAARijNAqWZ"
         "oTQAAJAACXicY2SAACYozQqlWaA0AADgAA14nGNlgAAmKA0AAHAACA==",
         "AQAAAAAAAAAgAAAAAAAAABgAAAAAAAAAEAAAAAAAAAA=eJxjYYAADijNBaUBAUgAFw==",
         "AQAAAAAAAAAgAAAAAAAAAAMAAAAAAAAACwAAAAAAAAA=eJzj5GQGAAAzABY=",
         "AQAAAAAAAAAgAAAAAAAAAAwAAAAAAAAAEQAAAAAAAAA=eJxjZGBgYAJidiAGAABEAAs="}),
    ".vtu");
  CHECK(faces_of(mesh_of<2>(packed)) == expected);
  check_volume(mesh_of<2>(packed), 2);

  const auto attempt = [](const std::string &text) {
    const TemporaryFile file(text, ".vtu");
    return message_of([&] { mesh_of<2>(file); });
  };
  // Raw data behind the arrays, as they are within them.
  std::string              all;
  std::vector<std::string> nothing(5);
  std::string              raw = vtu("header_type=\"UInt32\"", "appended", nothing);
  for (const std::string &array : plain_arrays)
    {
      const auto bytes = Utilities::decode_base64(array);
      const auto at    = raw.find("\"appended\">");
      raw.replace(at, 11, "\"appended\" offset=\"" + std::to_string(all.size()) + "\">");
      all.append(bytes.begin(), bytes.end());
    }
  raw.replace(raw.find("</VTKFile>"),
              10,
              "<AppendedData encoding=\"raw\">\n  _" + all + "</AppendedData></VTKFile>");
  const TemporaryFile behind(raw, ".vtu");
  CHECK(faces_of(mesh_of<2>(behind)) == expected);
  check_volume(mesh_of<2>(behind), 2);

  says(attempt("solid"), "no XML file");
  says(attempt("<VTKFile type=\"PolyData\"/>"), "no unstructured grid");
  std::string deep;
  for (unsigned int i = 0; i < 100000; ++i)
    deep += "<a>";
  says(attempt(deep), "more than 1000 deep");
  says(attempt(vtu("", "appended", words)), "appended");
  says(attempt(vtu("compressor=\"vtkLZ4DataCompressor\"", "binary", words)),
       "vtkLZ4DataCompressor");
}



TEST_CASE("second order: the area and volume are those of the quadratic map, on all refinements")
{
  const std::string square =
    "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, .5, 0\n6, 1, .5\n"
    "7, .5, 1.1\n8, 0, .5\n*ELEMENT, TYPE=CPE8R\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
  const TemporaryFile plane(square, ".inp");
  check_volume(mesh_of<2>(plane), 1 + 2. / 3 * 0.1);
  check_volume(mesh_of<2>(plane, {{"Mid-side nodes", "no"}}), 1);
  CHECK(mesh_of<2>(plane, {{"Mid-side nodes", "no"}}).manifolds.empty());

  // The middles of the upper edges are raised; each serendipity function there has the mean 1/3.
  std::string cube =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n"
    "7, 1, 1, 1\n8, 0, 1, 1\n9, .5, 0, 0\n10, 1, .5, 0\n11, .5, 1, 0\n12, 0, .5, 0\n"
    "13, .5, 0, 1.1\n14, 1, .5, 1.1\n15, .5, 1, 1.1\n16, 0, .5, 1.1\n17, 0, 0, .5\n"
    "18, 1, 0, .5\n19, 1, 1, .5\n20, 0, 1, .5\n";
  const TemporaryFile serendipity(cube +
                                    "*ELEMENT, TYPE=C3D20R\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,\n"
                                    "11, 12, 13, 14, 15, 16, 17, 18, 19, 20\n",
                                  ".inp");
  check_volume(mesh_of<3>(serendipity), 1 + 4. / 3 * 0.1);

  // The center of the upper face raised as well, whose function has the mean 4/9; those of the
  // edges then 1/9.
  cube +=
    "21, .5, .5, .55\n22, .5, .5, 0\n23, .5, .5, 1.1\n24, .5, 0, .5\n25, 1, .5, .5\n26, .5, 1, .5\n"
    "27, 0, .5, .5\n";
  const TemporaryFile full(cube +
                             "*ELEMENT, TYPE=C3D27\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,\n"
                             "11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27\n",
                           ".inp");
  check_volume(mesh_of<3>(full), 1 + (4. / 9 + 4. / 9) * 0.1);
}



TEST_CASE("second order: a ball of Gmsh with 20 nodes a cell")
{
  const auto mesh =
    generator<3>("file", {{"File", stored_mesh("ball-second-order.msh")}})->generate();
  Triangulation<3> triangulation;
  create(triangulation, mesh);
  const double coarse = volume(triangulation);
  CHECK(std::abs(coarse / (numbers::PI / 6) - 1) < 2e-3);
  triangulation.refine_global(2);
  CHECK(std::abs(volume(triangulation) / coarse - 1) < 1e-12);
  double worst = 0;
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && mesh.boundaries[face->boundary_id()] == "contact")
      for (const unsigned int v : face->vertex_indices())
        worst = std::max(worst, std::abs(face->vertex(v).distance(Point<3>(0, 0, 1)) - 1));
  CHECK(worst < 5e-3);
}



TEST_CASE("Gmsh: groups without names are called by their numbers; meshes in the plane of x and z")
{
  // A rectangle of 2 (along x) by 3 (along z) in y = 5, with a boundary of two sides.
  const TemporaryFile file("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 5 0\n2 2 5 0\n"
                           "3 2 5 3\n4 0 5 3\n$EndNodes\n$Elements\n4\n1 3 2 7 1 1 2 3 4\n"
                           "2 1 2 11 1 1 2\n3 1 2 11 1 2 3\n4 1 2 0 2 3 4\n$EndElements\n");
  const MeshFile      mesh = read_mesh_file(file.path);
  CHECK(part_names(mesh, 2) == std::vector<std::string>{"7"});
  CHECK(part_names(mesh, 1) == std::vector<std::string>{"11"});
  const auto all = generator<2>("file", {{"File", file.path}, {"Part", "7"}});
  CHECK(all->boundaries() == std::vector<std::string>{"11", "unnamed"});
  CHECK(all->cell_set("7") == std::vector<unsigned int>{0});
  double x = 0, y = 0;
  for (const Point<2> &vertex : all->generate().vertices)
    {
      x = std::max(x, vertex[0]);
      y = std::max(y, vertex[1]);
    }
  CHECK(x == 2);
  CHECK(y == 3);
}
