#include "model/geometry/primitives.h"
#include "model/samples/net.h"
#include "model/samples/samples.h"

namespace knotspan {

Scene makeSphere()
{
    Scene scene;
    scene.add(namedObject("Sphere", colourOf(24, 0.55, 0.9), sphere(Vec3(0), 1)));
    return scene;
}

Scene makeTorus()
{
    Scene scene;
    scene.add(namedObject("Torus", colourOf(165, 0.45, 0.8), torus(Vec3(0), 2, 0.75)));
    return scene;
}

}  // namespace knotspan
