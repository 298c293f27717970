package rasterlab.app.exercise.statement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.formula.Formulas;
import rasterlab.exercises.formula.TexFormula;
import rasterlab.exercises.formula.Typeset;

class StatementTest {
    private static final Image PICTURE = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);

    private final List<List<String>> drawn = new ArrayList<>();
    private final Formulas formulas = new Formulas();

    private Statement of(String markdown) {
        return new Statement(
                markdown,
                "en",
                new Statement.StatementPainter() {
                    @Override
                    public Image pixels(List<String> rows) {
                        drawn.add(rows);
                        return PICTURE;
                    }

                    @Override
                    public Optional<Image> picture(String name) {
                        return name.equals("there.png") ? Optional.of(PICTURE) : Optional.empty();
                    }

                    @Override
                    public Optional<Typeset> formula(TexFormula formula) {
                        return formulas.known(formula);
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
    void aFormulaThatIsNotSetYetIsItsSource() {
        Statement statement = of("Let $a<b$ be.");
        assertEquals(List.of(new TexFormula("a<b", false)), statement.formulas().awaited());
        assertTrue(statement.html().contains("Let $a&lt;b$ be."), statement.html());
    }

    @Test
    void aFormulaIsFoundByTheElementOfItsSource() {
        formulas.set(new TexFormula("a", false));
        formulas.set(new TexFormula("b", true));
        Statement statement = of("Let $a$ be\n\n$$\nb\n$$\n");
        assertEquals(List.of(), statement.formulas().awaited());
        assertEquals(Set.of("formula-0", "formula-1"), statement.formulas().drawn().keySet());
        String html = statement.html();
        assertTrue(html.contains("<span id=\"formula-0\">$a$</span>"), html);
        assertTrue(
                html.contains("<p class=\"displayed\"><span id=\"formula-1\">$$b$$</span></p>"),
                html);
    }

    @Test
    void aBrokenFormulaIsItsSourceWithANote() {
        formulas.set(new TexFormula("\\foo<b", false));
        String html = of("Let $\\foo<b$ be.\n\n$$\na\n\nrest").html();
        assertTrue(html.contains("<code>$\\foo&lt;b$</code>"), html);
        assertTrue(html.contains("(\\foo is not a command that is known here)"), html);
        assertTrue(html.contains("(the closing $$ is missing)"), html);
        assertTrue(html.contains("<p>rest</p>"), html);
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
