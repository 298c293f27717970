package rasterlab.engine.circle;

import rasterlab.engine.raster.Work;

/**
 * The work of a method to choose pixels; what it computes once for the whole curve is left out.
 *
 * @param choice at every choice
 * @param functions sines, cosines and square roots among it
 * @param aside besides, at every step aside
 * @param down besides, at every step down
 */
public record ArcWork(Work choice, int functions, Work aside, Work down) {}
