// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/svg.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::formats {

namespace {

constexpr double kMarker = 3.2;  // half the size of a marker

const char* name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    default:
      return "end";
  }
}

/// Formats a coordinate with two decimals, which is finer than any printer resolves.
std::string coordinate(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string pair(PicturePoint p) { return coordinate(p.x) + "," + coordinate(p.y); }

std::string polygon(PicturePoint at, const std::vector<PicturePoint>& corners) {
  std::string points;
  for (const auto& c : corners)
    points += (points.empty() ? "" : " ") + pair({at.x + kMarker * c.x, at.y + kMarker * c.y});
  return "<polygon points=\"" + points + "\"";
}

/// The outline of a marker, without its colours.
std::string marker_shape(PicturePoint at, std::size_t shape) {
  switch (shape % 8) {
    case 0:
      return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", coordinate(at.x), coordinate(at.y), kMarker);
    case 1:
      return polygon(at, {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case 2:
      return polygon(at, {{0, -1.2}, {1.1, 0.8}, {-1.1, 0.8}});
    case 3:
      return polygon(at, {{0, -1.3}, {1.1, 0}, {0, 1.3}, {-1.1, 0}});
    case 4:
      return polygon(at, {{0, 1.2}, {1.1, -0.8}, {-1.1, -0.8}});
    case 5:
      return polygon(at, {{-1.2, 0}, {0.8, 1.1}, {0.8, -1.1}});
    case 6:
      return polygon(at, {{1.2, 0}, {-0.8, 1.1}, {-0.8, -1.1}});
    default:
      return polygon(at, {{0, -1.2}, {1.15, -0.35}, {0.7, 1}, {-0.7, 1}, {-1.15, -0.35}});
  }
}

}  // namespace

std::string escape_markup(const std::string& text) {
  std::string safe;
  for (const char c : text) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  return safe;
}

void SvgPicture::line(PicturePoint from, PicturePoint to, const char* colour, double width) {
  line(from, to, colour, width, "");
}

void SvgPicture::line(PicturePoint from, PicturePoint to, const char* colour, double width,
                      const char* dashes) {
  const std::string dashed = *dashes ? fmt::format(" stroke-dasharray=\"{}\"", dashes) : "";
  body_ += fmt::format(
      "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
      coordinate(from.x), coordinate(from.y), coordinate(to.x), coordinate(to.y), colour, width, dashed);
}

void SvgPicture::frame(PicturePoint corner, PicturePoint opposite, const char* colour) {
  body_ += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"0.9\"/>\n",
      coordinate(corner.x), coordinate(corner.y), coordinate(opposite.x - corner.x),
      coordinate(opposite.y - corner.y), colour);
}

void SvgPicture::path(const std::vector<PicturePoint>& points, const char* colour, double width) {
  if (points.size() < 2) return;
  std::string list;
  for (const auto& p : points) list += (list.empty() ? "" : " ") + pair(p);
  body_ += fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"/>\n",
      list, colour, width);
}

void SvgPicture::area(const std::vector<PicturePoint>& outline, const char* colour, double opacity) {
  if (outline.size() < 3) return;
  std::string list;
  for (const auto& p : outline) list += (list.empty() ? "" : " ") + pair(p);
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>\n", list, colour, opacity);
}

void SvgPicture::marker(PicturePoint at, std::size_t shape, const char* colour, bool is_hollow) {
  constexpr const char* kGround = "#ffffff";
  body_ += fmt::format("{} fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", marker_shape(at, shape),
                       is_hollow ? kGround : colour, is_hollow ? colour : kGround, is_hollow ? 1.2 : 0.6);
}

void SvgPicture::words(PicturePoint at, const std::string& markup, double size, const char* colour,
                       Anchor anchor, const std::string& more) {
  body_ +=
      fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                  coordinate(at.x), coordinate(at.y), size, colour, name_of(anchor), more, markup);
}

void SvgPicture::text(PicturePoint at, const std::string& text, double size, const char* colour,
                      Anchor anchor) {
  words(at, escape_markup(text), size, colour, anchor);
}

void SvgPicture::rotated_text(PicturePoint at, const std::string& text, double size, const char* colour,
                              Anchor anchor, bool halo) {
  const char* rim = halo ? " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"" : "";
  words(at, escape_markup(text), size, colour, anchor,
        fmt::format("{} transform=\"rotate(-90 {})\"", rim, pair(at)));
}

void SvgPicture::number(PicturePoint at, double value, bool as_power, double size, Anchor anchor) {
  const double exponent = std::round(std::log10(value));
  const std::string markup =
      as_power ? fmt::format("10<tspan dy=\"{}\" font-size=\"{}\">{}{}</tspan>", -0.38 * size, 0.72 * size,
                             exponent < 0 ? "\u2212" : "", std::abs(exponent))
               : fmt::format("{:g}", value + 0.0);  // no sign for a zero
  words(at, markup, size, "#222222", anchor);
}

std::string SvgPicture::finish(DrawingSize size, double pixels) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {2} {3}\" "
      "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{4}</svg>\n",
      coordinate(pixels), coordinate(size.height * pixels / size.width), coordinate(size.width),
      coordinate(size.height), body_);
}

}  // namespace netloft::formats
