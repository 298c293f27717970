/**
 * Circles, ellipses, lines of a pen and the brightness of lines: the figures that the lab draws
 * beside segments. Coordinates are raster pixels, x right and y down. Start reading at {@link
 * FigureLabModel}, which knows no Swing.
 */
package rasterlab.app.line.figure;
