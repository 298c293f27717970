package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;

@Timeout(300)
class LineReadingsTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LineLabModel model =
            new LineLabModel(new LineTopic(), Runnable::run, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @ParameterizedTest(name = "the decision seems to be about the other pixel: {0}, {1}")
    @CsvSource({
        "naive, ENGLISH, 1 (this pixel)",
        "naive, RUSSIAN, 1 (этот пиксель)",
        "bresenham, ENGLISH, −1 (next pixel)",
        "bresenham, RUSSIAN, −1 (следующий пиксель)"
    })
    void saysWhichPixelTheDecisionIsAbout(String method, Language language, String reading)
            throws InterruptedException {
        model.chooseMethod(method);
        model.show(new Segment(0, 0, 8, 4));
        model.settle();
        model.goTo(3);
        var readings = new LineReadings(model.state(), Texts.of("line", language));
        assertEquals(reading, readings.decision());
    }

    @ParameterizedTest(name = "pixels that differ are miscounted: {0} and {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "bresenham | midpoint | none",
                "naive-textbook | bresenham | 6: 0 + 6",
                "wu | wu | none",
                "bresenham | wu | 16: 8 + 8"
            })
    void countsThePixelsThatOneMethodHasAlone(String chosen, String second, String reading)
            throws InterruptedException {
        model.chooseMethod(chosen);
        model.compareWith(second);
        model.show(new Segment(0, 0, 4, 10));
        model.settle();
        var readings = new LineReadings(model.state(), Texts.of("line", Language.ENGLISH));
        assertEquals(reading, readings.apart());
    }

    @ParameterizedTest(name = "the last step speaks of a next pixel: {0}")
    @CsvSource({"bresenham, –", "midpoint, –", "naive, 4 (this pixel)"})
    void lastStepDecidesNothingAboutANextPixel(String method, String reading)
            throws InterruptedException {
        model.chooseMethod(method);
        model.show(new Segment(0, 0, 8, 4));
        model.settle();
        model.goTo(model.last());
        var readings = new LineReadings(model.state(), Texts.of("line", Language.ENGLISH));
        assertEquals(reading, readings.decision());
    }

    @ParameterizedTest(name = "while stepping the second method is told from its end: step {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "1 | none | 0 extra so far | пока лишних 0",
                "6 | 5 pixels | 5 extra so far | пока лишних 5",
                "11 | 10 pixels | 10 missing, 10 extra | пропущено 10, лишних 10"
            })
    void bothMethodsAreCountedSoFarWhileTheyStep(
            int step, String chosen, String english, String russian) throws InterruptedException {
        model.chooseMethod("bresenham-pascal-textbook");
        model.compareWith("bresenham-pascal-textbook");
        model.show(new Segment(0, 10, 10, 0));
        model.settle();
        model.goTo(step);
        var readings = new LineReadings(model.state(), Texts.of("line", Language.ENGLISH));
        assertEquals(chosen, readings.extra());
        assertEquals(english, readings.other());
        assertEquals(
                russian,
                new LineReadings(model.state(), Texts.of("line", Language.RUSSIAN)).other());
    }

    @Test
    void nothingIsToldOfAnAnswerThatNeverCame() throws InterruptedException {
        int last = Integer.MAX_VALUE;
        model.chooseMethod("bresenham-textbook");
        model.compareWith("bresenham-textbook");
        model.show(new Segment(last - 7, 5, last, 8));
        model.settle();
        model.goTo(model.last());
        assertEquals(LineTrace.TraceEnding.ENDLESS, model.state().drawing().trace().ending());
        var readings = new LineReadings(model.state(), Texts.of("line", Language.ENGLISH));
        assertEquals("–", readings.missing());
        assertEquals("–", readings.extra());
        assertEquals("–", readings.worst());
        assertEquals("–", readings.other());
    }

    @Test
    void largestErrorIsKnownAtTheEnd() throws InterruptedException {
        model.chooseMethod("naive-textbook");
        model.show(new Segment(0, 0, 4, 10));
        model.settle();
        Texts texts = Texts.of("line", Language.ENGLISH);
        model.goTo(1);
        assertEquals("known at the end", new LineReadings(model.state(), texts).worst());
        model.goTo(model.last());
        assertNotEquals("known at the end", new LineReadings(model.state(), texts).worst());
    }

    @ParameterizedTest(name = "coverage is told as whole pixels: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | (2, 1), (2, 0) | 185, 70 of 255 | 0 of 255 levels",
                "RUSSIAN | (2; 1), (2; 0) | 185, 70 из 255 | 0 из 255 уровней"
            })
    void saysHowMuchAStepCoversOfBothItsPixels(
            Language language, String pixels, String levels, String worst)
            throws InterruptedException {
        model.chooseMethod("wu");
        model.show(new Segment(0, 0, 11, 4));
        model.settle();
        model.goTo(3);
        var readings = new LineReadings(model.state(), Texts.of("line", language));
        assertEquals(pixels, readings.pixel());
        assertEquals(levels, readings.coverage());
        model.goTo(model.last());
        assertEquals(worst, new LineReadings(model.state(), Texts.of("line", language)).worst());
    }
}
