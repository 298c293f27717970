/**
 * What every lab shares: the stage's zoomed pixel grid, the step player, hazard chips, the colour
 * of each method, and pictures made in the background.
 *
 * <p>Names carry the space: {@code pixel} counts raster pixels, x right and y down, whole numbers
 * at pixel centres; {@code view} is Swing's coordinates inside the stage; {@code device} counts the
 * screen's own dots. Start at {@link rasterlab.app.canvas.LabLayout}.
 */
package rasterlab.app.canvas;
