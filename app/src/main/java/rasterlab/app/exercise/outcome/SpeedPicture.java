package rasterlab.app.exercise.outcome;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.Optional;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.study.front.SpeedChart;

/** A program's point on its topic's chart, painted anew for each place and each theme. */
public final class SpeedPicture implements PaintedPicture {
    /** The kind of this picture; no case has one of it. */
    static final String KIND = "chart";

    /** The shape of a place, across and down. */
    static final Dimension SHAPE = new Dimension(24, 16);

    /** A chart in a smaller place is painted so large in its own units, and made smaller. */
    private static final Dimension LEAST = new Dimension(600, 400);

    private final SpeedChart chart;
    private Optional<Painted> painted = Optional.empty();

    private record SpeedPictureLook(Dimension place, double dots, StageColors colors) {}

    private record Painted(SpeedPictureLook asked, BufferedImage image) {}

    public SpeedPicture(SpeedChart chart) {
        this.chart = chart;
    }

    public String inWords() {
        return chart.inWords();
    }

    @Override
    public void paint(Graphics2D g, Rectangle part, Rectangle place) {
        var asked =
                new SpeedPictureLook(
                        place.getSize(),
                        Math.max(1, g.getTransform().getScaleX()),
                        StageColors.now());
        if (painted.filter(one -> one.asked().equals(asked)).isEmpty())
            painted = Optional.of(new Painted(asked, image(asked)));
        g.drawImage(painted.get().image(), place.x, place.y, place.width, place.height, null);
    }

    private BufferedImage image(SpeedPictureLook asked) {
        Dimension place = asked.place();
        double type =
                Math.min(
                        UIScale.getUserScaleFactor(),
                        Math.min(
                                (double) place.width / LEAST.width,
                                (double) place.height / LEAST.height));
        var image =
                new BufferedImage(
                        (int) Math.ceil(place.width * asked.dots()),
                        (int) Math.ceil(place.height * asked.dots()),
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setColor(asked.colors().ground());
        graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
        graphics.scale(asked.dots() * type, asked.dots() * type);
        var size =
                new Dimension(
                        (int) Math.round(place.width / type),
                        (int) Math.round(place.height / type));
        chart.paint(ChartLook.on(asked.colors()), size, graphics);
        graphics.dispose();
        return image;
    }
}
