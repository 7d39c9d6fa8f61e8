// Notices when another program changes the file that the open model came from.
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QTimer>

#include "model/document/document.h"

namespace knotspan {

class FileWatch : public QObject {
    Q_OBJECT

public:
    // The document outlives it. A change is told when nothing more was written for `quiet`.
    explicit FileWatch(Document& document, std::chrono::milliseconds quiet = std::chrono::milliseconds(500),
                       QObject* parent = nullptr);

    // Whether the file is another than the document read or wrote last.
    [[nodiscard]] bool isChanged() const;

Q_SIGNALS:
    void changed(const QString& path);  // once for each new content

private:
    // What a look at the folder tells of a file's content.
    struct Stamp {
        qint64 bytes = -1;  // there is none
        QDateTime written;

        [[nodiscard]] bool operator==(const Stamp&) const = default;
    };
    [[nodiscard]] static Stamp stampOf(const QString& path);
    void follow();
    void look();

    Document& document_;
    QFileSystemWatcher watcher_;
    QTimer quiet_;
    QString path_;
    int revision_ = -1;
    Stamp own_;    // read or written by the document
    Stamp known_;  // that, or told of
};

}  // namespace knotspan
