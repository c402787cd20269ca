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
        constexpr int most = 1024;
        int count = static_cast<int>(value);
        ImGui::SliderInt(name.c_str(), &count, 1, most, "%d", ImGuiSliderFlags_Logarithmic);
        return int64_t { std::clamp(count, 1, most) };
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
