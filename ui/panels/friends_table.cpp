#include "ui/panels/friends_table.h"

#include <cmath>

#include <QColor>
#include <QLocale>

#include "ui/viewport/friend_lines.h"

namespace knotspan {

namespace {

constexpr double kNoLength = 1e-9;
constexpr double kNoAngle = 1e-7;  // degrees
constexpr double kNoCurvature = 1e-9;

QString objectName(const SceneFriends& friends, const EdgePart& part)
{
    const std::string& given = friends.object(part.surface)->name;
    return given.empty() ? FriendsTable::tr("Surface %1")
                               .arg(static_cast<std::uint32_t>(friends.objects()[part.surface]))
                         : QString::fromStdString(given);
}

FriendsTable::Row rowOf(const SceneFriends& friends, const EdgePart& a, const FriendEdge* edge)
{
    FriendsTable::Row row;
    row.a = a;
    const auto name = [&](const EdgePart& part, QString& shown, QString& order) {
        const QString object = objectName(friends, part);
        const QString side = QString::fromStdString(edgeName(part));
        shown = QString("%1, %2").arg(side, object);
        order = QString("%1, %2").arg(object, side);
    };
    name(a, row.nameA, row.orderA);
    if (edge != nullptr) {
        row.meeting = *edge;
        name(edge->b, row.nameB, row.orderB);
    }
    return row;
}

// Where nothing is guaranteed, at least what was met.
QString angleText(const FriendEdge& edge)
{
    if (edge.angleBoundDeg < 180)
        return QString("%1°").arg(friendFigure(edge.angleBoundDeg, kNoAngle));
    return QString(edge.angleMaxDeg < 180 ? "≥ %1°" : "%1°").arg(friendFigure(edge.angleMaxDeg, kNoAngle));
}

// What a column is sorted by; verdicts from the worst on.
double orderOf(const FriendsTable::Row& row, int column)
{
    if (!row.meeting)
        return column == FriendsTable::verdict ? -1 : -1e300;
    const FriendEdge& edge = *row.meeting;
    switch (column) {
    case FriendsTable::verdict:
        return smoothnessRank(edge.continuity);
    case FriendsTable::gap:
        return edge.gapMax;
    case FriendsTable::angle:
        return edge.angleBoundDeg;
    default:
        return edge.curvatureMax;
    }
}

}  // namespace

QString friendFigure(double value, double noise)
{
    if (std::abs(value) < noise)
        return "0";
    if (std::abs(value) >= 1e-3)
        return QString::number(value, 'g', 3);
    return QString::number(value, 'e', 2).replace("e-0", "e-");  // shorter than 0.000123
}

FriendsTable::FriendsTable(DocumentFriends& friends, QObject* parent)
    : QAbstractTableModel(parent),
      friends_(friends)
{
}

void FriendsTable::takeOver()
{
    const int revision = friends_.revision();
    if (revision == revision_)
        return;
    revision_ = revision;
    const SceneFriends& now = friends_.friends();
    std::vector<Row> rows;
    rows.reserve(now.edges().size() + now.nakedEdges().size());
    for (const FriendEdge& edge : now.edges())
        rows.push_back(rowOf(now, edge.a, &edge));
    for (const EdgePart& part : now.nakedEdges())
        rows.push_back(rowOf(now, part, nullptr));
    if (rows.size() != rows_.size()) {
        beginResetModel();
        rows_ = std::move(rows);
        endResetModel();
        return;
    }
    for (size_t k = 0; k < rows.size(); ++k) {
        if (rows[k] == rows_[k])
            continue;
        rows_[k] = std::move(rows[k]);
        const int number = static_cast<int>(k);
        Q_EMIT dataChanged(index(number, 0), index(number, columns - 1));
    }
}

QString FriendsTable::verdictText(int number) const
{
    return text(row(number), verdict);
}

int FriendsTable::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int FriendsTable::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : columns;
}

QString FriendsTable::text(const Row& row, int column) const
{
    if (column == edgeA)
        return row.nameA;
    if (!row.meeting)
        return column == verdict ? tr("naked") : QString();
    const FriendEdge& edge = *row.meeting;
    switch (column) {
    case edgeB:
        return row.nameB;
    case verdict:
        return QString::fromLatin1(continuityName(edge.continuity));
    case gap:
        return friendFigure(edge.gapMax, kNoLength);
    case angle:
        return angleText(edge);
    default:
        return edge.continuity == Continuity::g1 || edge.continuity == Continuity::g2
                   ? friendFigure(edge.curvatureMax, kNoCurvature)
                   : tr("-");
    }
}

QString FriendsTable::toolTip(const Row& row) const
{
    if (!row.meeting)
        return tr("%1 runs along no other edge. Click to go there.").arg(row.nameA);
    const FriendEdge& edge = *row.meeting;
    return tr("%1 and %2: %3. Gap at most %4, angle at most %5° (%6° is reached). Click to go to the worst "
              "point.")
        .arg(row.nameA, row.nameB, text(row, verdict))
        .arg(friendFigure(edge.gapMax, kNoLength), friendFigure(edge.angleBoundDeg, kNoAngle),
             friendFigure(edge.angleMaxDeg, kNoAngle));
}

QVariant FriendsTable::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = rows_[static_cast<size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::ToolTipRole:
        return toolTip(row);
    case Qt::DecorationRole:
        if (index.column() == verdict)
            return QColor(row.meeting ? verdictColour(row.meeting->continuity) : nakedColour());
        return {};
    case Qt::TextAlignmentRole:
        return index.column() >= gap ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    default:
        return {};
    }
}

QVariant FriendsTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section >= columns)
        return {};
    const QString titles[] = {tr("Edge"), tr("Meets"), tr("Verdict"),
                              tr("Gap"),  tr("Angle"), tr("Curvature")};
    const QString tips[] = {tr("One side of a surface"),
                            tr("The edge that runs along it; none for a naked edge"),
                            tr("How smoothly they meet: none, G0, G1 or G2"),
                            tr("The largest distance, in the model's unit: guaranteed"),
                            tr("The largest angle between the tangent planes: guaranteed"),
                            tr("The largest difference of curvatures across the edge, where it is smooth")};
    if (role == Qt::DisplayRole)
        return titles[section];
    return role == Qt::ToolTipRole ? QVariant(tips[section]) : QVariant();
}

FriendsFilter::FriendsFilter(FriendsTable& table, QObject* parent)
    : QSortFilterProxyModel(parent),
      table_(table),
      // The locale C knows no numbers in names.
      order_(QLocale().language() == QLocale::C ? QLocale(QLocale::English) : QLocale())
{
    order_.setNumericMode(true);
    setSourceModel(&table);
    setDynamicSortFilter(true);
}

void FriendsFilter::show(Show what)
{
    what_ = what;
    invalidateFilter();
}

void FriendsFilter::setText(const QString& text)
{
    text_ = text.trimmed();
    invalidateFilter();
}

bool FriendsFilter::filterAcceptsRow(int number, const QModelIndex&) const
{
    const FriendsTable::Row& row = table_.row(number);
    const auto is = [&](Continuity continuity) {
        return row.meeting && row.meeting->continuity == continuity;
    };
    const bool wanted =
        what_ == Show::all || (what_ == Show::problems && row.isProblem()) ||
        (what_ == Show::naked && !row.meeting) || (what_ == Show::none && is(Continuity::none)) ||
        (what_ == Show::g0 && is(Continuity::g0)) || (what_ == Show::g1 && is(Continuity::g1)) ||
        (what_ == Show::g2 && is(Continuity::g2)) ||
        (what_ == Show::undetermined && is(Continuity::undetermined));
    const auto says = [&](const QString& text) { return text.contains(text_, Qt::CaseInsensitive); };
    return wanted && (text_.isEmpty() || says(row.nameA) || says(row.nameB) || says(row.orderA) ||
                      says(row.orderB) || says(table_.verdictText(number)));
}

bool FriendsFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const FriendsTable::Row& a = table_.row(left.row());
    const FriendsTable::Row& b = table_.row(right.row());
    if (left.column() == FriendsTable::edgeA || left.column() == FriendsTable::edgeB) {
        const bool first = left.column() == FriendsTable::edgeA;
        return order_.compare(first ? a.orderA : a.orderB, first ? b.orderA : b.orderB) < 0;
    }
    return orderOf(a, left.column()) < orderOf(b, left.column());
}

}  // namespace knotspan
