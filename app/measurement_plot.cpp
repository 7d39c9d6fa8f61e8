#include "app/measurement_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <QXmlStreamWriter>

namespace knotspan::app {
namespace {

constexpr double kWidth = 960;
constexpr double kHeight = 600;
constexpr double kLeft = 100;
constexpr double kRight = 720;
constexpr double kTop = 80;
constexpr double kBottom = 520;
constexpr double kRadius = 6;

// A logarithmic axis over whole decades, from the pixel `start` to `end`.
class Axis {
public:
    Axis(const std::vector<double>& values, double start, double end) : start_(start), end_(end)
    {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const double value : values)
            if (value > 0) {
                low = std::min(low, std::log10(value));
                high = std::max(high, std::log10(value));
            }
        if (low > high)
            low = high = 0;
        // No marker in a corner.
        constexpr double kMargin = 0.1;
        low_ = static_cast<int>(std::floor(low - kMargin));
        high_ = static_cast<int>(std::ceil(high + kMargin));
    }

    [[nodiscard]] double pixel(double value) const
    {
        if (!(value > 0))
            return start_;
        return start_ + (std::log10(value) - low_) / (high_ - low_) * (end_ - start_);
    }

    struct Tick {
        double value;
        bool labelled;
    };
    [[nodiscard]] std::vector<Tick> ticks() const
    {
        const int step = (high_ - low_ + 11) / 12;
        std::vector<Tick> result;
        for (int decade = low_; decade <= high_; ++decade) {
            result.push_back({std::pow(10.0, decade), (decade - low_) % step == 0});
            if (high_ - low_ <= 3 && decade < high_)
                for (const int part : {2, 5})
                    result.push_back({part * std::pow(10.0, decade), true});
        }
        return result;
    }

private:
    double start_;
    double end_;
    int low_;
    int high_;
};

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

// 0.01, 20, 1e-7, 1e6
QString tickText(double value)
{
    const double decade = std::floor(std::log10(value) + 1e-9);
    if (decade >= -3 && decade <= 4)
        return text(value);
    return QString("%1e%2").arg(std::round(value / std::pow(10.0, decade))).arg(decade);
}

class Drawing {
public:
    explicit Drawing(QIODevice& device) : xml_(&device)
    {
        xml_.setAutoFormatting(true);
        xml_.writeStartDocument();
        begin("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                      {"viewBox", QString("0 0 %1 %2").arg(kWidth).arg(kHeight)},
                      {"width", text(kWidth)},
                      {"height", text(kHeight)},
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

    using Attributes = std::vector<std::pair<QString, QString>>;
    void begin(const QString& name, const Attributes& attributes)
    {
        xml_.writeStartElement(name);
        for (const auto& [key, value] : attributes)
            xml_.writeAttribute(key, value);
    }
    void end() { xml_.writeEndElement(); }

    void element(const QString& name, const Attributes& attributes, const QString& content = {})
    {
        begin(name, attributes);
        if (!content.isEmpty())
            xml_.writeCharacters(content);
        end();
    }

    void line(double x1, double y1, double x2, double y2, const QString& colour)
    {
        element("line",
                {{"x1", text(x1)}, {"y1", text(y1)}, {"x2", text(x2)}, {"y2", text(y2)}, {"stroke", colour}});
    }

    void write(double x, double y, const QString& content, const QString& anchor, Attributes more = {})
    {
        more.insert(more.end(), {{"x", text(x)}, {"y", text(y)}, {"text-anchor", anchor}});
        element("text", more, content);
    }

    void shape(double x, double y, const MarkerLook& look)
    {
        const QString colour = QString::fromStdString(look.colour);
        const Attributes paint{{"fill", look.filled ? colour : "#ffffff"},
                               {"fill-opacity", look.filled ? "0.85" : "0.4"},
                               {"stroke", colour},
                               {"stroke-width", "2"}};
        if (look.ringed)
            circle(x, y, kRadius + 5, {{"fill", "none"}, {"stroke", "#444444"}});
        if (look.shape == MarkerShape::circle)
            return circle(x, y, kRadius, paint);
        Attributes square{{"x", text(x - kRadius)},
                          {"y", text(y - kRadius)},
                          {"width", text(2 * kRadius)},
                          {"height", text(2 * kRadius)}};
        square.insert(square.end(), paint.begin(), paint.end());
        element("rect", square);
    }

private:
    void circle(double x, double y, double radius, Attributes paint)
    {
        paint.insert(paint.end(), {{"cx", text(x)}, {"cy", text(y)}, {"r", text(radius)}});
        element("circle", paint);
    }

    QXmlStreamWriter xml_;
};

void drawAxes(Drawing& drawing, const Plot& plot, const Axis& x, const Axis& y)
{
    for (const Axis::Tick& tick : x.ticks()) {
        const double at = x.pixel(tick.value);
        drawing.line(at, kTop, at, kBottom, "#dddddd");
        if (tick.labelled)
            drawing.write(at, kBottom + 20, tickText(tick.value), "middle");
    }
    for (const Axis::Tick& tick : y.ticks()) {
        const double at = y.pixel(tick.value);
        drawing.line(kLeft, at, kRight, at, "#dddddd");
        if (tick.labelled)
            drawing.write(kLeft - 8, at + 4, tickText(tick.value), "end");
    }
    drawing.line(kLeft, kBottom, kRight, kBottom, "#222222");
    drawing.line(kLeft, kTop, kLeft, kBottom, "#222222");
    drawing.write((kLeft + kRight) / 2, kBottom + 50, text(plot.xLabel), "middle");
    const double middle = (kTop + kBottom) / 2;
    drawing.write(30, middle, text(plot.yLabel), "middle",
                  {{"transform", QString("rotate(-90 30 %1)").arg(middle)}});
}

void drawMarkers(Drawing& drawing, const Plot& plot, const Axis& x, const Axis& y)
{
    for (const Marker& marker : plot.markers) {
        drawing.begin("g", {{"class", "marker"}});
        drawing.element("title", {}, text(marker.text));
        drawing.shape(x.pixel(marker.x), y.pixel(marker.y), marker.look);
        drawing.end();
    }
}

void drawLegend(Drawing& drawing, const Plot& plot)
{
    double y = kTop + 12;
    for (const LegendEntry& entry : plot.legend) {
        drawing.shape(kRight + 35, y, entry.look);
        drawing.write(kRight + 55, y + 4, text(entry.text), "start");
        y += 28;
    }
}

}  // namespace

std::string plotColour(size_t k)
{
    constexpr std::array kColours{"#0072b2", "#e69f00", "#cc79a7", "#009e73",
                                  "#56b4e9", "#d55e00", "#000000"};
    return kColours[k % kColours.size()];
}

bool writeSvg(const Plot& plot, QIODevice& device)
{
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Marker& marker : plot.markers) {
        xs.push_back(marker.x);
        ys.push_back(marker.y);
    }
    const Axis x(xs, kLeft, kRight);
    const Axis y(ys, kBottom, kTop);
    Drawing drawing(device);
    drawing.write(kLeft, 34, text(plot.title), "start", {{"font-size", "18"}, {"font-weight", "bold"}});
    drawing.write(kLeft, 58, text(plot.subtitle), "start");
    drawAxes(drawing, plot, x, y);
    drawMarkers(drawing, plot, x, y);
    drawLegend(drawing, plot);
    return drawing.finish();
}

}  // namespace knotspan::app
