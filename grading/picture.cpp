#include "grading/picture.h"
#include "grading/expect.h"
#include "grading/picture_judge.h"
#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>
#include <span>

namespace grading {
namespace {

    constexpr std::size_t numReplicates = 32;

    // Rays a pixel and replicate. Most pictures are decided by the first; squares, as strata want them.
    constexpr std::array<int, 3> stages { 4, 16, 64 };

    // How often in all a right solution may lose a point by chance, over the pictures that a whole grade compares, or a
    // few more, and their stages.
    constexpr int mostPictures = 16;
    constexpr double significance = 1e-4 / (mostPictures * stages.size());

    std::vector<uint32_t> randomSeeds(Random& random)
    {
        std::vector<uint32_t> seeds(numReplicates);
        for (uint32_t& seed : seeds)
            seed = random.seed();
        return seeds;
    }

    // The same for every submission, so that the answers can be kept.
    std::vector<uint32_t> referenceSeeds()
    {
        std::vector<uint32_t> seeds(numReplicates);
        std::iota(seeds.begin(), seeds.end(), 1u);
        return seeds;
    }

    struct Asked {
        ReplicatesRequest request;
        const worker::Message& more;
    };

    worker::Message& operator<<(worker::Message& message, const Asked& asked)
    {
        message << asked.request;
        message.append(asked.more.bytes().data(), asked.more.bytes().size());
        return message;
    }

    void append(Replicates& all, const Replicates& part, std::size_t numParts)
    {
        if (all.tiles.empty())
            all = { part.size, std::vector<glm::vec3>(part.mean.size()), {} };
        expect(part.size == all.size && part.mean.size() == all.mean.size(), "a picture with another seed",
            "one of another size", "the same size");
        for (std::size_t i = 0; i < part.mean.size(); ++i)
            all.mean[i] += part.mean[i] / static_cast<float>(numParts);
        all.tiles.insert(all.tiles.end(), part.tiles.begin(), part.tiles.end());
    }

    // ask(probe, Asked) -> Replicates of `perQuestion` seeds.
    template <typename Ask>
    Replicates render(const PictureQuestion& picture, int raysPerPixel, std::span<const uint32_t> seeds,
        std::size_t perQuestion, const Ask& ask)
    {
        Asked asked { picture.request, picture.more };
        asked.request.settings.push_back({ "pixel_samples", std::to_string(raysPerPixel) });
        Replicates all;
        for (std::size_t first = 0; first < seeds.size(); first += perQuestion) {
            const auto some = seeds.subspan(first, perQuestion);
            asked.request.seeds.assign(some.begin(), some.end());
            append(all, ask(picture.probe, asked), seeds.size() / perQuestion);
        }
        return all;
    }

    // A later stage asks for fewer pictures at once, so that a worker takes about as long over every question.
    Replicates renderSubmission(Exam& exam, const PictureQuestion& picture, int raysPerPixel)
    {
        const auto perQuestion
            = numReplicates * static_cast<std::size_t>(stages.front()) / static_cast<std::size_t>(raysPerPixel);
        return render(picture, raysPerPixel, randomSeeds(exam.random), perQuestion,
            [&](const std::string& probe, const Asked& asked) { return exam.ask<Replicates>(probe, asked); });
    }

    Replicates renderReference(Exam& exam, const PictureQuestion& picture, int raysPerPixel)
    {
        return render(picture, raysPerPixel, referenceSeeds(), numReplicates,
            [&](const std::string& probe, const Asked& asked) { return exam.askReference<Replicates>(probe, asked); });
    }

    // Whatever a submission's pictures may lead to.
    void askReferenceForAll(Exam& exam, const std::vector<PictureQuestion>& valid)
    {
        for (const PictureQuestion& picture : valid)
            for (const int raysPerPixel : stages)
                (void)renderReference(exam, picture, raysPerPixel);
    }

    // One that a submission's pictures were compared with.
    struct Rival {
        PictureQuestion picture;
        Replicates expected;
        Judgement judgement;
    };

    using Outcome = Judgement::Outcome;
    Outcome outcomeOf(const Rival& rival)
    {
        return rival.judgement.outcome;
    }

    std::vector<Rival> compare(
        Exam& exam, const Replicates& came, const std::vector<PictureQuestion>& valid, int raysPerPixel)
    {
        std::vector<Rival> rivals;
        for (const PictureQuestion& picture : valid) {
            Replicates expected = renderReference(exam, picture, raysPerPixel);
            const Judgement judgement = judgePictures(came, expected, significance);
            rivals.push_back({ picture, std::move(expected), judgement });
        }
        return rivals;
    }

    std::shared_ptr<const PicturePair> pairOf(const Replicates& came, const Rival& rival)
    {
        if (came.mean.size() != rival.expected.mean.size())
            return nullptr; // not to be shown side by side
        return std::make_shared<PicturePair>(
            PicturePair { rival.expected.size, came.mean, rival.expected.mean, rival.judgement.worst });
    }

    [[noreturn]] void reject(const Rival& rival)
    {
        throw Wrong(std::filesystem::path(rival.picture.request.scene).filename().string(), rival.judgement.came,
            rival.judgement.expected);
    }

}

PictureQuestion pictureOf(const std::string& scene, std::vector<Setting> settings)
{
    settings.insert(settings.begin(), { "jittered_sampling", "true" });
    return { "render.replicates",
        { .scene = "scenes/" + scene + ".toml", .settings = std::move(settings), .size = { 64, 64 }, .seeds = {} },
        {} };
}

void comparePicture(Exam& exam, const PictureQuestion& picture)
{
    comparePicture(exam, picture, { picture });
}

void comparePicture(Exam& exam, const PictureQuestion& picture, const std::vector<PictureQuestion>& valid)
{
    if (exam.wantsAllAnswers())
        askReferenceForAll(exam, valid);
    std::vector<PictureQuestion> left = valid;
    for (const int raysPerPixel : stages) {
        const Replicates came = renderSubmission(exam, picture, raysPerPixel);
        const std::vector<Rival> rivals = compare(exam, came, left, raysPerPixel);
        const auto same = std::ranges::find(rivals, Outcome::Same, outcomeOf);
        exam.pictures = pairOf(came, same == rivals.end() ? rivals.front() : *same);
        if (same != rivals.end())
            return;
        left.clear();
        for (const Rival& rival : rivals)
            if (outcomeOf(rival) == Outcome::Undecided)
                left.push_back(rival.picture);
        if (left.empty())
            reject(rivals.front());
    }
    // Still undecided: in favour of the submission.
}

}
