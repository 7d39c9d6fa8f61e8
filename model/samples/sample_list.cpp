#include "model/samples/sample_list.h"

#include "model/samples/samples.h"

namespace knotspan {

const std::vector<Sample>& samples()
{
    static const std::vector<Sample> list{
        {"single-100", "A wavy sheet: one bicubic surface of 10 x 10 control points", makeSingle100},
        {"nine-16", "A patchwork: nine bicubic surfaces of 4 x 4 control points, creased", makeNine16},
        {"sphere", "An exact sphere: rational, degree 2, with two poles", makeSphere},
        {"torus", "An exact torus: rational, degree 2, closed both ways", makeTorus},
        {"hull", "A ship's hull: six bicubic surfaces, smooth but for keel and stem", makeHull},
        {"knot", "A bumpy trefoil tube: 600 bicubic surfaces, 15,000 KSQuads, all smooth", makeKnot},
        {"extremes", "Degree 9, knot spans over six and weights over eight orders, far from the origin",
         makeExtremes},
    };
    return list;
}

const Sample* findSample(const std::string& name)
{
    for (const Sample& sample : samples())
        if (sample.name == name)
            return &sample;
    return nullptr;
}

}  // namespace knotspan
