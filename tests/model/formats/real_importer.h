// The program itself as the importer, for as long as the object lives.
#pragma once

namespace knotspan::testing {

class RealImporter {
public:
    RealImporter();
    ~RealImporter();
    RealImporter(const RealImporter&) = delete;
    RealImporter& operator=(const RealImporter&) = delete;
};

}  // namespace knotspan::testing
