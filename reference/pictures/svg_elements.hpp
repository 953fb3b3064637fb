// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

/// The parts that SVG documents are put together from.
namespace oplus::picture {

/// A place on the page, y downwards.
struct Pixel {
  double x;
  double y;
};

double distance(const Pixel& a, const Pixel& b);

/// Two decimals of a pixel, whatever the locale.
std::string number(double pixels);

/// A start tag's attributes, as ` name="value"`.
std::string attributes(
    std::initializer_list<std::pair<std::string_view, std::string>> names_and_values);

/// Text for XML: markup is escaped; characters that are invalid there become question marks.
std::string escaped(const std::string& text);

/// An upper estimate of a text's width: fonts differ.
double text_width(const std::string& text, double size);

std::string text(double x, double y, double size, const std::string& anchor,
                 const std::string& colour, const std::string& content);

/// A step of a path: 'M' moves to p, 'L' draws a line to it.
std::string step(char command, const Pixel& p);

std::string path(const std::string& data, const std::string& more);

std::string circle(const Pixel& centre, double radius, const std::string& more);

/// A document with a width and a height in pixels, its content on white.
std::string document(double width, double height, const std::string& definitions,
                     const std::string& content);

/// The path of a small triangle in the middle of a segment; empty for a segment that it would hide.
std::string arrow_head(const Pixel& source, const Pixel& target, double largest);

}  // namespace oplus::picture
