#include "tests/model/formats/real_importer.h"

#include "model/formats/isolated_import.h"

namespace knotspan::testing {

RealImporter::RealImporter()
{
    formats::setImportWorker(KNOTSPAN_PROGRAM);
}

RealImporter::~RealImporter()
{
    formats::setImportWorker({});
}

}  // namespace knotspan::testing
