#include "FigureGallery.h"

#include "OutputFile.h"

namespace mien {

namespace {

const char* const head =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Mien: figures</title>\n<style>\n"
    "body { font-family: 'DejaVu Sans', Verdana, sans-serif; color: #222; background: #f4f4f2; max-width: 68em;"
    " margin: 2em auto; padding: 0 1em; line-height: 1.45; }\n"
    "figure { background: #fff; margin: 0 0 2.5em; padding: 1.2em; border: 1px solid #ddd; }\n"
    "figure img, figure object { max-width: 100%; height: auto; display: block; margin: 0 auto 1em; }\n"
    "figcaption h2 { font-size: 1.1em; margin: 0; }\n"
    ".source { color: #666; font-size: .85em; }\n"
    "code { display: block; background: #f0f0ee; padding: .5em .7em; overflow-x: auto; white-space: pre; }\n"
    "nav a { margin-right: .9em; white-space: nowrap; }\n</style>\n</head>\n<body>\n<h1>Figures drawn by Mien</h1>\n";

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    const char* const entity = c == '<'   ? "&lt;"
                               : c == '>' ? "&gt;"
                               : c == '&' ? "&amp;"
                               : c == '"' ? "&quot;"
                                          : nullptr;
    html += entity ? std::string(entity) : std::string(1, c);
  }
  return html;
}

/// PDF files are no pictures to a browser.
std::string picture(const FigureGallery::Entry& entry) {
  const std::string file = escaped(entry.file), title = escaped(entry.figure->title);
  if (fileEnding(entry.file) == "pdf") return "<p><a href=\"" + file + "\">" + file + "</a></p>\n";
  return "<a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" + title + "\"></a>\n";
}

std::string section(const FigureGallery::Entry& entry) {
  const CatalogueFigure& figure = *entry.figure;
  return "<figure id=\"" + figure.id + "\">\n" + picture(entry) + "<figcaption>\n<h2>" +
         escaped(figure.id + ": " + figure.title) + "</h2>\n<p class=\"source\">" +
         escaped(figure.source.empty() ? "Mien's own figure" : "After " + figure.source) + "</p>\n<p>" +
         escaped(entry.caption) + "</p>\n<p class=\"source\">" + escaped(entry.note) + "</p>\n<code>" +
         escaped(entry.command) + "</code>\n</figcaption>\n</figure>\n";
}

}  // namespace

std::string FigureGallery::html() const {
  std::string page = std::string(head) + "<p>Mien " + MIEN_VERSION + "</p>\n<nav>";
  for (const Entry& entry : entries_) page += "<a href=\"#" + entry.figure->id + "\">" + entry.figure->id + "</a>\n";
  page += "</nav>\n";
  for (const Entry& entry : entries_) page += section(entry);
  return page + "</body>\n</html>\n";
}

}  // namespace mien
