/**
 * Drawing a straight segment: the methods of one contract and the exact answer they are held to.
 *
 * <p>Pixel coordinates: whole numbers name pixel centres, x grows to the right, y grows down. In
 * formulas n is the number of steps along the longer axis, i the steps made along it and j those
 * made across it. Start with {@link rasterlab.engine.line.BresenhamLine}; {@link
 * rasterlab.engine.line.LineTopic} lists everything.
 */
package rasterlab.engine.line;
