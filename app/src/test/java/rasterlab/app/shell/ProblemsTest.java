package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;

class ProblemsTest {
    @Test
    void noticeIsNoWiderThanTheSmallestWindow() {
        FontMetrics metrics =
                new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB)
                        .createGraphics()
                        .getFontMetrics(new Font(Font.DIALOG, Font.PLAIN, 12));
        String said =
                Problem.of("labs.oneNotUsed", "/home/student/labs.json", "line", "it is missing")
                        .in(Language.RUSSIAN);
        String lines = Problems.lines(List.of(said, "short"), metrics);
        assertTrue(metrics.stringWidth(said) > 600, "too short to be wrapped");
        lines.lines().forEach(line -> assertTrue(metrics.stringWidth(line) <= 600, line));
        assertEquals(said + " short", lines.replace('\n', ' '), "words are lost");
        assertTrue(lines.endsWith("\nshort"), "two problems in one line");
    }
}
