package rasterlab.app.study.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.app.canvas.method.MethodColors;

/**
 * Sizes beside their points, none on another or on a point: each as close to its point as there is
 * room, and where that is not close, with a line to it.
 */
final class SizeLabels extends Annotation {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    /** Share of the label's ink in the line to it, before that is made to stand out. */
    private static final double LEADER = 0.5;

    /**
     * @param cost on the chart's axis to the right
     * @param position on its axis upwards
     */
    record SizePoint(double cost, double position) {}

    private record Label(String text, SizePoint at, Color color) {}

    private final List<List<SizePoint>> lines = new ArrayList<>();
    private final List<Double> edges = new ArrayList<>();
    private final List<Label> labels = new ArrayList<>();

    private final Color ground;

    /**
     * @param ground behind the chart
     */
    SizeLabels(Color ground) {
        super(false);
        this.ground = ground;
    }

    /** Adds a line through marked points, which no label may hide. */
    void avoid(List<SizePoint> line) {
        lines.add(List.copyOf(line));
    }

    /** Adds a line across the chart at a place of its axis upwards, likewise. */
    void avoidEdge(double position) {
        edges.add(position);
    }

    void add(String size, SizePoint at, Color color) {
        labels.add(new Label(size, at, color));
    }

    @Override
    public void paint(Graphics2D graphics) {
        graphics.setFont(FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        List<Optional<LabelPlaces.LabelPlace>> places =
                LabelPlaces.of(
                        inside(),
                        markers(),
                        drawnLines(),
                        labels.stream().map(label -> measured(label, metrics)).toList());
        for (int i = 0; i < labels.size(); i++) {
            Label label = labels.get(i);
            places.get(i).ifPresent(place -> draw(graphics, label, place));
        }
    }

    private LabelPlaces.PointLabel measured(Label label, FontMetrics metrics) {
        return new LabelPlaces.PointLabel(
                seen(label.at()),
                new Dimension(metrics.stringWidth(label.text()), metrics.getAscent()));
    }

    private List<java.awt.Point> markers() {
        return lines.stream().flatMap(List::stream).map(this::seen).toList();
    }

    /** The lines from each point of a curve to its next, and the edges. */
    private List<Line2D> drawnLines() {
        var drawn = new ArrayList<Line2D>();
        Rectangle all = inside();
        for (double edge : edges) {
            int y = getYAxisScreenValue(edge);
            drawn.add(new Line2D.Double(all.getMinX(), y, all.getMaxX(), y));
        }
        for (List<SizePoint> line : lines)
            for (int i = 1; i < line.size(); i++)
                drawn.add(new Line2D.Double(seen(line.get(i - 1)), seen(line.get(i))));
        return drawn;
    }

    private Rectangle inside() {
        int left = getXAxisScreenValueForMin();
        int right = getXAxisScreenValueForMax();
        int top = Math.min(getYAxisScreenValueForMin(), getYAxisScreenValueForMax());
        int bottom = Math.max(getYAxisScreenValueForMin(), getYAxisScreenValueForMax());
        return new Rectangle(left, top, right - left, bottom - top);
    }

    private void draw(Graphics2D graphics, Label label, LabelPlaces.LabelPlace place) {
        Color ink = MethodColors.textOn(ground, label.color());
        graphics.setColor(MethodColors.edgeOn(ground, MethodColors.mix(ground, ink, LEADER)));
        graphics.setStroke(new BasicStroke(1));
        place.leader().ifPresent(graphics::draw);
        graphics.setColor(ink);
        Rectangle box = place.box();
        graphics.drawString(label.text(), box.x, box.y + box.height - 2);
    }

    private java.awt.Point seen(SizePoint point) {
        return new java.awt.Point(
                getXAxisScreenValue(point.cost()), getYAxisScreenValue(point.position()));
    }
}
