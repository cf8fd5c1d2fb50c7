// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace netloft {

/// A datum (numbers of each element, such as its rest length) that the host provides to every element that
/// declares it by this name. Code that fills or reads the datum uses the names below. guides/element.md lists
/// the same data for authors; a test compares both lists.
struct HostDatum {
  const char* name;
  std::uint32_t width;  // how many numbers an element has
  const char *unit, *doc;
  bool is_sign = false;  // whether its numbers are 1 or -1
};

namespace datum {

inline constexpr HostDatum kPieces{"pieces", 1, "1",
                                   "number of pieces at the node; 1 if the part has nodes of its own"};
inline constexpr HostDatum kLength{
    "length", 1, "m", "length of rope or twine that the node carries; 0 if the part has nodes of its own"};
inline constexpr HostDatum kRestLength{"rest_length", 1, "m", "unstretched length of the bar"};
inline constexpr HostDatum kParallel{"parallel", 1, "1",
                                     "number of parallel twines of a panel that one bar represents"};
inline constexpr HostDatum kU{"u", 3, "1", "first twine coordinate of the corners, in bars"};
inline constexpr HostDatum kV{"v", 3, "1", "second twine coordinate of the corners, in bars"};
inline constexpr HostDatum kBarLength{"bar_length", 1, "m", "unstretched length of a bar of the netting"};
inline constexpr HostDatum kToAft{"to_aft", 3, "1", "meshes from the corners to the aft edge of the panel"};
inline constexpr HostDatum kOutward{
    "outward", 1, "1", "1 if the corners are counter-clockwise seen from outside, -1 if clockwise", true};
inline constexpr HostDatum kSide{"side", 1, "1", "1 to starboard, -1 to port", true};
inline constexpr HostDatum kArm{
    "arm", 3, "m",
    "point of the body on which the element acts, in the axes of a body to starboard; 0: the whole body"};

}  // namespace datum

/// The data that elements on a stencil may declare.
std::span<const HostDatum> data_on(std::uint32_t stencil);
/// Returns the datum with this name, or nullptr if the host does not provide it; the scene then has to give
/// it with the part.
const HostDatum* find_datum_on(std::uint32_t stencil, std::string_view name);
/// Returns the datum whose name is most similar to a misspelt one, or nullptr if none is similar.
const HostDatum* find_datum_meant(std::uint32_t stencil, std::string_view name);
/// Names of the data that the host gives: "rest_length, parallel".
std::string names_of_data_on(std::uint32_t stencil);
bool declares(const ElementType& type, const HostDatum& datum);

/// Numbers of the elements of a part, by name of the datum: [element][width].
using ElementData = std::map<std::string, std::vector<double>>;
/// Returns the numbers of a datum, or nullptr if there are none.
const std::vector<double>* find_data(const ElementData& data, const HostDatum& datum);

}  // namespace netloft
