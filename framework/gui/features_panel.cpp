#include "files/feature_settings.h"
#include "gui/panels.h"
#include <framework/variant_helper.h>
#include <imgui.h>

namespace gui {
namespace {

    // Draws a control of the name and returns the value afterwards.
    files::FeatureValue edit(const std::string& name, bool value)
    {
        ImGui::Checkbox(name.c_str(), &value);
        return value;
    }

    files::FeatureValue edit(const std::string& name, int64_t value)
    {
        const auto range = files::countRange(name);
        const int least = static_cast<int>(range.least);
        const int most = static_cast<int>(std::min<int64_t>(range.most, 1024)); // what a window can be waited for
        int count = static_cast<int>(value);
        ImGui::SliderInt(name.c_str(), &count, least, most, "%d", least > 0 ? ImGuiSliderFlags_Logarithmic : 0);
        return int64_t { std::clamp(count, least, most) };
    }

    files::FeatureValue edit(const std::string& name, std::string value)
    {
        if (ImGui::BeginCombo(name.c_str(), value.c_str())) {
            for (const std::string& model : files::shadingModelNames())
                if (ImGui::Selectable(model.c_str(), model == value))
                    value = model;
            ImGui::EndCombo();
        }
        return value;
    }

}

void featuresPanel(Features& features)
{
    for (const std::string& name : files::featureNames()) {
        const files::FeatureValue before = files::featureValue(features, name);
        const files::FeatureValue after = std::visit([&](const auto& value) { return edit(name, value); }, before);
        if (after != before)
            files::setFeatureValue(features, name, after);
    }
}

}
