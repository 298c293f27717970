package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class StatementTest {
    private final List<List<String>> drawn = new ArrayList<>();

    private Statement of(String markdown) {
        return new Statement(
                markdown,
                rows -> {
                    drawn.add(rows);
                    return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
                });
    }

    @Test
    void rowsOfPixelsBecomeAPicture() {
        Statement statement = of("Example:\n\n    ##..\n    ..##\n");
        assertEquals(List.of(List.of("##..", "..##")), drawn);
        assertEquals(1, statement.pictures().size());
        assertTrue(statement.html().contains("<img"), statement.html());
    }

    @Test
    void codeStaysCode() {
        String html = of("    void draw(int x);\n").html();
        assertEquals(List.of(), drawn);
        assertTrue(html.contains("<pre>void draw(int x);</pre>"), html);
    }

    @Test
    void rowsOfDifferentLengthsAreNoPicture() {
        of("    ##..\n    ..#\n");
        assertEquals(List.of(), drawn);
    }

    @Test
    void tablesAreTables() {
        String html = of("| for | points |\n|---|---|\n| accuracy | 70 |\n").html();
        assertTrue(html.contains("<td>70</td>"), html);
    }

    @Test
    void markupOfTheAuthorIsText() {
        String html = of("<img src='http://example.org/x.png'> <b>x</b>").html();
        assertFalse(html.contains("<img"), html);
        assertFalse(html.contains("<b>"), html);
    }
}
