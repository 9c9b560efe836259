#include "FigureMetadata.h"

#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

namespace mien {

namespace {

constexpr qint64 mostBytes = 256 << 20;
const QString xmpSpace = QStringLiteral("adobe:ns:meta/");
const QString rdfSpace = QStringLiteral("http://www.w3.org/1999/02/22-rdf-syntax-ns#");
const QString coreSpace = QStringLiteral("http://purl.org/dc/elements/1.1/");

/// The first elements called title and desc(ription) anywhere in the text.
FigureMetadata fromXML(const QByteArray& text) {
  FigureMetadata found;
  QXmlStreamReader reader(text);
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    const QString name = reader.name().toString();
    if (name == QLatin1String("title") && found.title.empty())
      found.title = reader.readElementText(QXmlStreamReader::IncludeChildElements).trimmed().toStdString();
    else if (name == QLatin1String("desc") || name == QLatin1String("description"))
      found.description = reader.readElementText(QXmlStreamReader::IncludeChildElements).trimmed().toStdString();
    if (!found.description.empty()) break;
  }
  return found;
}

FigureMetadata fromPDF(const QByteArray& bytes) {
  const int begin = bytes.indexOf("<x:xmpmeta"), end = bytes.indexOf("</x:xmpmeta>", begin);
  return begin < 0 || end < 0 ? FigureMetadata() : fromXML(bytes.mid(begin, end - begin + 12));
}

/// A picture of mien render carries the state alone.
FigureMetadata fromPNG(const QString& name) {
  const QImageReader reader(name, "png");
  FigureMetadata found = {FigureMetadata::fromOneLine(reader.text("Title")),
                          FigureMetadata::fromOneLine(reader.text("Description"))};
  if (found.description.empty()) found.description = reader.text("MienFaceState").toStdString();
  return found;
}

/// Alternatives of languages hold one text here, for all of them.
void writeAlternative(QXmlStreamWriter& writer, const QString& element, const std::string& text) {
  writer.writeStartElement(coreSpace, element);
  writer.writeStartElement(rdfSpace, QStringLiteral("Alt"));
  writer.writeStartElement(rdfSpace, QStringLiteral("li"));
  writer.writeAttribute(QStringLiteral("xml:lang"), QStringLiteral("x-default"));
  writer.writeCharacters(QString::fromStdString(text));
  for (int i = 0; i < 3; ++i) writer.writeEndElement();
}

}  // namespace

std::string FigureMetadata::command() const {
  const std::string first = description.substr(0, description.find('\n'));
  return first.rfind("mien ", 0) == 0 ? first : std::string();
}

std::string FigureMetadata::state() const {
  const size_t begin = description.rfind('{', 0) == 0 ? 0 : description.find("\n{");
  if (begin == std::string::npos) return {};
  const size_t end = description.find("\n}", begin);  // behind it a comparison carries another
  return description.substr(begin, end == std::string::npos ? end : end + 2 - begin);
}

QByteArray FigureMetadata::xmp() const {
  QByteArray text;
  QXmlStreamWriter writer(&text);
  writer.writeNamespace(xmpSpace, QStringLiteral("x"));
  writer.writeNamespace(rdfSpace, QStringLiteral("rdf"));
  writer.writeNamespace(coreSpace, QStringLiteral("dc"));
  writer.writeProcessingInstruction("xpacket begin='' id='W5M0MpCehiHzreSzNTczkc9d'");
  writer.writeStartElement(xmpSpace, QStringLiteral("xmpmeta"));
  writer.writeStartElement(rdfSpace, QStringLiteral("RDF"));
  writer.writeStartElement(rdfSpace, QStringLiteral("Description"));
  writer.writeAttribute(rdfSpace, QStringLiteral("about"), QString());
  writeAlternative(writer, QStringLiteral("title"), title);
  writeAlternative(writer, QStringLiteral("description"), description);
  for (int i = 0; i < 3; ++i) writer.writeEndElement();
  writer.writeProcessingInstruction("xpacket end='r'");
  return text;
}

QString FigureMetadata::oneLine(const std::string& text) {
  QString line = QString::fromStdString(text);
  return line.replace('\\', "\\\\").replace('\n', "\\n").replace("  ", " \\s");
}

std::string FigureMetadata::fromOneLine(const QString& line) {
  QString text;
  for (int i = 0; i < line.size(); ++i) {
    const bool isEscape = line[i] == '\\' && i + 1 < line.size();
    if (!isEscape) {
      text += line[i];
      continue;
    }
    const QChar letter = line[++i];
    text += letter == 'n' ? QChar('\n') : letter == 's' ? QChar(' ') : letter;
  }
  return text.toStdString();
}

std::string FigureMetadata::read(const std::string& name) {
  const QString file = QString::fromStdString(name);
  const QString ending = QFileInfo(file).suffix().toLower();
  QFile bytes(file);
  if (!bytes.open(QIODevice::ReadOnly)) return name + ": cannot be read; check that the figure exists";
  if (bytes.size() > mostBytes) return name + ": is larger than 256 MiB, which no figure of Mien is";
  FigureMetadata found;
  if (ending == "svg") found = fromXML(bytes.readAll());
  if (ending == "pdf") found = fromPDF(bytes.readAll());
  if (ending == "png") found = fromPNG(file);
  if (found.description.empty())
    return name + ": holds no description of how it was made; give a .svg, .pdf or .png that Mien drew";
  *this = found;
  return {};
}

}  // namespace mien
