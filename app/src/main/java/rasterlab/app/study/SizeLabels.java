package rasterlab.app.study;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.app.canvas.MethodColours;

/**
 * Sizes beside their points, none on another, on a point or on a line: each stands at the nearest
 * free place, and one without a free place near its point is left out.
 */
final class SizeLabels extends Annotation {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    /** Half the side of a point's marker and a little more, in pixels. */
    private static final int POINT = 7;

    /** Between two labels in a row, in pixels, so that they are not read as one number. */
    private static final int GAP = 3;

    /** Distances from the point that are tried, in pixels. */
    private static final int[] DISTANCES = {4, 12, 22};

    /** Directions that are tried, the best first: x to the right, y down. */
    private static final int[][] DIRECTIONS = {
        {0, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}
    };

    /**
     * @param cost on the chart's axis to the right
     * @param position on its axis upwards
     */
    record Point(double cost, double position) {}

    private record Label(String text, Point at, Color colour) {}

    private final List<List<Point>> lines = new ArrayList<>();
    private final List<Label> labels = new ArrayList<>();

    private final Color ground;

    /**
     * @param ground behind the chart
     */
    SizeLabels(Color ground) {
        super(false);
        this.ground = ground;
    }

    /** A line through marked points, which no label may hide. */
    void avoid(List<Point> line) {
        lines.add(List.copyOf(line));
    }

    void add(String size, Point at, Color colour) {
        labels.add(new Label(size, at, colour));
    }

    @Override
    public void paint(Graphics2D graphics) {
        graphics.setFont(FONT);
        var taken = new ArrayList<Rectangle>();
        for (List<Point> line : lines) line.forEach(point -> taken.add(marker(point)));
        List<Line2D> drawn = drawnLines();
        for (Label label : labels)
            place(label, graphics.getFontMetrics(), taken, drawn)
                    .ifPresent(
                            box -> {
                                taken.add(box);
                                draw(graphics, label, box);
                            });
    }

    private Rectangle marker(Point point) {
        var box = new Rectangle(x(point), y(point), 0, 0);
        box.grow(POINT, POINT);
        return box;
    }

    /** From each point of a line to its next. */
    private List<Line2D> drawnLines() {
        var drawn = new ArrayList<Line2D>();
        for (List<Point> line : lines)
            for (int i = 1; i < line.size(); i++) {
                Point from = line.get(i - 1);
                Point to = line.get(i);
                drawn.add(new Line2D.Double(x(from), y(from), x(to), y(to)));
            }
        return drawn;
    }

    private Optional<Rectangle> place(
            Label label, FontMetrics metrics, List<Rectangle> taken, List<Line2D> drawn) {
        int width = metrics.stringWidth(label.text());
        int height = metrics.getAscent();
        for (int distance : DISTANCES)
            for (int[] direction : DIRECTIONS) {
                int x = x(label.at()) + direction[0] * (POINT + distance + width / 2);
                int y = y(label.at()) + direction[1] * (POINT + distance + height / 2);
                var box = new Rectangle(x - width / 2, y - height / 2, width, height);
                var free = new Rectangle(box);
                free.grow(GAP, 0);
                if (inside(box)
                        && taken.stream().noneMatch(free::intersects)
                        && drawn.stream().noneMatch(free::intersectsLine)) return Optional.of(box);
            }
        return Optional.empty();
    }

    private boolean inside(Rectangle box) {
        int left = getXAxisScreenValueForMin();
        int right = getXAxisScreenValueForMax();
        int top = Math.min(getYAxisScreenValueForMin(), getYAxisScreenValueForMax());
        int bottom = Math.max(getYAxisScreenValueForMin(), getYAxisScreenValueForMax());
        return new Rectangle(left, top, right - left, bottom - top).contains(box);
    }

    private void draw(Graphics2D graphics, Label label, Rectangle box) {
        graphics.setColor(MethodColours.edgeOn(ground, label.colour()));
        graphics.drawString(label.text(), box.x, box.y + box.height - 2);
    }

    private int x(Point point) {
        return getXAxisScreenValue(point.cost());
    }

    private int y(Point point) {
        return getYAxisScreenValue(point.position());
    }
}
