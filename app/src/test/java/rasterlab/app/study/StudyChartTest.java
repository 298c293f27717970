package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XYChart;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.language.Language;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

class StudyChartTest {
    @Test
    void exactResultsStandBelowEveryRealError() {
        List<Measurement> points =
                List.of(point("dda", 0), point("naive", 0), point("bresenham", 0.25));
        ErrorAxis axis = ErrorAxis.over(points);
        double dda = axis.position(points.get(0));
        double naive = axis.position(points.get(1));
        assertTrue(axis.bottom() < naive && naive < dda, "one lane each");
        assertTrue(dda < axis.border() && axis.border() <= 0.25, "below the border");
        assertEquals(0.25, axis.position(points.get(2)));
        assertTrue(axis.top() > 0.25);
    }

    @Test
    void labelsAreWordsAndPlainNumbers() {
        ErrorAxis axis = ErrorAxis.over(List.of(point("dda", 0), point("naive", 2000)));
        assertEquals("0 (exact)", axis.label(axis.bottom(), "0 (exact)"));
        assertEquals("1000", axis.label(1000, ""));
        assertEquals("1e7", axis.label(1e7, ""));
    }

    @Test
    void chartUsesTheMethodsColourAndSurvivesMethodsWithoutTime() {
        var endless =
                new Measurement(
                        "naive-textbook",
                        "w",
                        16,
                        Cost.NONE,
                        Deviation.NONE,
                        Verdict.Kind.ENDLESS,
                        "");
        BufferedImage chart =
                StudyChart.image(
                        new Study("line", "pixel", "pixels", List.of(point("dda", 3), endless)),
                        Language.ENGLISH);
        assertTrue(has(chart, MethodColours.of("dda").getRGB()), "colour of dda");
        StudyChart.image(new Study("line", "pixel", "pixels", List.of(endless)), Language.ENGLISH);
    }

    @Test
    void russianChartHasNoEnglishWords() {
        var study =
                new Study(
                        "line",
                        "pixel",
                        "pixels",
                        List.of(
                                untimed(16, Verdict.Kind.REFUSED),
                                untimed(64, Verdict.Kind.REFUSED),
                                untimed(256, Verdict.Kind.CRASHED)));
        var words = new StudyWords(Language.RUSSIAN);
        assertEquals(
                List.of("Не измерено:", "dda", "   отказ при 16, 64", "   сбой при 256"),
                new LeftOutNote(study, words, 0, 0).lines());
        String svg = new String(StudyChart.svg(study, Language.RUSSIAN), StandardCharsets.UTF_8);
        var texts = Pattern.compile(">([^<]*[a-zA-Z]{3}[^<]*)<").matcher(svg);
        List<String> english = texts.results().map(found -> found.group(1).strip()).toList();
        assertEquals(Set.of("dda"), Set.copyOf(english));
        XYChart chart = StudyChart.chart(study, words);
        assertEquals("Скорость и точность: тема line", chart.getTitle());
        assertTrue(chart.getXAxisTitle().startsWith("цена: наносекунд на пиксель"));
        assertEquals("наибольшая ошибка, пиксели", chart.getYAxisTitle());
    }

    private static Measurement untimed(int size, Verdict.Kind kind) {
        return new Measurement("dda", "w", size, Cost.NONE, Deviation.NONE, kind, "");
    }

    private static boolean has(BufferedImage image, int rgb) {
        for (int y = 0; y < image.getHeight(); y++)
            for (int x = 0; x < image.getWidth(); x++) if (image.getRGB(x, y) == rgb) return true;
        return false;
    }

    private static Measurement point(String method, double error) {
        var deviation = new Deviation(error, 0, 0, 10, "");
        return new Measurement(
                method, "w", 16, new Cost(2, 1, 3, Map.of()), deviation, Verdict.Kind.EXACT, "");
    }
}
