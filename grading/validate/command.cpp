#include "grading/validate/command.h"
#include "grading/validate/folder.h"
#include "grading/validate/report.h"
#include "grading/validate/sample.h"
#include "submission/features.h"
#include "submission/folder_lock.h"
#include <algorithm>

namespace grading {
namespace {

    bool validateBank(const ValidationOptions& options, const Assignment& setting, const OnProgress& onProgress)
    {
        Bank bank = loadBank(options.bank);
        if (options.sample > 0)
            bank = sampleOf(bank, options.sample);
        const GraderErrors errors = validate(bank, options.gradings, setting, onProgress);
        onProgress("");
        printErrors(errors);
        return errors.none();
    }

    bool mutateReference(const ValidationOptions& options, const Assignment& setting, const OnProgress& onProgress)
    {
        bool allKilled = true;
        for (const std::string& file : options.mutatedFiles.empty() ? submission::features : options.mutatedFiles) {
            const auto mutants = gradeMutants(file, setting, options.bank / "survivors.toml", onProgress);
            onProgress("");
            printMutants(file, mutants);
            allKilled &= std::ranges::count(mutants, Fate::Survived, &GradedMutant::fate) == 0;
        }
        return allKilled;
    }

}

bool runValidation(const ValidationOptions& options, const Assignment& setting, const OnProgress& onProgress)
{
    std::filesystem::create_directories(validationFolder());
    onProgress("waiting for another validation to end"); // which writes to the same folders
    const submission::FolderLock lock { validationFolder() };
    const bool right = !options.validate || validateBank(options, setting, onProgress);
    return (!options.mutate || mutateReference(options, setting, onProgress)) && right;
}

}
