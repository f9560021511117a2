#include "work/GrownView.h"

namespace stromar {

std::shared_ptr<const ViewModel> grownView(const CParams& params, const std::filesystem::path& folder, double age, const Detail& detail,
                                           const SizeLimits& limits, const CProgress& progress) {
    CTreeCreator creator(true, limits);
    creator.setAge(age);
    auto view = std::make_shared<ViewModel>();
    view->model = creator.create(params, detail, progress);
    view->parts = viewPartsOf(*view->model, {}, progress);
    makePictures(*view->model, folder, progress);
    for (const ViewPart& part : view->parts)
        view->surfaces[static_cast<std::size_t>(part.surface)] =
            readSurface(part.surface, textureOf(*view->model, part.surface, folder).string());
    return view;
}

} // namespace stromar
