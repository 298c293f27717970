package rasterlab.app.light;

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
}
