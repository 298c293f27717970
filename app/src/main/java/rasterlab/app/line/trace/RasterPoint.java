package rasterlab.app.line.trace;

/** A place on the raster, y down; whole numbers are pixel centres. */
public record RasterPoint(double x, double y) {}
