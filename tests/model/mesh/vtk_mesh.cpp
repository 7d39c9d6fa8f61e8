#include "tests/model/mesh/vtk_mesh.h"

#include <cmath>

#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkGLTFReader.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <vtkXMLPolyDataReader.h>

namespace knotspan::testing {

namespace {

void append(TriangleMesh& mesh, vtkPolyData* data)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k) {
        double position[3];
        data->GetPoint(k, position);
        mesh.vertices.emplace_back(position[0], position[1], position[2]);
    }
    vtkNew<vtkIdList> corners;
    for (vtkIdType k = 0; k < data->GetNumberOfCells(); ++k) {
        data->GetCellPoints(k, corners);
        if (corners->GetNumberOfIds() == 3)
            mesh.triangles.push_back({first + static_cast<std::uint32_t>(corners->GetId(0)),
                                      first + static_cast<std::uint32_t>(corners->GetId(1)),
                                      first + static_cast<std::uint32_t>(corners->GetId(2))});
    }
}

template <class Reader>
TriangleMesh readBy(const std::filesystem::path& file)
{
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    TriangleMesh mesh;
    append(mesh, reader->GetOutput());
    return mesh;
}

TriangleMesh readGltf(const std::filesystem::path& file)
{
    vtkNew<vtkGLTFReader> reader;
    reader->SetFileName(file.c_str());
    reader->ApplyDeformationsToGeometryOn();
    reader->Update();
    TriangleMesh mesh;
    const auto parts = vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
    for (parts->InitTraversal(); parts->IsDoneWithTraversal() == 0; parts->GoToNextItem())
        if (auto* data = vtkPolyData::SafeDownCast(parts->GetCurrentDataObject()))
            append(mesh, data);
    return mesh;
}

}  // namespace

TriangleMesh vtkMeshOf(const std::filesystem::path& file)
{
    vtkObject::GlobalWarningDisplayOff();
    const std::string extension = file.extension().string();
    return extension == ".vtp"   ? readBy<vtkXMLPolyDataReader>(file)
           : extension == ".stl" ? readBy<vtkSTLReader>(file)
           : extension == ".ply" ? readBy<vtkPLYReader>(file)
           : extension == ".obj" ? readBy<vtkOBJReader>(file)
                                 : readGltf(file);
}

struct VtkDistances::Locator {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkStaticCellLocator> cells;
    vtkNew<vtkGenericCell> cell;
};

VtkDistances::VtkDistances(const TriangleMesh& mesh) : locator_(std::make_unique<Locator>())
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& vertex : mesh.vertices)
        points->InsertNextPoint(&vertex.x);
    vtkNew<vtkCellArray> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles->InsertNextCell(
            {static_cast<vtkIdType>(a), static_cast<vtkIdType>(b), static_cast<vtkIdType>(c)});
    locator_->data->SetPoints(points);
    locator_->data->SetPolys(triangles);
    locator_->cells->SetDataSet(locator_->data);
    locator_->cells->BuildLocator();
}

VtkDistances::~VtkDistances() = default;

double VtkDistances::to(const Vec3& point)
{
    double closest[3];
    vtkIdType cell = -1;
    int part = 0;
    double squared = 0;
    locator_->cells->FindClosestPoint(&point.x, closest, locator_->cell, cell, part, squared);
    return std::sqrt(squared);
}

}  // namespace knotspan::testing
