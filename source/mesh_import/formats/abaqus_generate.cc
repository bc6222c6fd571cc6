// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/formats/abaqus_reader.h"
#include <signorini/parameters/raw.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// @return a word of a data line, or another text if it is missing or empty.
    std::string
    word(const std::vector<std::string> &words, const unsigned int i, const std::string &otherwise)
    {
      return i < words.size() && !words[i].empty() ? words[i] : otherwise;
    }
  } // namespace



  /// *SYSTEM: the nodes that follow are given in this system; without a data line, in the global
  /// one. One point is a translation; two or three define a rotated system.
  void
  AbaqusReader::read_system()
  {
    std::vector<double> values;
    for (Words words; in.next_line(words);)
      for (const std::string &one : words)
        values.push_back(real_from(in, one));
    system.reset();
    if (values.empty())
      return;
    const unsigned int given = values.size();
    values.resize(9, 0.);
    const Point<3> a(values[0], values[1], values[2]), b(values[3], values[4], values[5]);
    Point<3>       c(values[6], values[7], values[8]);
    if (given <= 3)
      system = std::make_unique<RigidMotion>(RigidMotion::translation(a));
    else
      {
        // Without a third point the system is rotated about z.
        if (given <= 6)
          c = Point<3>(a[0] - (b[1] - a[1]), a[1] + (b[0] - a[0]), a[2]);
        if (cross_product_3d(b - a, c - a).norm() <= 1e-12 * (b - a).norm() * (c - a).norm())
          in.fail("*SYSTEM: the three points lie on a line");
        system = std::make_unique<RigidMotion>(RigidMotion::of_system(a, b, c));
      }
  }



  // The position of a node that has been defined above, by its number.
  const Point<3> &
  AbaqusReader::place_of(const std::string &number) const
  {
    const unsigned int node = scope->nodes.index(number_from(in, number));
    if (node == AbaqusSets::none)
      in.fail("there is no node " + number + " above");
    return scope->mesh->nodes[node];
  }



  // The number of a node of this scope by its index. Nodes of instances have none.
  std::size_t
  AbaqusReader::node_number(const unsigned int index) const
  {
    const auto found = scope->number_of.find(index);
    if (found == scope->number_of.end())
      in.fail(
        "*" + in.keyword() +
        " of nodes of an instance is not read here; make them in the part, or write them out");
    return found->second;
  }



  /// *NGEN: nodes in equal steps on the line from the first to the last node. Data lines: first,
  /// last, increment of the numbers.
  void
  AbaqusReader::generate_nodes()
  {
    if (in.has("LINE") && upper_case(in.value("LINE")) != "L")
      in.fail("*NGEN on arcs and parabolas is not read here; write out the nodes");
    AbaqusSet *const set = set_of("NSET", scope->nodes);
    for (Words words; in.next_line(words);)
      {
        const std::size_t first = number_from(in, words[0]),
                          last  = number_from(in, word(words, 1, "")),
                          step  = number_from(in, word(words, 2, "1"));
        const Point<3> a = place_of(words[0]), b = place_of(words[1]);
        if (step == 0 || last <= first || (last - first) % step != 0)
          in.fail("*NGEN: the increment does not lead from the first to the last node");
        const std::size_t n = (last - first) / step;
        check_amount(in, n);
        for (std::size_t i = 0; i <= n; ++i)
          add_node(first + i * step, a + (b - a) * (double(i) / n), set);
      }
  }



  /// *NFILL: rows of nodes between the nodes of two sets, one row for each pair. Data lines: first
  /// set, second set, number of intervals, increment of the numbers. With BIAS each interval is
  /// that many times as long as the next one.
  void
  AbaqusReader::fill_nodes()
  {
    if (in.has("SINGULAR") || in.has("TWO STEP"))
      in.fail("*NFILL, SINGULAR and TWO STEP are not read here; write out the nodes");
    const double     bias = in.has("BIAS") ? real_from(in, in.value("BIAS")) : 1;
    AbaqusSet *const set  = set_of("NSET", scope->nodes);
    if (!(bias > 0))
      in.fail("*NFILL: BIAS must be positive");
    for (Words words; in.next_line(words);)
      {
        Members from, to;
        scope->nodes.append(in, words[0], from);
        scope->nodes.append(in, word(words, 1, ""), to);
        const std::size_t n    = number_from(in, word(words, 2, "1")),
                          step = number_from(in, word(words, 3, "1"));
        if (from.size() != to.size() || n == 0)
          in.fail("*NFILL: the two sets do not have the same number of nodes");
        check_amount(in, double(n) * std::max<std::size_t>(from.size(), 1));
        for (unsigned int k = 0; k < from.size(); ++k)
          {
            // Interval lengths are bias^(-i), normalised to the distance of the two nodes.
            const std::size_t first = node_number(from[k]);
            const Point<3>    a = scope->mesh->nodes[from[k]], b = scope->mesh->nodes[to[k]];
            double            place = 0, whole_length = 0;
            for (std::size_t i = 0; i < n; ++i)
              whole_length += std::pow(bias, -double(i));
            for (std::size_t i = 0; i < n; ++i)
              {
                add_node(first + i * step, a + (b - a) * (place / whole_length), set);
                place += std::pow(bias, -double(i));
              }
            if (set)
              set->members.push_back(to[k]);
          }
      }
  }



  // *NCOPY, SHIFT: copies of a set, moved by the motion of the data lines once, twice, ...
  // (MULTIPLE). Each copy adds CHANGE NUMBER to the numbers.
  void
  AbaqusReader::copy_nodes()
  {
    if (!in.has("SHIFT"))
      in.fail("*NCOPY is read with SHIFT only; write out the nodes");
    const std::size_t change = number_from(in, in.value("CHANGE NUMBER"));
    AbaqusSet *const  set    = set_of("NEW SET", scope->nodes);
    Members           old;
    scope->nodes.append(in, in.value("OLD SET"), old);
    const std::size_t times = in.has("MULTIPLE") ? number_from(in, in.value("MULTIPLE")) : 1;
    check_amount(in, double(times) * std::max<std::size_t>(old.size(), 1));
    const RigidMotion once = read_motion();
    RigidMotion       motion;
    for (std::size_t i = 1; i <= times; ++i)
      {
        motion = motion.then(once);
        for (const unsigned int node : old)
          add_node(node_number(node) + i * change, motion(scope->mesh->nodes[node]), set);
      }
  }



  void
  AbaqusReader::copy_element(const unsigned int     like,
                             const std::size_t      number,
                             const MeshFile::Nodes &nodes)
  {
    MeshFile::Element copy = scope->mesh->elements[like];
    copy.nodes             = nodes;
    copy.number            = number;
    if (!scope->elements.insert(number, scope->mesh->elements.size()))
      in.fail("element " + std::to_string(number) + " is there twice");
    scope->mesh->elements.push_back(copy);
  }



  /// *ELGEN: copies of an element in rows, planes of rows and layers of planes. The data line has,
  /// after the number of the element, for each of the three directions the number of elements and
  /// the increments of the numbers of nodes and of elements.
  void
  AbaqusReader::generate_elements()
  {
    AbaqusSet *const set = set_of("ELSET", scope->elements);
    for (Words words; in.next_line(words);)
      {
        const unsigned int master = scope->elements.index(number_from(in, words[0]));
        if (master == AbaqusSets::none)
          in.fail("there is no element " + words[0] + " above");
        // Counts and increments of the three directions; missing ones are one.
        std::size_t n[3], of_nodes[3], of_elements[3];
        for (unsigned int d = 0; d < 3; ++d)
          {
            n[d]           = number_from(in, word(words, 1 + 3 * d, "1"));
            of_nodes[d]    = number_from(in, word(words, 2 + 3 * d, "1"));
            of_elements[d] = number_from(in, word(words, 3 + 3 * d, "1"));
          }
        check_amount(in, double(n[0]) * n[1] * n[2]);
        // The nodes of each copy are found by their numbers, which must exist.
        std::vector<std::size_t> numbers;
        for (const unsigned int node : scope->mesh->elements[master].nodes)
          numbers.push_back(node_number(node));
        for (std::size_t k = 0; k < n[2]; ++k)
          for (std::size_t j = 0; j < n[1]; ++j)
            for (std::size_t i = 0; i < n[0]; ++i)
              {
                const std::size_t number = scope->mesh->elements[master].number +
                                           i * of_elements[0] + j * of_elements[1] +
                                           k * of_elements[2];
                MeshFile::Nodes nodes;
                for (const std::size_t node : numbers)
                  nodes.push_back(
                    scope->nodes.index(node + i * of_nodes[0] + j * of_nodes[1] + k * of_nodes[2]));
                if (std::count(nodes.begin(), nodes.end(), AbaqusSets::none) > 0)
                  in.fail("element " + std::to_string(number) + " of *ELGEN has an unknown node");
                if (i + j + k > 0)
                  copy_element(master, number, nodes);
                if (set)
                  set->members.push_back(scope->elements.index(number));
              }
      }
  }



  // *ELCOPY: copies of a set of elements with shifted numbers of elements and nodes.
  void
  AbaqusReader::copy_elements()
  {
    if (in.has("REFLECT"))
      in.fail("*ELCOPY, REFLECT is not read here; write out the elements");
    const std::size_t of_elements = number_from(in, in.value("ELEMENT SHIFT")),
                      of_nodes    = number_from(in, in.value("SHIFT NODES"));
    AbaqusSet *const set          = set_of("NEW SET", scope->elements);
    Members          old;
    scope->elements.append(in, in.value("OLD SET"), old);
    for (const unsigned int e : old)
      {
        MeshFile::Nodes   nodes;
        const std::size_t number = scope->mesh->elements[e].number + of_elements;
        for (const unsigned int node : scope->mesh->elements[e].nodes)
          nodes.push_back(scope->nodes.index(node_number(node) + of_nodes));
        if (std::count(nodes.begin(), nodes.end(), AbaqusSets::none) > 0)
          in.fail("element " + std::to_string(number) + " of *ELCOPY has an unknown node");
        copy_element(e, number, nodes);
        if (set)
          set->members.push_back(scope->elements.index(number));
      }
  }
} // namespace Signorini
