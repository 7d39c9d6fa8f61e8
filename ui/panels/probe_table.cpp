#include "ui/panels/probe_table.h"

#include <algorithm>
#include <cmath>

#include <QColor>

#include "ui/tools/probe_texts.h"
#include "ui/viewport/probe_lines.h"

namespace knotspan {

ProbeTable::ProbeTable(const Document& document, const Probes& probes, QObject* parent)
    : QAbstractTableModel(parent),
      document_(document),
      probes_(probes)
{
}

void ProbeTable::takeOver()
{
    std::vector<Row> rows;
    for (const Probe& pin : probes_.pins())
        if (auto place = probed(document_.scene(), pin))
            rows.push_back({pin.number, std::move(*place)});
    const auto isSame = [](const Row& a, const Row& b) { return a.number == b.number; };
    if (!std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(), isSame)) {
        beginResetModel();
        rows_ = std::move(rows);
        endResetModel();
    } else if (!rows.empty()) {
        rows_ = std::move(rows);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    }
    if (units_ != document_.scene().units()) {
        units_ = document_.scene().units();
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, columns - 1);
    }
}

int ProbeTable::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ProbeTable::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : columns;
}

std::optional<double> ProbeTable::valueOf(const Row& row, int column)
{
    const PlaceMeasures& at = row.place.measures;
    if (column >= x && column <= z)
        return at.position[column - x];
    if (column >= normalX && column <= normalZ)
        return at.normal ? std::optional((*at.normal)[column - normalX]) : std::nullopt;
    if (column == paramU || column == paramV)
        return column == paramU ? row.place.u : row.place.v;
    if (column < gauss || !at.curvature)
        return std::nullopt;
    switch (column) {
    case gauss:
        return at.curvature->gauss;
    case mean:
        return at.curvature->mean;
    case largest:
    case largestRadius:
        return at.curvature->largest;
    default:
        return at.curvature->smallest;
    }
}

QString ProbeTable::text(const Row& row, int column)
{
    if (column == number)
        return QString::number(row.number);
    if (column == object)
        return row.place.object.empty() ? tr("Surface") : QString::fromStdString(row.place.object);
    const auto value = valueOf(row, column);
    if (!value)
        return tr("-");
    const double bend = curvatureScale(row.place);
    if (column == largestRadius || column == smallestRadius)
        return radiusText(row.place, *value);
    const double scale = column >= gauss     ? (column == gauss ? bend * bend : bend)
                         : column >= normalX ? 1
                         : column >= x       ? row.place.size
                                             : 0;
    return measureFigure(*value, scale);
}

QString ProbeTable::title(int column) const
{
    const QString unit = QString::fromStdString(document_.scene().units());
    const auto length = [&](const char* name) { return QString("%1 (%2)").arg(name, unit); };
    const auto bend = [&](const QString& name) { return QString("%1 (1/%2)").arg(name, unit); };
    switch (column) {
    case number:
        return tr("Probe");
    case object:
        return tr("Object");
    case paramU:
        return "u";
    case paramV:
        return "v";
    case x:
        return length("x");
    case y:
        return length("y");
    case z:
        return length("z");
    case normalX:
        return "nx";
    case normalY:
        return "ny";
    case normalZ:
        return "nz";
    case gauss:
        return QString("%1 (1/%2²)").arg(tr("Gauss"), unit);
    case mean:
        return bend(tr("Mean"));
    case largest:
        return bend("k1");
    case smallest:
        return bend("k2");
    case largestRadius:
        return length("r1");
    default:
        return length("r2");
    }
}

QVariant ProbeTable::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole)
        return text(row(index.row()), index.column());
    if (role == Qt::TextAlignmentRole && index.column() != object)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant ProbeTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section >= columns)
        return {};
    if (role == Qt::DisplayRole)
        return title(section);
    if (role == Qt::DecorationRole) {
        if (section == normalX)
            return QColor(kNormalColour);
        if (section == largest)
            return QColor(kLargestColour);
        if (section == smallest)
            return QColor(kSmallestColour);
    }
    if (role == Qt::ToolTipRole) {
        if (section >= normalX && section <= normalZ)
            return tr("The unit normal, to the front of the surface");
        if (section == largest || section == smallest)
            return tr(
                "The largest (k1) and the smallest (k2) curvature of all directions: positive where the "
                "surface bends towards its front");
        if (section >= largestRadius)
            return tr("The radius of the circle that bends as much: 1 / |k|");
    }
    return {};
}

QString ProbeTable::tabSeparated(const std::vector<int>& rows) const
{
    QStringList lines;
    QStringList cells;
    for (int column = 0; column < columns; ++column)
        cells << title(column);
    lines << cells.join('\t');
    for (const int at : rows) {
        const Row& from = row(at);
        cells.clear();
        for (int column = 0; column < columns; ++column) {
            auto value = valueOf(from, column);
            if (value && column >= largestRadius)
                value = *value == 0 ? std::nullopt : std::optional(1 / std::abs(*value));
            cells << (column <= object ? text(from, column).simplified()
                      : value          ? QString::number(*value, 'g', 15)
                                       : QString());
        }
        lines << cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

}  // namespace knotspan
