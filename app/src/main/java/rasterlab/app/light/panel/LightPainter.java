package rasterlab.app.light.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Texts;
import rasterlab.app.light.Lamp;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightFrame;

/** Draws the three pictures with what lies over them. */
final class LightPainter {
    /** One for each shading, the same in the profile. */
    static final List<Color> COLORS =
            List.of(MethodColors.ORANGE, MethodColors.SKY_BLUE, MethodColors.GREEN);

    private static final Stroke WIDE = new BasicStroke(4f, 1, 1);
    private static final Stroke THIN = new BasicStroke(1.6f, 1, 1);
    private static final Stroke ARROW = new BasicStroke(1.1f, 1, 1);

    private final Graphics2D g;
    private final Texts texts;
    private final LightFrame.DrawnFrame drawn;
    private final LightChoice choice;
    private final double scale;

    /**
     * @param choice the present one, maybe newer than the pictures
     * @param scale device pixels per view unit
     */
    LightPainter(
            Graphics2D g,
            Texts texts,
            LightFrame.DrawnFrame drawn,
            LightChoice choice,
            double scale) {
        this.g = g;
        this.texts = texts;
        this.drawn = drawn;
        this.choice = choice;
        this.scale = scale;
    }

    void paint(StagePlan plan) {
        for (int i = 0; i < drawn.pictures().size(); i++) paintPicture(i, plan.picture(i));
        Rectangle below = plan.profile();
        var under = (Graphics2D) g.create(below.x, below.y, below.width, below.height);
        new ProfilePainter(under, texts, drawn).paint(below.width, below.height);
        under.dispose();
    }

    /** Draws a ring about a point of the world, in each picture. */
    void ring(double[] world, StagePlan plan) {
        double[] at = drawn.places().toPicture(world[0], world[1], world[2]);
        for (int i = 0; i < drawn.pictures().size(); i++) {
            Rectangle box = plan.picture(i);
            var over = (Graphics2D) g.create(box.x, box.y, box.width, box.height);
            over.setRenderingHint(
                    RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            var ring = new Ellipse2D.Double(at[0] / scale - 9, at[1] / scale - 9, 18, 18);
            over.setStroke(WIDE);
            over.setColor(Color.BLACK);
            over.draw(ring);
            over.setStroke(new BasicStroke(2f));
            over.setColor(StageColors.DARK.focus());
            over.draw(ring);
            over.dispose();
        }
    }

    private void paintPicture(int index, Rectangle box) {
        LightFrame.ShadedPicture picture = drawn.pictures().get(index);
        var over = (Graphics2D) g.create(box.x, box.y, box.width, box.height);
        DevicePixels.paint((Graphics2D) over.create(), picture.raster().image());
        over.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        over.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        if (index > 0) arrows(over, drawn.rightArrows(), MethodColors.SKY_BLUE);
        arrows(over, index == 0 ? drawn.faceArrows() : drawn.cornerArrows(), MethodColors.YELLOW);
        String name = texts.text("shading." + picture.name());
        over.setFont(over.getFont().deriveFont(Font.BOLD));
        FontMetrics bold = over.getFontMetrics();
        var plate =
                EndLabel.corner(
                        box.getSize(),
                        bold.stringWidth(name) + 8,
                        bold.getHeight() + 1,
                        lamps(box));
        over.setFont(over.getFont().deriveFont(Font.PLAIN));
        line(over, box, plate);
        for (int i = 0; i < choice.lamps().size(); i++) lamp(over, i, box);
        point(over, box);
        over.setFont(over.getFont().deriveFont(Font.BOLD));
        Color color = COLORS.get(index);
        Plates.plate(
                over,
                name,
                plate.x + 4,
                plate.y + 1 + over.getFontMetrics().getAscent(),
                color,
                MethodColors.inkOn(color));
        over.dispose();
    }

    private void arrows(Graphics2D over, double[] ends, Color color) {
        over.setStroke(ARROW);
        for (int at = 0; at < ends.length; at += 4) {
            double x = ends[at + 2] / scale;
            double y = ends[at + 3] / scale;
            over.setColor(color);
            over.draw(new Line2D.Double(ends[at] / scale, ends[at + 1] / scale, x, y));
            over.fill(new Ellipse2D.Double(x - 1.6, y - 1.6, 3.2, 3.2));
        }
    }

    private Point2D at(LightGrip.LightGripKind kind, int index, Rectangle box) {
        return LightGrips.at(new LightGrip(kind, index), drawn, choice, box);
    }

    private void line(Graphics2D over, Rectangle box, Rectangle plate) {
        Point2D from = at(LightGrip.LightGripKind.FROM, 0, box);
        Point2D to = at(LightGrip.LightGripKind.TO, 0, box);
        var line = new Line2D.Double(from, to);
        over.setStroke(WIDE);
        over.setColor(new Color(0, 0, 0, 140));
        over.draw(line);
        over.setStroke(THIN);
        over.setColor(Color.WHITE);
        over.draw(line);
        List<Point2D> lamps = lamps(box);
        end(over, from, "A", lamps, plate);
        end(over, to, "B", lamps, plate);
    }

    private List<Point2D> lamps(Rectangle box) {
        return IntStream.range(0, choice.lamps().size())
                .mapToObj(lamp -> at(LightGrip.LightGripKind.LAMP, lamp, box))
                .toList();
    }

    private static void end(
            Graphics2D over, Point2D at, String name, List<Point2D> lamps, Rectangle plate) {
        var square = new Rectangle((int) at.getX() - 5, (int) at.getY() - 5, 10, 10);
        over.setColor(Color.WHITE);
        over.fill(square);
        over.setColor(Color.BLACK);
        over.draw(square);
        FontMetrics metrics = over.getFontMetrics();
        Rectangle place =
                EndLabel.place(
                        at, metrics.stringWidth(name) + 8, metrics.getHeight() + 1, lamps, plate);
        Plates.plate(
                over,
                name,
                place.x + 4,
                place.y + 1 + metrics.getAscent(),
                new Color(255, 255, 255, 225),
                Color.BLACK);
    }

    /** Draws a cross in a ring, where the formula is shown in numbers. */
    private void point(Graphics2D over, Rectangle box) {
        Point2D at = at(LightGrip.LightGripKind.POINT, 0, box);
        var ring = new Ellipse2D.Double(at.getX() - 7, at.getY() - 7, 14, 14);
        for (boolean wide : new boolean[] {true, false}) {
            over.setStroke(wide ? WIDE : THIN);
            over.setColor(wide ? Color.BLACK : Color.WHITE);
            over.draw(ring);
            over.draw(new Line2D.Double(at.getX() - 3, at.getY(), at.getX() + 3, at.getY()));
            over.draw(new Line2D.Double(at.getX(), at.getY() - 3, at.getX(), at.getY() + 3));
        }
    }

    /** Draws a disc of its colour with rays, numbered; hollow when it is off. */
    private void lamp(Graphics2D over, int index, Rectangle box) {
        Lamp lamp = choice.lamps().get(index);
        Point2D at = at(LightGrip.LightGripKind.LAMP, index, box);
        boolean selected = index == choice.selected();
        double radius = selected ? 10 : 9;
        over.setStroke(selected ? new BasicStroke(2.4f) : THIN);
        Color frame = selected ? StageColors.DARK.focus() : Color.WHITE;
        for (int ray = 0; ray < 8; ray++) {
            double angle = ray * Math.PI / 4;
            double x = Math.cos(angle);
            double y = Math.sin(angle);
            over.setColor(frame);
            if (lamp.on())
                over.draw(
                        new Line2D.Double(
                                at.getX() + (radius + 2) * x,
                                at.getY() + (radius + 2) * y,
                                at.getX() + (radius + 5) * x,
                                at.getY() + (radius + 5) * y));
        }
        var disc =
                new Ellipse2D.Double(
                        at.getX() - radius, at.getY() - radius, 2 * radius, 2 * radius);
        Color fill = lamp.on() ? new Color(lamp.rgb()) : new Color(0x303438);
        over.setColor(fill);
        over.fill(disc);
        over.setColor(frame);
        over.draw(disc);
        String number = Integer.toString(index + 1);
        over.setColor(MethodColors.inkOn(fill));
        over.setFont(over.getFont().deriveFont(Font.BOLD));
        float width = over.getFontMetrics().stringWidth(number);
        over.drawString(
                number,
                (float) at.getX() - width / 2,
                (float) at.getY() + over.getFontMetrics().getAscent() / 2f - 1);
    }
}
