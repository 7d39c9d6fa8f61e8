#include "model/mesh_files/vtp_file.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include "model/mesh_files/mesh_building.h"

namespace knotspan::formats {

namespace {

// VTK would say what it thinks of a file on standard error.
void silence()
{
    vtkObject::GlobalWarningDisplayOff();
}

void addPolygons(vtkCellArray* cells, bool strips, MeshBuilding& building)
{
    std::vector<std::uint32_t> corners;
    const auto polygons = vtk::TakeSmartPointer(cells->NewIterator());
    for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType* points = nullptr;
        polygons->GetCurrentCell(count, points);
        corners.clear();
        for (vtkIdType k = 0; k < count; ++k) {
            if (points[k] < 0 || points[k] >= static_cast<vtkIdType>(building.vertices()))
                throw Error{"A polygon names a vertex that is not there", {}, "Export the mesh again"};
            corners.push_back(static_cast<std::uint32_t>(points[k]));
        }
        for (size_t k = 2; strips && k < corners.size(); ++k) {
            std::uint32_t triangle[] = {corners[k - 2], corners[k - 1], corners[k]};
            if (k % 2 == 1)
                std::swap(triangle[0], triangle[1]);
            building.polygon(triangle);
        }
        if (!strips && corners.size() > 2)
            building.polygon(corners);
    }
}

}  // namespace

Result<void> writeVtp(const std::filesystem::path& path, const TriangleMesh& mesh)
{
    silence();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (size_t k = 0; k < mesh.vertices.size(); ++k)
        points->SetPoint(static_cast<vtkIdType>(k), &mesh.vertices[k].x);
    vtkNew<vtkCellArray> triangles;
    triangles->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
                             static_cast<vtkIdType>(3 * mesh.triangles.size()));
    for (const auto& [a, b, c] : mesh.triangles)
        triangles->InsertNextCell(
            {static_cast<vtkIdType>(a), static_cast<vtkIdType>(b), static_cast<vtkIdType>(c)});
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(triangles);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    if (writer->Write() != 1 || writer->GetErrorCode() != vtkErrorCode::NoError)
        return failure("The file cannot be written", "Make room on the disk, or choose another place");
    return {};
}

Result<TriangleMesh> readVtp(const std::filesystem::path& path)
{
    silence();
    vtkNew<vtkXMLPolyDataReader> reader;
    if (reader->CanReadFile(path.c_str()) == 0)
        return failure("The file is no VTP", "Choose another file");
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    if (reader->GetErrorCode() != vtkErrorCode::NoError || data == nullptr || data->GetPoints() == nullptr)
        return failure("The file is damaged", "Export or copy the mesh again");
    try {
        MeshBuilding building;
        for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) {
            double position[3];
            data->GetPoint(k, position);
            building.vertex({position[0], position[1], position[2]});
        }
        addPolygons(data->GetPolys(), false, building);
        addPolygons(data->GetStrips(), true, building);
        return building.take();
    } catch (const Error& error) {
        return tl::unexpected(error);
    }
}

}  // namespace knotspan::formats
