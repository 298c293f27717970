package rasterlab.exercises.searching;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.ForwardingTopic;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.judging.MethodsOnInput;
import rasterlab.exercises.judging.MethodsOnInput.MethodResult;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.score.Phrase;

class HazardSearchTest {
    /** Ample: each of these is found with the first few inputs. */
    private static final Duration TIME = Duration.ofMinutes(2);

    /** The messages of a search, in their order. */
    private static final class Heard implements SearchListener {
        final List<Find> finds = new ArrayList<>();

        @Override
        public void tried(long inputs) {}

        @Override
        public void found(Find find) {
            finds.add(find);
        }

        @Override
        public void simpler(Find find) {
            finds.add(find);
        }
    }

    @ParameterizedTest(name = "nothing is found for {0} {1}")
    @CsvSource({
        "line, naive-textbook",
        "clip-segment, cohen-sutherland-nested-textbook",
        "triangulate, shortest-diagonal-textbook",
        "rotate-axis, seven-steps-textbook",
        "view, taken-apart-textbook",
        "visible-faces, convex-segment-textbook",
        "color, formula-textbook",
        "spline-function, cubic-textbook",
        "clip-polygon, sutherland-hodgman-textbook",
        "texture-mapping, affine-textbook",
        "texture-filter, nearest-textbook"
    })
    void findsAnInputOnWhichTheMethodFailsAndRightOnesDoNot(String topic, String method) {
        Find find =
                HazardSearch.of(topic, method, 5, new Heard())
                        .search(TIME, () -> false)
                        .orElseThrow();
        MethodsOnInput<?, ?, ?> again =
                MethodsOnInput.of(topic, Phrase.of("break.input"), find.input());
        assertTrue(again.right().stream().noneMatch(MethodResult::failed), find.input());
    }

    @ParameterizedTest(name = "a promise to be right is held to where it was not made")
    @ValueSource(booleans = {true, false})
    void methodIsHeldToItsPromiseWhereItMadeIt(boolean promised) {
        var line = new LineTopic();
        var methods =
                List.of(
                        Method.right("broken", line.method("naive-textbook").implementation()),
                        Method.right("witness", line.method("bresenham").implementation()));
        var topic =
                new ForwardingTopic<>(lineWith(methods)) {
                    @Override
                    public boolean isPromised(Segment input) {
                        return promised;
                    }
                };
        var inputs = new AtomicInteger();
        Optional<Find> found =
                HazardSearch.of(topic, "broken", 5, new Heard())
                        .search(TIME, () -> inputs.incrementAndGet() > 150);
        assertEquals(promised, found.isPresent());
    }

    @Test
    void foundInputGetsSimplerAndIsTheSameForTheSameSeed() {
        var heard = new Heard();
        Optional<Find> one =
                HazardSearch.of("line", "naive-textbook", 5, heard).search(TIME, () -> false);
        Optional<Find> again =
                HazardSearch.of("line", "naive-textbook", 5, new Heard()).search(TIME, () -> false);
        assertEquals(one.orElseThrow().input(), again.orElseThrow().input());
        int first = heard.finds.get(0).input().length();
        assertTrue(one.get().input().length() <= first, heard.finds.toString());
    }

    @Test
    void nothingIsFoundForARightMethod() {
        var inputs = new AtomicInteger();
        Optional<Find> found =
                HazardSearch.of("line", "bresenham", 5, new Heard())
                        .search(TIME, () -> inputs.incrementAndGet() > 150);
        assertEquals(Optional.empty(), found);
    }

    @Test
    @DisplayName("an input is found though no method that promises to be right is exact there")
    void nothingIsFoundWhereNoRightMethodIsExact() {
        Method<LineRasterizer> wrong = new LineTopic().method("naive-textbook");
        var inputs = new AtomicInteger();
        Optional<Find> found =
                HazardSearch.of(
                                lineWith(
                                        List.of(
                                                wrong,
                                                Method.right("witness", wrong.implementation()))),
                                "naive-textbook",
                                5,
                                new Heard())
                        .search(TIME, () -> inputs.incrementAndGet() > 150);
        assertEquals(Optional.empty(), found);
    }

    /** The topic of segments with other methods. */
    @SuppressWarnings("unchecked") // all is answered by a topic of segments but the methods
    private static Topic<LineRasterizer, Segment, PixelRecording> lineWith(
            List<Method<LineRasterizer>> methods) {
        var line = new LineTopic();
        return (Topic<LineRasterizer, Segment, PixelRecording>)
                Proxy.newProxyInstance(
                        Topic.class.getClassLoader(),
                        new Class<?>[] {Topic.class},
                        (proxy, asked, arguments) ->
                                asked.getName().equals("methods")
                                        ? methods
                                        : asked.invoke(line, arguments));
    }

    @ParameterizedTest(name = "{1}: tables have rows of any length, or no step is along an axis")
    @CsvSource({
        "texture-filter, corner-not-center",
        "texture-filter, weights-swapped",
        "texture-filter, level-0-alone"
    })
    void tablesAndStepsAlongTheAxesAreDrawn(String topic, String mutant) {
        HazardSearch<?, ?, ?> search = HazardSearch.of(topic, mutant, 1, new Heard());
        Find find = search.search(TIME, () -> false).orElseThrow();
        assertEquals(Verdict.Kind.WRONG, find.verdict().kind(), find.input());
        assertTrue(find.tried() <= 200, () -> find.tried() + " inputs");
    }

    @ParameterizedTest(name = "the parameters of {0} that go together are not drawn together")
    @ValueSource(strings = {"about-y-clockwise", "scale-z-flattens-x-y", "axis-moves"})
    void formsOfAnInputAreDrawnOneByOne(String mutant) {
        HazardSearch<?, ?, ?> search = HazardSearch.of("matrix", mutant, 1, new Heard());
        Find find = search.search(TIME, () -> false).orElseThrow();
        assertEquals(Verdict.Kind.WRONG, find.verdict().kind(), find.input());
    }

    @Test
    @DisplayName("a mutant that refuses what right methods answer is not told by that")
    void wrongRefusalOfAMutantIsFound() {
        var inputs = new AtomicInteger();
        Find find =
                HazardSearch.of("shade-face", "no-area-refused", 1, new Heard())
                        .search(TIME, () -> inputs.incrementAndGet() > 5_000)
                        .orElseThrow();
        assertEquals(Verdict.Kind.REFUSED, find.verdict().kind(), find.input());
    }

    @Test
    void mutantIsFoundToo() {
        Find find =
                HazardSearch.of("visible-faces", "turned-away", 5, new Heard())
                        .search(TIME, () -> false)
                        .orElseThrow();
        assertEquals("turned-away", find.method());
    }

    @Test
    void sceneKeepsVerdictAndSeed() {
        Find find =
                HazardSearch.of("line", "naive-textbook", 5, new Heard())
                        .search(TIME, () -> false)
                        .orElseThrow();
        var read = (MethodCase) SceneFile.read(find.scene().write());
        assertEquals(find.scene(), read);
        assertEquals(
                new MethodCase.SearchFinding(find.verdict().kind().code(), 5),
                read.found().orElseThrow());
    }

    @Test
    void unknownMethodIsRefused() {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> HazardSearch.of("line", "bresenhan", 1, new Heard()));
        assertTrue(
                refusal.getMessage().startsWith("no line method 'bresenhan'"), refusal::getMessage);
    }
}
