package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class StatementTest {
    private static final Image PICTURE = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);

    private final List<List<String>> drawn = new ArrayList<>();

    private Statement of(String markdown) {
        return new Statement(
                markdown,
                new Statement.Painter() {
                    @Override
                    public Image pixels(List<String> rows) {
                        drawn.add(rows);
                        return PICTURE;
                    }

                    @Override
                    public Optional<Image> picture(String name) {
                        return name.equals("there.png") ? Optional.of(PICTURE) : Optional.empty();
                    }
                });
    }

    @Test
    void pictureOfTheExerciseIsShown() {
        Statement statement = of("See ![a *thin* line](there.png).");
        assertEquals(List.of(PICTURE), List.copyOf(statement.pictures().values()));
        String address = statement.pictures().keySet().iterator().next().toString();
        assertTrue(statement.html().contains("src=\"" + address + "\""), statement.html());
        assertTrue(statement.html().contains("alt=\"a thin line\""), statement.html());
    }

    @Test
    void pictureThatIsNotThereGivesWayToItsWords() {
        for (String place : List.of("gone.png", "http://localhost/x.png", "file:/x.png")) {
            Statement statement = of("See ![a & b](" + place + ").");
            assertTrue(statement.pictures().isEmpty());
            assertFalse(statement.html().contains("<img"), statement.html());
            assertTrue(statement.html().contains("[a &amp; b]"), statement.html());
        }
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
