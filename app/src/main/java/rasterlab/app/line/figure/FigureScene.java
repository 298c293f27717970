package rasterlab.app.line.figure;

import rasterlab.app.line.trace.LineMode;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.Ellipse;

/**
 * A figure and what draws it.
 *
 * @param method "" where the pen draws
 * @param comparison a second method, "" for none
 */
public record FigureScene(LineMode mode, DrawnFigure figure, String method, String comparison) {
    /**
     * @throws IllegalArgumentException for a segment, which has a lab of its own
     */
    static FigureScene first(LineMode mode) {
        return switch (mode) {
            case SEGMENT -> throw new IllegalArgumentException("a segment is no such figure");
            case CIRCLE ->
                    new FigureScene(mode, ArcFigure.of(new Circle(0, 0, 11)), "bresenham", "");
            case ELLIPSE ->
                    new FigureScene(mode, ArcFigure.of(new Ellipse(0, 0, 16, 9)), "bresenham", "");
            case PEN -> new FigureScene(mode, PenFigure.first(), "", "");
            case BRIGHTNESS ->
                    new FigureScene(mode, new SlopeFigure(30), "bresenham", "naive-textbook");
        };
    }

    FigureScene with(DrawnFigure other) {
        return new FigureScene(mode, other, method, comparison);
    }

    FigureScene withMethod(String other) {
        return new FigureScene(mode, figure, other, comparison);
    }

    FigureScene withComparison(String other) {
        return new FigureScene(mode, figure, method, other);
    }
}
