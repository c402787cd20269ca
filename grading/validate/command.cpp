#include "grading/validate/command.h"
#include "grading/validate/folder.h"
#include "grading/validate/report.h"
#include "grading/validate/sample.h"
#include "submission/features.h"
#include <algorithm>

namespace grading {
namespace {

    // What a validation writes.
    struct RemovedAtEnd {
        ~RemovedAtEnd()
        {
            std::error_code gone;
            std::filesystem::remove_all(validationFolder(), gone);
        }
    };

    bool validateBank(const ValidationOptions& options, const std::shared_ptr<ExpectedAnswers>& expected,
        const OnProgress& onProgress)
    {
        Bank bank = loadBank(options.bank);
        if (options.sample > 0)
            bank = sampleOf(bank, options.sample);
        const GraderErrors errors = validate(bank, options.gradings, options.seed, expected, onProgress);
        onProgress("");
        printErrors(errors);
        return errors.none();
    }

    bool mutateReference(const ValidationOptions& options, const std::shared_ptr<ExpectedAnswers>& expected,
        const OnProgress& onProgress)
    {
        bool allKilled = true;
        for (const std::string& file : options.mutatedFiles.empty() ? submission::features : options.mutatedFiles) {
            const auto mutants = gradeMutants(file, expected, options.bank / "survivors.toml", onProgress);
            onProgress("");
            printMutants(file, mutants);
            allKilled &= std::ranges::count(mutants, Fate::Survived, &GradedMutant::fate) == 0;
        }
        return allKilled;
    }

}

bool runValidation(
    const ValidationOptions& options, const std::shared_ptr<ExpectedAnswers>& expected, const OnProgress& onProgress)
{
    const RemovedAtEnd folder;
    const bool right = !options.validate || validateBank(options, expected, onProgress);
    return (!options.mutate || mutateReference(options, expected, onProgress)) && right;
}

}
