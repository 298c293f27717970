/**
 * All that a student's own method may see: one small interface per topic and the values it passes.
 * A method only reads what it is given, but for what its contract lets it replace or fill.
 *
 * <p>Pixels, of lines, circles, ellipses, curves, fills and {@code PixelGrid}: whole numbers name
 * centres, x grows to the right, y down. Any plane, y up: {@code PlaneRotation}, {@code
 * Triangulator}, {@code SegmentClipper}, {@code PolygonClipper}; either way: {@code
 * PointInTriangle}, {@code PointInPolygon}. Space is right-handed, points are rows: {@code
 * AxisRotation}, {@code MatrixFormula}, {@code PointTransformer}; seen from the eye it is
 * left-handed, z forward: {@code EyeView}, {@code VolumeClipper}. Start with {@link
 * rasterlab.contract.LineRasterizer}.
 */
package rasterlab.contract;
