#include "grading/picture_judge.h"
#include "grading/tiles.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace grading {
namespace {

    using Outcome = Judgement::Outcome;
    using Colors = std::vector<glm::vec3>;

    // What a right solution may differ by: a share of what is expected, and a little everywhere. A ray that starts up
    // to 1e-3 of the scene beside another moves an edge by up to a tenth of a pixel: across a tile of 4 x 4 pixels that
    // is 2.5 % of its area, across one of 8 x 8 1.2 %. All are far above rounding.
    struct Level {
        int width; // of its tiles, in pixels
        double allowed; // relative
        double allowedAnywhere; // on top of it
        double found; // relative: this large a difference must not be missed
    };
    constexpr int wholePicture = 1 << 20;
    constexpr std::array<Level, 3> levels { {
        { wholePicture, 0.004, 0.0003, 0.01 }, { 8, 0.03, 0.004, 0.05 },
        { 4, 0.10, 0.02, 0.25 }, // four of the nine pixels of a black patch of 3 x 3 lie in one tile
    } };

    // Rare bright pixels: what few replicates see cannot be compared.
    constexpr double leastEffectiveSize = 10.0;

    // By so many standard deviations, the true difference is smaller than what must be found.
    constexpr double certainty = 3.0;

    bool isFinite(const glm::vec3& color)
    {
        return std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
    }

    Judgement different(std::string came, std::string expected)
    {
        return { Outcome::Different, std::move(came), std::move(expected) };
    }

    // Also what only a broken worker sends.
    std::optional<Judgement> judgeShape(const Replicates& came, const Replicates& expected)
    {
        const auto hasCount = [&](const Colors& tiles) { return tiles.size() == expected.tiles.front().size(); };
        if (came.size != expected.size || came.mean.size() != expected.mean.size()
            || came.tiles.size() != expected.tiles.size() || !std::ranges::all_of(came.tiles, hasCount))
            return different(fmt::format("a picture of {} x {} pixels", came.size.x, came.size.y),
                fmt::format("{} x {}", expected.size.x, expected.size.y));
        for (std::size_t i = 0; i < came.mean.size(); ++i) {
            const glm::ivec2 pixel { static_cast<int>(i) % came.size.x, static_cast<int>(i) / came.size.x };
            if (isFinite(came.mean[i]))
                continue;
            Judgement judgement = different(
                fmt::format("a colour that is no number at pixel ({}, {}) from the bottom left", pixel.x, pixel.y),
                "finite colours");
            judgement.worst = pixel;
            return judgement;
        }
        for (const Colors& tiles : came.tiles)
            if (!std::ranges::all_of(tiles, isFinite))
                return different("a colour that is no number", "finite colours");
        return std::nullopt;
    }

    bool varies(const Replicates& replicates)
    {
        return std::ranges::any_of(
            replicates.tiles, [&](const Colors& tiles) { return tiles != replicates.tiles.front(); });
    }

    bool isOneColor(const Replicates& replicates)
    {
        return std::ranges::all_of(
            replicates.mean, [&](const glm::vec3& color) { return color == replicates.mean.front(); });
    }

    // One channel of one tile.
    struct Comparison {
        Tile tile;
        Sample came, expected;
        Difference difference;
        double allowed = 0.0, found = 0.0;

        // Noise in which a wrong picture could hide. A right solution may draw its random numbers otherwise, share them
        // over a row, say: then a tile's mean varies up to eight times as much.
        [[nodiscard]] bool isTooNoisy() const
        {
            constexpr double most = 10.0;
            return deviationOfMean(came) > most * deviationOfMean(expected) + allowed;
        }
        [[nodiscard]] double size() const { return std::abs(difference.value) / allowed; }
        [[nodiscard]] bool isSame() const
        {
            return std::abs(difference.value) + certainty * difference.deviation <= found;
        }
    };

    std::string describe(const Comparison& c, glm::ivec2 pictureSize)
    {
        if (c.tile.size == pictureSize)
            return fmt::format("a mean of {:.4f} over the whole picture", c.came.mean);
        const glm::ivec2 last = c.tile.corner + c.tile.size - 1;
        return fmt::format("a mean of {:.3f} in the pixels ({}, {}) to ({}, {}) from the bottom left", c.came.mean,
            c.tile.corner.x, c.tile.corner.y, last.x, last.y);
    }

    std::optional<Comparison> compare(
        const Replicates& came, const Replicates& expected, const Tile& tile, const Level& level, int channel)
    {
        Comparison c { tile, sampleTile(came, tile, channel), sampleTile(expected, tile, channel), {} };
        if (c.expected.effectiveSize < leastEffectiveSize)
            return std::nullopt;
        c.difference = differenceOf(c.came, c.expected);
        c.allowed = level.allowed * std::abs(c.expected.mean) + level.allowedAnywhere;
        c.found = std::max(c.allowed, level.found * std::abs(c.expected.mean));
        return c;
    }

    // Keeps the outcome of all comparisons, and the worst place.
    class Judge {
    public:
        Judge(const Replicates& came, const Replicates& expected)
            : m_came(came)
            , m_expected(expected)
        {
        }

        void look(const Level& level, double significance)
        {
            const std::vector<Tile> tiles = tilesOf(m_expected.size, level.width);
            const double share = significance / static_cast<double>(3 * tiles.size()); // Bonferroni
            std::size_t numNoisy = 0;
            for (const Tile& tile : tiles)
                for (int channel = 0; channel < 3; ++channel)
                    if (const auto comparison = compare(m_came, m_expected, tile, level, channel)) {
                        add(*comparison, share);
                        numNoisy += comparison->isTooNoisy();
                        // One rare bright pixel makes a few tiles and the whole picture noisy, not a quarter of all.
                        if (comparison->isTooNoisy() && tiles.size() > 1 && 4 * numNoisy > 3 * tiles.size())
                            m_noisy = comparison;
                    }
        }

        [[nodiscard]] Judgement judgement() const
        {
            if (m_judgement.outcome == Outcome::Different || !m_noisy)
                return m_judgement;
            Judgement noisy = different(fmt::format("{}, give or take {:.3g}", describe(*m_noisy, m_expected.size),
                                            deviationOfMean(m_noisy->came)),
                fmt::format("{:.4f}, give or take {:.3g}", m_noisy->expected.mean, deviationOfMean(m_noisy->expected)));
            noisy.worst = m_noisy->tile.centre();
            return noisy;
        }

    private:
        void add(const Comparison& c, double share)
        {
            if (c.tile.size != m_expected.size && c.size() > m_worst) {
                m_worst = c.size();
                m_judgement.worst = c.tile.centre();
            }
            const bool isDifferent = chanceOf(c.difference, c.allowed) < share;
            if (!isDifferent && !c.isSame() && m_judgement.outcome == Outcome::Same)
                m_judgement.outcome = Outcome::Undecided;
            if (isDifferent && c.size() > m_worstDifferent) {
                m_worstDifferent = c.size();
                m_judgement.outcome = Outcome::Different;
                m_judgement.came = describe(c, m_expected.size);
                m_judgement.expected = fmt::format("{:.4f}, give or take {:.4f}", c.expected.mean, c.allowed);
            }
        }

        const Replicates& m_came;
        const Replicates& m_expected;
        Judgement m_judgement;
        std::optional<Comparison> m_noisy;
        double m_worst = 0.0; // in units of what is allowed
        double m_worstDifferent = 0.0;
    };

}

Judgement judgePictures(const Replicates& came, const Replicates& expected, double significance)
{
    if (const std::optional<Judgement> misshapen = judgeShape(came, expected))
        return *misshapen;
    if (varies(expected) && !varies(came) && !isOneColor(came))
        return different("the same picture for every seed: the sampler was ignored",
            "one that depends on the random numbers of the RenderState's sampler");
    Judge judge { came, expected };
    for (const Level& level : levels)
        judge.look(level, significance / static_cast<double>(levels.size()));
    return judge.judgement();
}

}
