#include "ui/panels/friends_table.h"

#include <QColor>

#include "ui/viewport/friend_lines.h"

namespace knotspan {

namespace {

QString edgeName(const SceneFriends& friends, const EdgePart& part)
{
    const std::string& given = friends.object(part.surface)->name;
    const QString name =
        given.empty()
            ? FriendsTable::tr("Surface %1").arg(static_cast<std::uint32_t>(friends.objects()[part.surface]))
            : QString::fromStdString(given);
    return QString("%1, %2").arg(name, QString::fromLatin1(sideName(part.side)));
}

// What a column is sorted by; verdicts from the worst on.
double orderOf(const FriendsTable::Row& row, int column)
{
    if (!row.meeting)
        return column == FriendsTable::verdict ? -1 : -1e300;
    const FriendEdge& edge = *row.meeting;
    switch (column) {
    case FriendsTable::verdict:
        return static_cast<double>(edge.continuity);
    case FriendsTable::gap:
        return edge.gapMax;
    case FriendsTable::angle:
        return edge.angleBoundDeg;
    default:
        return edge.curvatureMax;
    }
}

}  // namespace

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
        rows.push_back({edge, edge.a, edgeName(now, edge.a), edgeName(now, edge.b)});
    for (const EdgePart& part : now.nakedEdges())
        rows.push_back({{}, part, edgeName(now, part), {}});
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
        return QString::number(edge.gapMax, 'g', 3);
    case angle:
        return edge.angleBoundDeg >= 180 ? tr("-") : QString("%1°").arg(edge.angleBoundDeg, 0, 'g', 3);
    default:
        return edge.continuity == Continuity::g1 || edge.continuity == Continuity::g2
                   ? QString::number(edge.curvatureMax, 'g', 3)
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
        .arg(edge.gapMax, 0, 'g', 3)
        .arg(edge.angleBoundDeg, 0, 'g', 4)
        .arg(edge.angleMaxDeg, 0, 'g', 4);
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
    const QString tips[] = {tr("A surface and one of its sides"),
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
      table_(table)
{
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
    return wanted &&
           (text_.isEmpty() || says(row.nameA) || says(row.nameB) || says(table_.verdictText(number)));
}

bool FriendsFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const FriendsTable::Row& a = table_.row(left.row());
    const FriendsTable::Row& b = table_.row(right.row());
    if (left.column() == FriendsTable::edgeA || left.column() == FriendsTable::edgeB) {
        const bool first = left.column() == FriendsTable::edgeA;
        return QString::compare(first ? a.nameA : a.nameB, first ? b.nameA : b.nameB) < 0;
    }
    return orderOf(a, left.column()) < orderOf(b, left.column());
}

}  // namespace knotspan
