#include "tests/app/svg_file.h"

#include <QXmlStreamReader>
#include <gtest/gtest.h>

#include "tests/support.h"

namespace knotspan::testing {

std::optional<SvgFile> readSvg(const std::filesystem::path& path)
{
    SvgFile file;
    QXmlStreamReader xml(QByteArray::fromStdString(readFile(path)));
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.attributes().value("class") == QStringLiteral("marker"))
            ++file.markers;
        if (xml.isStartElement() && xml.attributes().value("class") == QStringLiteral("curve"))
            ++file.curves;
        if (xml.isCharacters() && !xml.isWhitespace())
            file.text += xml.text().toString().toStdString() + "\n";
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return xml.hasError() ? std::nullopt : std::optional(file);
}

}  // namespace knotspan::testing
