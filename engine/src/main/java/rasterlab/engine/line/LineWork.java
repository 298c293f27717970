package rasterlab.engine.line;

import rasterlab.engine.raster.Work;

/**
 * The work of a method to choose a line's pixels.
 *
 * @param start once for the line
 * @param pixel at every pixel
 * @param across besides, at every step that goes across
 */
public record LineWork(Work start, Work pixel, Work across) {}
