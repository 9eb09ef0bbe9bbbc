// A program around Resynthesizer's engine, for pairs.py: reads an exemplar, writes a larger texture made of it.
//
//     resynthesizer EXEMPLAR.ppm SIDE OUT.ppm        (colour, 8 bits, binary PPM)
//
// The engine's one call takes a single picture: the square to be made lies above, the exemplar below it.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glibProxy.h"
#include "imageSynth.h"

enum { kChannels = 3, kSelected = 255 };

static void fail(const char* what)
{
    fprintf(stderr, "resynthesizer: %s\n", what);
    exit(1);
}

static unsigned char* readPpm(const char* path, unsigned* width, unsigned* height)
{
    FILE* file = fopen(path, "rb");
    if (!file || fscanf(file, "P6 %u %u 255", width, height) != 2 || fgetc(file) == EOF)
        fail("the exemplar is not a binary PPM file of 8 bits");
    const size_t bytes = (size_t)*width * *height * kChannels;
    unsigned char* data = malloc(bytes);
    if (!data || fread(data, 1, bytes, file) != bytes)
        fail("the exemplar ends early");
    fclose(file);
    return data;
}

static void writePpm(const char* path, const unsigned char* data, unsigned side)
{
    FILE* file = fopen(path, "wb");
    if (!file)
        fail("the result cannot be written");
    fprintf(file, "P6\n%u %u\n255\n", side, side);
    fwrite(data, kChannels, (size_t)side * side, file);
    fclose(file);
}

static ImageBuffer empty(unsigned width, unsigned height, unsigned channels)
{
    ImageBuffer buffer = {calloc((size_t)width * height, channels), width, height, (size_t)width * channels};
    return buffer;
}

static void report(int percent, void* context)
{
    (void)percent;
    (void)context;
}

int main(int argc, char** argv)
{
    if (argc != 4)
        fail("usage: resynthesizer EXEMPLAR.ppm SIDE OUT.ppm");
    unsigned width, height;
    unsigned char* exemplar = readPpm(argv[1], &width, &height);
    const unsigned side = (unsigned)atoi(argv[2]);
    if (side < width)
        fail("the side is smaller than the exemplar's");

    ImageBuffer picture = empty(side, side + height, kChannels);
    ImageBuffer made = empty(side, side + height, 1);
    ImageBuffer source = empty(side, side + height, 1);
    memset(made.data, kSelected, (size_t)side * side);
    for (unsigned y = 0; y < height; ++y) {
        memcpy(picture.data + (side + y) * picture.rowBytes, exemplar + (size_t)y * width * kChannels, (size_t)width * kChannels);
        memset(source.data + (side + y) * source.rowBytes, kSelected, width);
    }
    TImageSynthParameters parameters;
    setDefaultParams(&parameters);
    parameters.matchContextType = 0; // nothing lies around the square
    int cancelled = 0;
    if (imageSynth2(&picture, &made, &source, T_RGB, &parameters, report, NULL, &cancelled) != 0)
        fail("the engine refused the picture");
    writePpm(argv[3], picture.data, side);
    return 0;
}
