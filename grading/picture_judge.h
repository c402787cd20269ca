#pragma once
#include "grading/replicates.h"
#include <string>

namespace grading {

// Of one look at a submission's pictures.
struct Judgement {
    enum class Outcome { Same, Different, Undecided };

    Outcome outcome = Outcome::Same;
    std::string came, expected; // where it is Different
    glm::ivec2 worst { 0 }; // the pixel in the middle of the tile that differs most, for what a tile is allowed
};

// Judges pictures by their means over tiles, of the whole picture, of 8 x 8 and of 4 x 4 pixels. Each level allows a
// difference that a right solution may have, because its rays start a little elsewhere; the pictures are Different
// where chance would exceed it with less than the given probability, all tiles, channels and levels together, and Same
// where no difference can be so large that it must be found. More samples decide what is Undecided.
//
// Pictures of another size, colours that are no numbers, and one picture for all seeds are Different.
[[nodiscard]] Judgement judgePictures(const Replicates& came, const Replicates& expected, double significance);

}
