#pragma once
#include "grading/exam.h"
#include "grading/replicates.h"
#include <string>
#include <vector>

namespace grading {

// How a check has its picture rendered. The seeds and the number of rays a pixel are the judge's to choose.
struct PictureQuestion {
    std::string probe;
    ReplicatesRequest request;
    worker::Message more; // what the probe reads after the request
};

// A scene of that name, small, with stratified rays, so that the pixels along an edge are shades.
[[nodiscard]] PictureQuestion pictureOf(const std::string& scene, std::vector<Setting> settings = {});

// Has the picture rendered by the submission and by the reference, each often and with random numbers of its own, and
// throws Wrong where the means differ by more than a right solution's may and more than chance explains. A right
// solution fails any of a whole grade's pictures by chance once in 10,000 times.
void comparePicture(Exam& exam, const PictureQuestion& picture);

// The same where several answers are valid: those that the reference gives to each of these questions, the usual one
// first.
void comparePicture(Exam& exam, const PictureQuestion& picture, const std::vector<PictureQuestion>& valid);

}
