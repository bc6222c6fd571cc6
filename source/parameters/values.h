// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signorini/parameters/section.h>

#include <string>
#include <vector>

// The types of values of keys: how they are written, and what the user is told to write. They are
// read by from_text() of section.h. Each type has an overload of all three functions.

namespace Signorini
{
  /// @return the shortest text that yields the same number when it is read.
  /// @param x the number
  std::string
  number_text(double x);

  /// @return a value as it is written in a scene file.
  std::string
  to_text(double value);
  std::string
  to_text(unsigned int value);
  std::string
  to_text(bool value);
  std::string
  to_text(const std::string &value);
  std::string
  to_text(const Formula &value);
  template <typename T>
  std::string
  to_text(const std::vector<T> &values);
  template <int dim>
  std::string
  to_text(const dealii::Point<dim> &p);
  template <int dim>
  std::string
  to_text(const std::vector<dealii::Point<dim>> &values);
  template <int dim>
  std::string
  to_text(const Expression<dim> &value);
  template <int dim, int n_components>
  std::string
  to_text(const VectorExpression<dim, n_components> &value);

  /// @return a description, for the reference, of what the user writes for a value of this type.
  std::string
  type_name(double);
  std::string
  type_name(unsigned int);
  std::string
  type_name(bool);
  std::string
  type_name(const std::string &);
  std::string
  type_name(const Formula &);
  std::string
  type_name(const std::vector<std::string> &);
  template <typename T>
  std::string
  type_name(const std::vector<T> &);
  template <int dim>
  std::string
  type_name(const dealii::Point<dim> &);
  template <int dim>
  std::string
  type_name(const std::vector<dealii::Point<dim>> &);
  template <int dim>
  std::string
  type_name(const Expression<dim> &);
  template <int dim, int n_components>
  std::string
  type_name(const VectorExpression<dim, n_components> &);
} // namespace Signorini
