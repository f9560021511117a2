#include "stromar/tree/SizeBound.h"
#include <algorithm>
#include <numeric>

namespace stromar {

double SizeBound::stems() const {
    double sum = 0;
    for (const GenerationBound& g : generations) sum += g.stems;
    return sum;
}

double SizeBound::segments() const {
    double sum = 0;
    for (const GenerationBound& g : generations) sum += g.stems * g.segments;
    return sum;
}

double SizeBound::organCount() const { return std::accumulate(organs.begin(), organs.end(), 0.0); }

double SizeBound::bytes() const {
    double sum = 0, largest = 0;
    for (const GenerationBound& g : generations) {
        const double each = sizeof(CStem) + scratchPerStem + g.paths * (sizeof(CPath) + sizeof(double)) +
                            g.segments * (sizeof(CSegment) + scratchPerSegment);
        sum += g.stems * each;
        largest = std::max(largest, g.stems * each);
    }
    return sum + largest;
}

} // namespace stromar
