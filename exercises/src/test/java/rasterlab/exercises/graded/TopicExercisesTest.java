package rasterlab.exercises.graded;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.contract.SegmentClipper;
import rasterlab.contract.Triangulator;
import rasterlab.engine.Topics;
import rasterlab.engine.circle.MidpointCircle;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.proving.GradedMethod;
import rasterlab.exercises.proving.Marked;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.topic.TopicGradings;

/** The exercises that are graded by their topic's own comparison reject what is wrong. */
class TopicExercisesTest {
    private static final long SEED = 20261127;

    static Stream<String> exercises() {
        return Stream.of("point-in-triangle", "clip-segment", "shade-face");
    }

    @DisplayName("a plain right method loses accuracy points")
    @ParameterizedTest
    @MethodSource("exercises")
    void aPlainRightMethodIsFullyAccurate(String id) throws Exception {
        for (long seed = SEED; seed < SEED + 20; seed++) {
            Tried tried = tried(id, reference(id), seed);
            assertEquals(List.of(), tried.failed(Criterion.ACCURACY), "seed " + seed);
        }
    }

    @DisplayName("a wrong answer has no pictures, or none with words in both languages")
    @ParameterizedTest
    @MethodSource("exercises")
    void aWrongAnswerIsShownInThreePictures(String id) {
        Topic<?, ?, ?> topic = topic(id);
        Tried tried = tried(id, topic.mutants().get(0).implementation(), SEED);
        Finding shown = tried.shown().orElseThrow();
        assertEquals(
                List.of(CasePicture.EXPECTED, CasePicture.ACTUAL, CasePicture.DIFFERENCE),
                shown.pictures().stream().map(CasePicture::kind).toList());
        for (CasePicture picture : shown.pictures())
            for (String language : List.of("en", "ru"))
                assertFalse(picture.text().in(language).isBlank());
    }

    @DisplayName("the lab is opened with a method that is wrong there")
    @ParameterizedTest
    @MethodSource("exercises")
    void theLabOpensWithAMethodThatIsRight(String id) throws Exception {
        Topic<?, ?, ?> topic = topic(id);
        for (Case one : Catalogue.builtIn().named(id).cases())
            for (TopicGrading.GradedCall call :
                    TopicGradings.named(id).calls(one, new ExerciseTolerance(false), SEED)) {
                JsonNode scene = new JsonMapper().readTree(call.scene());
                String name = scene.get("method").asText();
                Object method = topic.method(name).implementation();
                assertTrue(
                        call.check(GradedMethod.answer(call, method)).right(),
                        one.name() + ": " + name);
            }
    }

    @Test
    void aSegmentThatIsSentTwiceIsToldSo() {
        SegmentClipper plain = new PlainClip();
        SegmentClipper twice =
                (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) ->
                        plain.clip(
                                xmin,
                                ymin,
                                xmax,
                                ymax,
                                x0,
                                y0,
                                x1,
                                y1,
                                (ax, ay, bx, by) -> {
                                    out.segment(ax, ay, bx, by);
                                    out.segment(ax, ay, bx, by);
                                });
        Finding shown = tried("clip-segment", twice, SEED).shown().orElseThrow();
        String said = shown.message().in("en");
        assertTrue(said.startsWith("what is right is sent again"), said);
    }

    @ParameterizedTest(name = "the order of pixels is told where any order is right: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "(3, -4) (-4, 3) | pixels missing: 2, the first is (3, −4)"
                        + " | не хватает пикселей: 2, первый из них (3; −4)",
                "(3, -4) | pixel (3, −4) is missing | нет пикселя (3; −4)"
            })
    void missingPixelsAreToldByTheirPlaces(String left, String english, String russian) {
        CircleRasterizer without =
                backwards(
                        (x, y, out) -> {
                            if (!left.contains("(" + x + ", " + y + ")")) out.plot(x, y);
                        });
        assertTold(without, english, russian);
    }

    @Test
    @DisplayName("pixels that are drawn twice are told as a place in the order")
    void repeatedPixelsAreToldAsRepeated() {
        CircleRasterizer again =
                backwards(
                        (x, y, out) -> {
                            out.plot(x, y);
                            if (x == 0 && y < 0) out.plot(x, y);
                        });
        List<CasePicture> shown =
                assertTold(
                        again, "pixel (0, −5) is drawn again", "пиксель (0; −5) нарисован снова");
        assertTrue(
                shown.stream().noneMatch(one -> one.text().in("en").contains("row pixels[0]")),
                "a table in the order of drawing");
        assertEquals(3, shown.size());
    }

    @Test
    void extraPixelsAreToldBesideMissingOnes() {
        CircleRasterizer moved = backwards((x, y, out) -> out.plot(x, x == 5 && y == 0 ? 1000 : y));
        assertTold(
                moved,
                "pixel (5, 0) is missing; pixel (5, 1000) is extra",
                "нет пикселя (5; 0); лишний пиксель (5; 1000)");
    }

    @Test
    @DisplayName("a triangle is told as wrong where it only is none of the reference's")
    void aTriangulationIsToldByWhatIsWrongWithIt() {
        Triangulator fan =
                (x, y) -> {
                    int[] all = new int[3 * (x.length - 2)];
                    for (int i = 0; i < all.length; i++) all[i] = i % 3 == 0 ? 0 : i / 3 + i % 3;
                    return all;
                };
        String dart = "{\"given\": {\"polygon\": [[0, 0], [4, 4], [8, 0], [4, 9]]}}";
        Finding told = judged("triangulate", dart, fan);
        String english = told.message().in("en");
        assertTrue(english.startsWith("triangle 0 (0, 1, 2) goes clockwise; "), english);
        String russian = told.message().in("ru");
        assertTrue(russian.startsWith("обход треугольника 0 (0, 1, 2)\u00a0— по"), russian);
    }

    private static Finding judged(String topic, String input, Object method) {
        Case one =
                new Case("a-case", Map.of(), Criterion.ACCURACY, Disclosure.OPEN, 1, input, false);
        TopicGrading.GradedCall call =
                TopicGradings.named(topic).calls(one, new ExerciseTolerance(false), 1).get(0);
        return call.judge(GradedMethod.answer(call, method));
    }

    private interface Plot {
        void at(int x, int y, Pixels out);
    }

    /** A right circle whose pixels come in the reverse order, each by way of that. */
    private static CircleRasterizer backwards(Plot plot) {
        return (centerX, centerY, radius, out) -> {
            var all = new PixelRecording(Integer.MAX_VALUE);
            new MidpointCircle().draw(centerX, centerY, radius, all);
            for (int i = all.size() - 1; i >= 0; i--) plot.at(all.x(i), all.y(i), out);
        };
    }

    /** The pictures beside the words. */
    private static List<CasePicture> assertTold(
            CircleRasterizer method, String english, String russian) {
        String circle = "{\"given\": {\"center\": [0, 0], \"radius\": 5}}";
        Finding told = judged("circle", circle, method);
        assertToldFirst(english, told.message().in("en"));
        assertToldFirst(russian, told.message().in("ru"));
        return told.pictures();
    }

    /** The text on what decides a pixel may stand behind that on what is wrong. */
    private static void assertToldFirst(String fault, String said) {
        assertTrue(said.equals(fault) || said.startsWith(fault + "; "), said);
    }

    /** The marking of all cases. */
    private record Tried(Exercise exercise, Marking marking) {
        List<String> failed(Criterion... kinds) {
            return exercise.cases().stream()
                    .filter(one -> List.of(kinds).contains(one.kind()))
                    .map(Case::name)
                    .filter(name -> !marking.paying().contains(name))
                    .toList();
        }

        private Stream<TriedCall> calls() {
            return marking.cases().stream().flatMap(one -> one.calls().stream());
        }

        Optional<Finding> shown() {
            return calls().filter(call -> call.finding().verdict() == GradingVerdict.WRONG)
                    .map(call -> call.call().judge(call.answer().orElseThrow()))
                    .findFirst();
        }
    }

    private static Tried tried(String id, Object method, long seed) {
        Exercise exercise = Catalogue.builtIn().named(id);
        TopicGrading grading = TopicGradings.of(exercise);
        return new Tried(exercise, Marked.cases(exercise, grading, method, seed));
    }

    /** The plain method beside the grading; where the exercise has a model instead, the topic's. */
    private static Object reference(String id) throws ReflectiveOperationException {
        Optional<Class<?>> plain = TopicGradings.named(id).reference();
        if (plain.isPresent()) return plain.get().getDeclaredConstructor().newInstance();
        return topic(id).methods().stream()
                .filter(Method::promisesToBeRight)
                .findFirst()
                .orElseThrow()
                .implementation();
    }

    private static Topic<?, ?, ?> topic(String id) {
        return Topics.named(id);
    }
}
