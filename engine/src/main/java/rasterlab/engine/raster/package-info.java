/**
 * Pixels and where they go: the picture itself and the recording of every write.
 *
 * <p>Pixel coordinates: whole numbers name pixel centres, x grows to the right, y grows down. Start
 * with {@link rasterlab.engine.raster.Raster}.
 */
package rasterlab.engine.raster;
