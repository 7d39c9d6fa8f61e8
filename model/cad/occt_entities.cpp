#include "model/cad/occt_entities.h"

#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>

namespace knotspan::formats {

ShapeEntities::ShapeEntities(const Handle(XSControl_WorkSession) & session)
{
    const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
    if (process.IsNull())
        return;
    for (int k = 1; k <= process->NbMapped(); ++k) {
        const Handle(Standard_Transient) entity = process->Mapped(k);
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        if (!shape.IsNull())
            entities_[shape.TShape().get()].push_back(entity);
    }
}

const std::vector<Handle(Standard_Transient)>& ShapeEntities::of(const TopoDS_Shape& shape) const
{
    static const std::vector<Handle(Standard_Transient)> kNone;
    const auto found = entities_.find(shape.TShape().get());
    return found == entities_.end() ? kNone : found->second;
}

}  // namespace knotspan::formats
