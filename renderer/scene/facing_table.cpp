#include "renderer/scene/facing_table.h"

#include "shaders/shared/bindings.h"

namespace knotspan {

void FacingTable::update(const std::vector<Resident>& residents, FacingArrays::Origins origins,
                         FacingStrength strength, const ResidentChanges& log)
{
    const auto runs = arrays_.update(residents, origins, strength, &log);
    const auto provide = [&](Buffer& buffer, int binding, size_t bytes) {
        if (buffer.bytes() != bytes)
            uploader_.forget(buffer);
        bindings_.provide(binding, buffer, bytes);
    };
    // Buffers grow with the first use and stay: another mode gives nothing back until the scene changes.
    if (strength != FacingStrength::none)
        provide(boxes_, BINDING_FACING, arrays_.boxes().size() * sizeof(gpu::FacingRecord));
    if (strength == FacingStrength::rays)
        provide(rays_, BINDING_FACING_RAYS, arrays_.words().size() * sizeof(std::uint32_t));
    for (const auto& run : runs) {
        uploader_.write(boxes_, run.first, std::span(arrays_.boxes()).subspan(run.first, run.count));
        if (strength != FacingStrength::rays)
            continue;
        const auto words = arrays_.wordsOf(residents, run);
        uploader_.write(rays_, words.first, std::span(arrays_.words()).subspan(words.first, words.count));
    }
}

void FacingTable::listMemory(std::vector<HeldMemory>& to) const
{
    to.push_back({"facing", boxes_.bytes()});
    to.push_back({"facing rays", rays_.bytes()});
}

}  // namespace knotspan
