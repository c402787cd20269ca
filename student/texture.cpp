// Looking up an image: texCoord in [0, 1]^2 spans the whole of it.
//
// Texel (i, j) covers the square [i, i+1) x [j, j+1) of texCoord * (width, height), so its centre is at
// (i + 0.5, j + 0.5). It is read by image.get_pixel(j * image.width + i), as a colour in [0, 1]. Row 0 is the row
// that v = 0 addresses: nothing is flipped here. Coordinates beyond the edge take the texels of the edge.
//
// To read: Marschner and Shirley, "Fundamentals of Computer Graphics", chapter "Texture Mapping"; Pharr, Jakob and
// Humphreys, "Physically Based Rendering" (4th edition), 10.4 "Image Texture".
#include "texture.h"
#include "not_written_yet.h"

#pragma GCC diagnostic ignored "-Wunused-parameter" // delete this line when the whole file is written

// The colour of the texel that covers texCoord.
//
// - texCoord 1 is the end of the last texel: multiplied by the width it gives an index that does not exist.
// - A conversion to int cuts towards 0, so that -0.3 and 0.3 give the same number; std::floor does not.
// - Clamp row and column by themselves: a wrong column must not spill into the next row.
// - Count indices in int: a float has no odd numbers above 2^24, and large images have more texels than that.
glm::vec3 sampleTextureNearest(const Image& image, const glm::vec2& texCoord)
{
    notWrittenYet("sampleTextureNearest"); // delete this line when the function is written
    return image.get_pixel(0);
}

// The four texels whose centres surround texCoord, blended linearly in x and in y: with fractions (a, b) of the way
// from the lower left centre, their weights are (1 - a)(1 - b), a(1 - b), (1 - a)b and ab.
//
// - Centres lie at half-integers: exactly at a centre the result is that texel's colour, halfway between two centres
//   it is their mean. Try both on paper.
// - Near the edge some of the four do not exist. Clamp the texels' indices, after the fractions are known.
// - An image may be one texel wide.
glm::vec3 sampleTextureBilinear(const Image& image, const glm::vec2& texCoord)
{
    notWrittenYet("sampleTextureBilinear"); // delete this line when the function is written
    return image.get_pixel(0);
}
