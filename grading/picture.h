#pragma once
#include "grading/exam.h"
#include "worker/render_request.h"
#include <string>
#include <vector>

namespace grading {

// How a check renders: small, on one thread, with 4 x 4 rays a pixel, so that the pixels along an edge are shades
// rather than coin tosses that a right solution may lose.
[[nodiscard]] worker::RenderRequest pictureOf(const std::string& scene, std::vector<std::string> settings = {});

// Throws Wrong unless the pictures agree: same size, finite, no 8 x 8 tile differs by more than a few edge pixels.
void expectSamePicture(
    const worker::RenderRequest& request, const worker::Rendering& came, const worker::Rendering& expected);

// Renders the scene by both workers, and compares. The submission's worker has its file for the graded feature and the
// reference's for all else, so the camera rays are the same.
void comparePictures(Exam& exam, const worker::RenderRequest& request);

// The same for pictures that depend on random numbers: renders each several times with other seeds, and throws Wrong
// where the means of a tile differ by more than chance and more than can be seen.
void compareNoisyPictures(Exam& exam, const worker::RenderRequest& request);

}
