// Which eyes each KSQuad of a scene faces away from (shaders/shared/facing_forms.glsl), kept up with the
// model: all of it when first asked for, then what control points moved. In memory; FacingTable sends it.
//
// Of a surface that moves again and again, as under the hand, boxes are only made when it rests: until then
// what moved is known to face away from nowhere, so that nothing is dropped that shows.
#pragma once

#include "renderer/scene/bezier_nets.h"
#include "renderer/scene/facing_forms.h"
#include "renderer/scene/resident_changes.h"

namespace knotspan {

// How closely KSQuads are known, and what that takes: nothing, 16 bytes each, or 3 bytes more for each of
// their (3 p - 1) (3 q - 1) rays.
enum class FacingStrength { none, box, rays };

class FacingArrays {
public:
    // `origins`: of a Bezier packing each KSQuad's own control points count, otherwise the surface's.
    enum class Origins { surfaceNets, bezierNets };

    // KSQuads that lie beside each other.
    struct Run {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    // What was made anew. The rays of KSQuad k start at firstWord(resident, k). `log`: of the residents;
    // null: all are compared.
    std::vector<Run> update(const std::vector<Resident>& residents, Origins origins, FacingStrength strength,
                            const ResidentChanges* log = nullptr);
    void clear() { *this = {}; }

    [[nodiscard]] FacingStrength strength() const { return strength_; }
    [[nodiscard]] const std::vector<gpu::FacingRecord>& boxes() const { return boxes_; }
    [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }
    // Where the words of a run start, and how many they are.
    [[nodiscard]] Run wordsOf(const std::vector<Resident>& residents, const Run& ksquads) const;

private:
    struct Held {
        SharedObject object;
        PointFrame frame;
        bool moved = false;                // with the last update
        std::vector<std::uint32_t> later;  // KSQuads to be made when it rests
    };
    // Of one resident: KSQuads by their numbers within it.
    struct Task {
        std::uint32_t resident = 0;
        std::vector<std::uint32_t> make;
        std::vector<std::uint32_t> forget;
        std::vector<std::uint32_t> changed;  // both, increasing
    };
    [[nodiscard]] std::vector<Task> tasks(const std::vector<Resident>& residents,
                                          std::optional<std::span<const std::uint32_t>> logged) const;
    // The KSQuads that are to be made anew.
    [[nodiscard]] static std::vector<std::uint32_t> staleOf(const Resident& resident, const Held& held);
    void plan(const Resident& resident, Held& held, Task& task) const;
    void make(const Resident& resident, Origins origins, const std::vector<std::uint32_t>& numbers);

    FacingStrength strength_ = FacingStrength::none;
    Origins origins_ = Origins::surfaceNets;
    std::vector<Held> held_;
    std::vector<std::uint32_t> moving_;  // residents that moved with the last update
    ResidentChanges::Moment seen_ = 0;   // of the log
    std::vector<gpu::FacingRecord> boxes_;
    std::vector<std::uint32_t> words_;
};

}  // namespace knotspan
