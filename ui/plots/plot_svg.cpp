#include "ui/plots/plot_svg.h"

#include <QXmlStreamWriter>

#include "ui/plots/plot_layout.h"

namespace knotspan {

namespace {

QString text(double number)
{
    return QString::number(number, 'g', 6);
}

// XML has no place for control characters, not even escaped.
QString text(const std::string& utf8)
{
    QString result = QString::fromStdString(utf8);
    for (QChar& character : result)
        if (character.unicode() < 0x20 || character.unicode() == 0xfffe || character.unicode() == 0xffff)
            character = QChar(QChar::ReplacementCharacter);
    return result;
}

QString text(PlotAnchor anchor)
{
    return anchor == PlotAnchor::start ? "start" : anchor == PlotAnchor::middle ? "middle" : "end";
}

class Drawing {
public:
    Drawing(QIODevice& device, double width, double height) : xml_(&device)
    {
        xml_.setAutoFormatting(true);
        xml_.writeStartDocument();
        begin("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                      {"viewBox", QString("0 0 %1 %2").arg(width).arg(height)},
                      {"width", text(width)},
                      {"height", text(height)},
                      {"font-family", "sans-serif"},
                      {"font-size", "13"},
                      {"fill", "#222222"}});
        element("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}});
    }

    [[nodiscard]] bool finish()
    {
        xml_.writeEndDocument();
        return !xml_.hasError();
    }

    void draw(const Plot& plot, double top)
    {
        const PlotLayout layout = layoutOf(plot);
        begin("g", {{"transform", QString("translate(0 %1)").arg(top)}});
        for (const PlotLine& line : layout.lines)
            element("line", {{"x1", text(line.from.x)},
                             {"y1", text(line.from.y)},
                             {"x2", text(line.to.x)},
                             {"y2", text(line.to.y)},
                             {"stroke", text(line.colour)}});
        for (const PlotText& written : layout.texts)
            write(written);
        for (size_t k = 0; k < plot.curves.size(); ++k)
            curve(plot.curves[k], layout.curves[k]);
        for (size_t k = 0; k < plot.markers.size(); ++k) {
            begin("g", {{"class", "marker"}});
            element("title", {}, text(plot.markers[k].text));
            symbol({layout.markers[k], plot.markers[k].look});
            xml_.writeEndElement();
        }
        for (const PlotSymbol& entry : layout.legend)
            symbol(entry);
        xml_.writeEndElement();
    }

private:
    using Attributes = std::vector<std::pair<QString, QString>>;

    void begin(const QString& name, const Attributes& attributes)
    {
        xml_.writeStartElement(name);
        for (const auto& [key, value] : attributes)
            xml_.writeAttribute(key, value);
    }

    void element(const QString& name, const Attributes& attributes, const QString& content = {})
    {
        begin(name, attributes);
        if (!content.isEmpty())
            xml_.writeCharacters(content);
        xml_.writeEndElement();
    }

    void write(const PlotText& written)
    {
        Attributes attributes{{"x", text(written.at.x)},
                              {"y", text(written.at.y)},
                              {"text-anchor", text(written.anchor)},
                              {"font-size", text(written.size)}};
        if (written.bold)
            attributes.emplace_back("font-weight", "bold");
        if (written.upwards)
            attributes.emplace_back("transform",
                                    QString("rotate(-90 %1 %2)").arg(written.at.x).arg(written.at.y));
        element("text", attributes, text(written.text));
    }

    void curve(const Curve& look, const std::vector<PlotPoint>& points)
    {
        QStringList places;
        for (const PlotPoint& point : points)
            places << text(point.x) + "," + text(point.y);
        Attributes attributes{{"class", "curve"},
                              {"points", places.join(' ')},
                              {"fill", "none"},
                              {"stroke", text(look.colour)},
                              {"stroke-width", look.strong ? "4" : "2"}};
        if (look.dashed)
            attributes.emplace_back("stroke-dasharray", "6 4");
        element("polyline", attributes);
    }

    void symbol(const PlotSymbol& symbol)
    {
        const auto [x, y] = symbol.at;
        const MarkerLook& look = symbol.look;
        const Attributes paint{{"fill", look.filled ? text(look.colour) : "#ffffff"},
                               {"fill-opacity", look.filled ? "0.85" : "0.4"},
                               {"stroke", text(look.colour)},
                               {"stroke-width", "2"}};
        if (look.ringed)
            circle(symbol.at, kRingRadius, {{"fill", "none"}, {"stroke", "#444444"}});
        if (look.shape == MarkerShape::circle)
            return circle(symbol.at, kMarkerRadius, paint);
        Attributes square{{"x", text(x - kMarkerRadius)},
                          {"y", text(y - kMarkerRadius)},
                          {"width", text(2 * kMarkerRadius)},
                          {"height", text(2 * kMarkerRadius)}};
        square.insert(square.end(), paint.begin(), paint.end());
        element("rect", square);
    }

    void circle(const PlotPoint& at, double radius, Attributes paint)
    {
        paint.insert(paint.end(), {{"cx", text(at.x)}, {"cy", text(at.y)}, {"r", text(radius)}});
        element("circle", paint);
    }

    QXmlStreamWriter xml_;
};

}  // namespace

bool writeSvg(const std::vector<Plot>& plots, QIODevice& device)
{
    Drawing drawing(device, kPlotWidth, kPlotHeight * static_cast<double>(plots.size()));
    double top = 0;
    for (const Plot& plot : plots) {
        drawing.draw(plot, top);
        top += kPlotHeight;
    }
    return drawing.finish();
}

}  // namespace knotspan
