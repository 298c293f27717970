package rasterlab.app.line;

/** A place on the raster, y down; whole numbers are pixel centres. */
public record Spot(double x, double y) {}
