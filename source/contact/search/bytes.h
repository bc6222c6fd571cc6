// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/serialization/binary_object.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace Signorini
{
  /// Read or write as it lies in memory what would else be sent number by number, at many times the
  /// cost.
  template <class Archive, typename T>
  void
  serialize_bytes(Archive &ar, T &object)
  {
    static_assert(std::is_trivially_copyable<T>::value, "sent bit by bit");
    ar &boost::serialization::make_binary_object(&object, sizeof(T));
  }

  template <class Archive, typename T>
  void
  serialize_bytes(Archive &ar, std::vector<T> &objects)
  {
    // Pairs of numbers are no trivially copyable type by name, since they have an operator =.
    static_assert(std::is_trivially_copy_constructible<T>::value &&
                    std::is_trivially_destructible<T>::value,
                  "sent bit by bit");
    std::size_t n = objects.size();
    serialize_bytes(ar, n);
    objects.resize(n);
    ar &boost::serialization::make_binary_object(objects.data(), n * sizeof(T));
  }
} // namespace Signorini
