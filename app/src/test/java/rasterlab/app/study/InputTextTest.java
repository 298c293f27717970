package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.Topics;
import rasterlab.engine.line.Segment;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

class InputTextTest {
    private static final Texts ENGLISH = Texts.of("study", Language.ENGLISH);
    private static final Texts RUSSIAN = Texts.of("study", Language.RUSSIAN);

    /** The English names of inputs that have no words in a bundle. */
    private static final Pattern LEFT_IN_ENGLISH =
            Pattern.compile(
                    "\\d (polygons?|faces?|lines?|corners?|knots?|places?|points?|rows?|pixels?)\\b|"
                            + " (seen|flatness|connectivity|about|in|of) ");

    private record Pair(String name, List<double[]> points) {}

    @Test
    void recordsAreWrittenByTheirComponents() {
        assertEquals(
                "name = a\npoints = [[1.0, 2.5]]",
                InputText.of(new Pair("a", List.of(new double[] {1, 2.5})), ENGLISH));
    }

    @Test
    void recordThatSpeaksForItselfIsLeftToIt() {
        assertEquals("(1, 2)→(3, 4)", InputText.of(new Segment(1, 2, 3, 4), ENGLISH));
    }

    @Test
    void longListsAreCutWithTheirLength() {
        String text = InputText.of(IntStream.range(0, 1000).boxed().toList(), ENGLISH);
        assertTrue(text.endsWith("23, … (1000)]"), text);
    }

    @Test
    void noInputOfAnyHazardIsShownByItsAddress() {
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards()) {
                String text = InputText.of(hazard.input(), ENGLISH);
                assertFalse(
                        text.matches("(?s).*(\\[[DIJ]|[a-z]\\.[A-Z]\\w*)@[0-9a-f]+.*"),
                        topic.name() + ", " + hazard.name() + ": " + text);
            }
    }

    @Test
    void inputsSpeakTheWindowsLanguage() {
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards()) {
                String text = InputText.of(hazard.input(), RUSSIAN);
                assertFalse(
                        LEFT_IN_ENGLISH.matcher(text).find(),
                        topic.name() + ", " + hazard.name() + ": " + text);
            }
    }

    /** The constants are in words but for names of matrices, which are formulas. */
    @Test
    void constantsAreWrittenInWords() {
        var constant = Pattern.compile("\\b[A-Z][A-Z_]{2,}\\b");
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards()) {
                String text = InputText.of(hazard.input(), RUSSIAN);
                assertFalse(
                        !topic.name().equals("matrix") && constant.matcher(text).find(),
                        topic.name() + ", " + hazard.name() + ": " + text);
            }
        assertEquals(
                "4 вершины, правило чётности, на изображении 8×6",
                InputWords.translated(RUSSIAN, "4 corners, EVEN_ODD, in 8×6 pixels"));
        assertEquals(
                "3 knots, not-a-knot ends, 2 places",
                InputWords.translated(ENGLISH, "3 knots, NOT_A_KNOT, 2 places"));
    }

    @Test
    void countsStandBeforeTheRightForm() {
        assertEquals(
                "1 polygon seen from [0.0]",
                InputWords.translated(ENGLISH, "1 polygons seen from [0.0]"));
        assertEquals(
                "1 многоугольник из точки [0.0]",
                InputWords.translated(RUSSIAN, "1 polygons seen from [0.0]"));
        assertEquals(
                "22 многоугольника из точки [0.0]",
                InputWords.translated(RUSSIAN, "22 polygons seen from [0.0]"));
        assertEquals(
                "11 многоугольников из точки [0.0]",
                InputWords.translated(RUSSIAN, "11 polygons seen from [0.0]"));
    }
}
