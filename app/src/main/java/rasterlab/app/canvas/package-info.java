/**
 * What every lab shares: stages (a zoomed pixel grid, a plane), the step player, hazard chips, the
 * colour of each method, and pictures made in the background.
 *
 * <p>Names carry the space: {@code pixel} counts raster pixels, x right and y down, whole numbers
 * at pixel centres; {@code world} is a plane's real coordinates; {@code view} is Swing's inside the
 * stage; {@code device} counts the screen's own dots. Start at {@link LabLayout}.
 */
package rasterlab.app.canvas;
