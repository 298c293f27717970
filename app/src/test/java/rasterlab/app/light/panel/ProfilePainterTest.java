package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ProfilePainterTest {
    @ParameterizedTest(name = "numbers and names of the axes are cut off in type of {0}")
    @ValueSource(ints = {9, 12, 16, 18, 24, 32})
    void axesHaveTheRoomThatTheirTypeNeeds(int size) {
        FontMetrics metrics =
                new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)
                        .createGraphics()
                        .getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, size));
        Rectangle2D box = ProfilePainter.box(800, 300, metrics, Locale.forLanguageTag("ru"));
        assertTrue(box.getX() >= metrics.stringWidth("0,75") + 8, "left of the axis: " + box);
        double below = 300 - box.getMaxY();
        assertTrue(below >= metrics.getAscent() + 3 + metrics.getDescent(), "below: " + box);
    }

    @ParameterizedTest(name = "no curve fits below the pictures in lines of {0}")
    @ValueSource(ints = {15, 17, 23, 25, 30})
    void smallStageKeepsRoomForPicturesAndCurves(int line) {
        int height = 280;
        var plan = new StagePlan(370, height, line);
        // Above the curves names, below them the ends: a line of type each, and what is around it.
        int curves = plan.profile().height - 2 * line - 18;
        assertTrue(curves >= 2 * line, "curves are high by " + curves);
        assertTrue(plan.picture(0).height >= 0.3 * height, "picture: " + plan.picture(0));
        assertTrue(plan.profile().y + plan.profile().height <= height, "out of sight");
    }
}
