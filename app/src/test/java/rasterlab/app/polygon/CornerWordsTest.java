package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.ReadOut;

class CornerWordsTest {
    private static final Rectangle VIEW = new Rectangle(40, 20, 300, 200);
    private static final Rectangle LOWER_LEFT = new Rectangle(60, 170, 30, 30);
    private static final Rectangle UPPER_LEFT = new Rectangle(60, 40, 30, 30);
    private static final Rectangle UPPER_RIGHT = new Rectangle(290, 40, 30, 30);

    private final FontMetrics metrics =
            new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB)
                    .createGraphics()
                    .getFontMetrics(new Font(Font.DIALOG, Font.PLAIN, 20));

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("words leave their corner for nothing", true, true, List.of()),
                argumentSet("a handle is covered", true, false, List.of(LOWER_LEFT)),
                argumentSet(
                        "handles on the left are covered",
                        false,
                        false,
                        List.of(LOWER_LEFT, UPPER_LEFT)),
                argumentSet(
                        "words go up where they cover no less",
                        true,
                        true,
                        List.of(LOWER_LEFT, UPPER_LEFT, UPPER_RIGHT)));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void standWhereTheyCoverLeast(boolean left, boolean lower, List<Rectangle> taken) {
        var words = CornerWords.of("Wrong in 64 of 2,491 points in sight", VIEW, metrics, taken);
        assertEquals(left, words.place().x < 100, words.toString());
        assertEquals(lower, words.place().y > 100, words.toString());
        assertEquals(words.place(), words.place().intersection(VIEW));
    }

    @ParameterizedTest(name = "the coordinates under the mouse cover words of size {0}")
    @ValueSource(ints = {9, 13, 20, 26})
    void standAboveTheReadOut(int size) {
        var label = new Font(Font.DIALOG, Font.PLAIN, size);
        var readOut = new ReadOut();
        readOut.setFont(label);
        readOut.setText("(5.23, 5.47)");
        readOut.place(VIEW.y + VIEW.height);
        var words =
                CornerWords.of(
                        "Wrong at 64 of 2,491 points in sight",
                        VIEW,
                        readOut.getFontMetrics(label),
                        List.of());
        assertFalse(
                words.place().intersects(readOut.getBounds()),
                words.place() + " under " + readOut.getBounds());
    }
}
