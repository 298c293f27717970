package rasterlab.engine.pipeline.fast;

/** A triangle whose pixels are looked for, so turned that its area is positive. */
abstract class Scan {
    /** The corners' numbers. */
    int a;

    int b;
    int c;

    /** Whether the triangle turns its inner side to the eye. */
    boolean fromBehind;

    /** 1 / area. */
    float inverseArea;

    /** The growth of eB and eC from a pixel to the next on its right. */
    long stepB;

    long stepC;

    /** The growth of eB and eC from a pixel to the next below. */
    long downB;

    long downC;
}
