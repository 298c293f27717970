/**
 * All that a student's own method may see: one small interface per topic and the values it passes.
 *
 * <p>Coordinates are pixel coordinates: whole numbers name pixel centres, x grows to the right, y
 * grows down. Start with {@link rasterlab.contract.LineRasterizer}.
 */
package rasterlab.contract;
