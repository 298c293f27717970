package rasterlab.app.canvas;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * The picture that a plane shows between its grid and its points: an immutable scene that any
 * thread may paint. It has {@code equals}, so that the same picture is not painted twice: a record
 * is best.
 */
public interface PlanePicture {
    /**
     * @param g antialiased, in view units; its font is that of a label
     * @param cancelled asked often by a long picture
     * @throws CancellationException soon after {@code cancelled} says true
     */
    void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled);

    /** Whether grid, rulers and read-out belong to it: not where the plane is a view of space. */
    default boolean ruled() {
        return true;
    }

    /** World units between two lines of the grid, at least: 1 where only whole pixels are meant. */
    default double leastTick() {
        return 0;
    }

    /**
     * The lines that labels of points leave clear where there is room, in view units.
     *
     * @param view what is seen
     */
    default List<Line2D> lines(PlaneMap map, Rectangle view) {
        return List.of();
    }

    /**
     * Lit and marked pixels, which labels of points leave clear where there is room, in view units.
     *
     * @param view what is seen
     */
    default List<Rectangle2D> pixels(PlaneMap map, Rectangle view) {
        return List.of();
    }

    /**
     * This picture with what may stand elsewhere out of the labels' way.
     *
     * @param labels places of the view
     */
    default PlanePicture leaving(List<Rectangle> labels) {
        return this;
    }
}
