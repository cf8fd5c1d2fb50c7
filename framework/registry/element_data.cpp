// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/element_data.hpp"

#include "framework/parameters/nearest.hpp"

#include <algorithm>

namespace netloft {

namespace {

/// Converts a datum of a single element to the datum of a pair of elements. A datum with one number per
/// corner gets one number per node of the pair; any other datum gets the numbers of both elements.
constexpr HostDatum of_pair(HostDatum datum, std::uint32_t corners, std::uint32_t nodes) {
  datum.width = datum.width == corners ? nodes : 2 * datum.width;
  return datum;
}

constexpr HostDatum kOfNode[] = {datum::kPieces, datum::kLength};
constexpr HostDatum kOfBar[] = {datum::kRestLength, datum::kParallel};
constexpr HostDatum kOfTriangle[] = {datum::kU, datum::kV, datum::kBarLength, datum::kToAft, datum::kOutward};
constexpr HostDatum kOfBody[] = {datum::kSide, datum::kArm};
constexpr HostDatum kOfBarPair[] = {of_pair(datum::kRestLength, 2, 3), of_pair(datum::kParallel, 2, 3)};
constexpr HostDatum kOfTrianglePair[] = {of_pair(datum::kU, 3, 4), of_pair(datum::kV, 3, 4),
                                         of_pair(datum::kBarLength, 3, 4), of_pair(datum::kToAft, 3, 4)};

}  // namespace

std::span<const HostDatum> data_on(std::uint32_t stencil) {
  switch (stencil) {
    case NETLOFT_NODE:
      return kOfNode;
    case NETLOFT_BAR:
      return kOfBar;
    case NETLOFT_TRIANGLE:
      return kOfTriangle;
    case NETLOFT_BODY:
      return kOfBody;
    case NETLOFT_BAR_PAIR:
      return kOfBarPair;
    case NETLOFT_TRIANGLE_PAIR:
      return kOfTrianglePair;
    default:
      return {};
  }
}

const HostDatum* find_datum_on(std::uint32_t stencil, std::string_view name) {
  for (const HostDatum& datum : data_on(stencil))
    if (name == datum.name) return &datum;
  return nullptr;
}

const HostDatum* find_datum_meant(std::uint32_t stencil, std::string_view name) {
  std::vector<std::string> names;
  for (const HostDatum& datum : data_on(stencil)) names.emplace_back(datum.name);
  const auto meant = nearest(name, names);
  return meant ? find_datum_on(stencil, *meant) : nullptr;
}

std::string names_of_data_on(std::uint32_t stencil) {
  std::string names;
  for (const HostDatum& datum : data_on(stencil))
    names += (names.empty() ? "" : ", ") + std::string(datum.name);
  return names;
}

bool declares(const ElementType& type, const HostDatum& datum) {
  return std::ranges::any_of(type.data,
                             [&](const netloft_datum& d) { return std::string_view(d.name) == datum.name; });
}

const std::vector<double>* find_data(const ElementData& data, const HostDatum& datum) {
  const auto at = data.find(datum.name);
  return at == data.end() || at->second.empty() ? nullptr : &at->second;
}

}  // namespace netloft
