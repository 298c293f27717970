package rasterlab.app.polygon.figure;

/**
 * A figure and what works on it: all that an answer depends on.
 *
 * @param comparison a second method, "" for none
 */
public record PolygonScene(
        PolygonMode mode, PolygonFigure figure, String method, String comparison) {
    /** Opens on a method that no hazard is known to break. */
    public static PolygonScene first(PolygonMode mode) {
        return switch (mode) {
            case TRIANGLE -> new PolygonScene(mode, InsideFigure.firstTriangle(), "robust", "");
            case POLYGON -> new PolygonScene(mode, InsideFigure.firstPolygon(), "robust", "");
            case TRIANGULATION -> new PolygonScene(mode, CutFigure.first(), "ear-clipping", "");
            case FILL -> new PolygonScene(mode, FillFigure.first(), "scanline", "");
            case SEED -> new PolygonScene(mode, SeedFigure.first(), "span", "");
        };
    }

    public PolygonScene with(PolygonFigure other) {
        return new PolygonScene(mode, other, method, comparison);
    }

    public PolygonScene withMethod(String other) {
        return new PolygonScene(mode, figure, other, comparison);
    }

    public PolygonScene withComparison(String other) {
        return new PolygonScene(mode, figure, method, other);
    }
}
