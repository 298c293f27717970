package rasterlab.app.coordinates.figure;

import java.awt.Graphics2D;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColours;

/**
 * Marks in the order in which they are drawn.
 *
 * @param ruled whether the plane has coordinates of its own and is no view of space
 */
public record Figure(List<Mark> marks, boolean ruled) implements PlanePicture {
    public Figure {
        marks = List.copyOf(marks);
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColours colours, BooleanSupplier cancelled) {
        var painter = new FigurePainter(g, map, colours);
        for (Mark mark : marks) {
            if (cancelled.getAsBoolean()) throw new CancellationException();
            painter.paint(mark);
        }
    }
}
