#include "io/ExportedModels.h"
#include "stromar/app/Formats.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace stromar::test {

TEST(Readers, EveryFormatIsReadBackByAForeignProgram) {
    for (const Format& format : formatTable()) {
        const auto reads = [&](const ForeignReader& reader) {
            return std::ranges::find(reader.endings, format.ending) != reader.endings.end();
        };
        EXPECT_TRUE(reads(kAssimp) || reads(kOsg) || reads(kPovRay) || reads(kThree)) << "no test reads " << format.ending << " back";
    }
}

TEST(Readers, TheSamplesShowMuch) {
    EXPECT_GT(sampleModel("tupelo").triangleCount(), 200'000u);
    for (const SampleModel& sample : sampleModels()) {
        EXPECT_GE(sample.model->stems.size(), 3u) << sample.name;
        EXPECT_GT(sample.model->leaves()->triangleCount(), 0u) << sample.name;
    }
    EXPECT_LT(sampleModel("small").triangleCount(), 10'000u);
}

} // namespace stromar::test
