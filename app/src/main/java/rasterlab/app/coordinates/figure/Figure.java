package rasterlab.app.coordinates.figure;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;

/**
 * Marks in the order in which they are drawn.
 *
 * @param ruled whether the plane has coordinates of its own and is no view of space
 * @param taken places of the view where no labels stand if there is room elsewhere
 */
public record Figure(List<Mark> marks, boolean ruled, List<Rectangle> taken)
        implements PlanePicture {
    public Figure {
        marks = List.copyOf(marks);
        taken = List.copyOf(taken);
    }

    /** A figure with labels wherever they hide no lines. */
    public Figure(List<Mark> marks, boolean ruled) {
        this(marks, ruled, List.of());
    }

    @Override
    public PlanePicture leaving(List<Rectangle> labels) {
        return new Figure(marks, ruled, labels);
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        var painter = new FigurePainter(g, map, colors, marks, taken);
        for (Mark mark : marks) {
            if (cancelled.getAsBoolean()) throw new CancellationException();
            painter.paint(mark);
        }
    }
}
