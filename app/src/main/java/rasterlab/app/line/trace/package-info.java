/**
 * The parts that every mode of the lab of lines needs: the pixels that a method lit in their order,
 * those it lit beside the exact ones, and the methods' colours. Coordinates are raster pixels, x
 * right and y down. Start reading at {@link LineTrace}.
 */
package rasterlab.app.line.trace;
