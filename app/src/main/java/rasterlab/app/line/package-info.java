/**
 * The lab of the topic {@code line}: a segment drawn pixel by pixel beside the exact line.
 *
 * <p>Coordinates are raster pixels, x right and y down. {@link rasterlab.app.line.LineLabModel}
 * holds what is shown and knows no Swing; {@link rasterlab.app.line.LinePanel} shows it.
 */
package rasterlab.app.line;
