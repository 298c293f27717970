package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabOpening;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;

/** Inputs for 'break it', handed in from the labs. */
class HandInTest {
    private final LabModels models = LabModels.first(answer -> {}, HandInTest::fail);
    private final LabOpening opening =
            new LabOpening(models, work -> {}, Runnable::run, HandInTest::fail);
    private final List<String> told = new ArrayList<>();

    private static void fail(Throwable failure) {
        throw new AssertionError(failure);
    }

    @AfterEach
    void close() {
        models.close();
    }

    @Test
    void theLabOfEveryTopicWithMistakesToFindHandsIn() {
        Set<String> without = new TreeSet<>();
        breaking()
                .map(Exercise::topic)
                .filter(topic -> !opening.handsIn(topic))
                .forEach(without::add);
        assertEquals(Set.of(), without);
    }

    static Stream<String> topics() {
        return breaking().map(Exercise::topic);
    }

    private static Stream<Exercise> breaking() {
        return Catalogue.builtIn().all().stream().filter(one -> one.form() == TaskKind.BREAK);
    }

    @ParameterizedTest(name = "{0}: another input is handed in than its lab shows")
    @MethodSource("topics")
    void starterThatIsShownIsHandedIn(String name) {
        Exercise exercise = breaking(name);
        opening.showToHandIn(exercise.id(), exercise.topic(), exercise.starter());
        Topic<?, ?, ?> topic = Topics.named(exercise.topic());
        String shown = opening.written(exercise.topic()).orElseThrow();
        // The lab of this topic looks at a place of its own.
        if (topic.name().equals("spline-function"))
            shown = shown.replaceFirst("\"at\": \\[.*?]", "\"at\": [0]");
        assertEquals(whole(topic, exercise.starter()), whole(topic, shown));
    }

    /** The input with every field of its topic. */
    private static <I> String whole(Topic<?, I, ?> topic, String json) {
        return GivenInput.name(topic, GivenInput.read(topic.format(), json));
    }

    @Test
    void whatIsChangedInTheLabIsHandedInAsItIs() {
        show("rotate-axis");
        models.of(new CoordinatesRoom()).transformations().set(6, 33);
        assertTrue(written("rotate-axis").contains("\"degrees\": 33"), written("rotate-axis"));
        show("view");
        models.of(new CoordinatesRoom()).transformations().set(2, 12);
        assertTrue(written("view").contains("\"rho\": 12"), written("view"));
        show("transform");
        models.of(new CoordinatesRoom()).transformations().add("SCALE3D");
        assertTrue(written("transform").contains("\"matrices\": [[["), written("transform"));
        show("matrix");
        models.of(new CoordinatesRoom()).transformations().set(0, 5);
        assertEquals("{\"name\": \"SCALE3DX\", \"a\": 5}", written("matrix"));
    }

    @Test
    void sceneThatIsTurnedIsHandedInAsItIsSeen() {
        for (String topic : List.of("hidden-surfaces", "visible-faces", "depth-order")) {
            show(topic);
            String before = written(topic);
            models.of(new VisibilityRoom()).turn(0.25, 0.125);
            assertNotEquals(before, written(topic), topic);
            whole(Topics.named(topic), written(topic));
        }
    }

    /** A face is seen from where the eye stands: the same sides are turned to it as before. */
    @Test
    void bodyThatIsTurnedKeepsItsVisibleFaces() {
        show("visible-faces");
        models.of(new VisibilityRoom()).zoom(1.25);
        String zoomed = written("visible-faces");
        models.of(new VisibilityRoom()).turn(1e-9, 0);
        assertNotEquals(zoomed, written("visible-faces"));
        assertEquals(visible(zoomed), visible(written("visible-faces")));
    }

    private static List<Boolean> visible(String json) {
        var topic = new VisibleFacesTopic();
        var body = GivenInput.read(topic.format(), json);
        var seen = topic.exact(body, Integer.MAX_VALUE);
        return IntStream.range(0, seen.size()).mapToObj(seen::visible).toList();
    }

    private void show(String topic) {
        Exercise exercise = breaking(topic);
        opening.showToHandIn(exercise.id(), topic, exercise.starter());
    }

    private String written(String topic) {
        return opening.written(topic).orElseThrow();
    }

    @Test
    void rowsThatAreShownHideTheOtherInputsOfTheirTab() {
        show("color");
        show("texture-mapping");
        assertEquals(Optional.empty(), opening.written("color"));
        assertEquals(Optional.empty(), opening.written("texture-filter"));
        show("depth-triangle");
        assertEquals(Optional.empty(), opening.written("visible-faces"));
    }

    @ParameterizedTest(name = "another input of {0} is handed in than is shown")
    @CsvSource(
            delimiter = '|',
            value = {
                "line | {\"from\":[1,2],\"to\":[-3,4]}",
                "circle | {\"center\":[2,-3],\"radius\":4}",
                "ellipse | {\"center\":[2,-3],\"rx\":5,\"ry\":4}",
                "polygon-fill | {\"polygon\":[[2,2],[8,2],[8,8],[2,8]],\"rule\":\"evenodd\",\"size\":[12,12]}",
                "point-in-triangle | {\"triangle\":[[0,0],[4,0],[2,5]],\"points\":[[1,1]]}",
                "point-in-polygon | {\"polygon\":[[0,0],[4,0],[2,5]],\"points\":[[1,1]]}",
                "triangulate | {\"polygon\":[[0,0],[4,0],[4,4],[0,5]]}",
                "clip-segment | {\"window\":[0,0,9,8],\"segments\":[[-1,2,5,6]]}",
                "clip-polygon | {\"window\":[0,0,9,8],\"polygon\":[[-1,2],[5,6],[3,-2]]}"
            })
    void inputThatIsShownIsHandedIn(String topic, String json) throws Exception {
        Exercise exercise = breaking(topic);
        opening.tellHandingInTo((tab, one) -> told.add(one.id()));
        opening.showToHandIn(exercise.id(), topic, json);
        assertEquals(List.of(exercise.id()), told);
        assertEquals(
                new JsonMapper().readTree(json),
                new JsonMapper().readTree(opening.written(topic).orElseThrow()));
    }

    @Test
    void inputOfAnotherModeOfTheLabIsNotHandedIn() {
        opening.showToHandIn("break-circle", "circle", "{\"center\":[2,-3],\"radius\":4}");
        assertEquals(Optional.empty(), opening.written("ellipse"));
        assertEquals(Optional.empty(), opening.written("line"));
        assertFalse(opening.handIn(breaking("ellipse")));
    }

    @Test
    void handingInShowsTheExerciseAndTriesTheInput() {
        List<String> tabs = new ArrayList<>();
        opening.showTabsBy(tabs::add);
        opening.showToHandIn("break-circle", "circle", "{\"center\":[2,-3],\"radius\":4}");
        assertTrue(opening.handIn(breaking("circle")));
        assertEquals(List.of("line", "exercises"), tabs);
        String chosen = String.valueOf(models.exercises().kept());
        assertTrue(chosen.contains("exercise=break-circle"), chosen);
    }

    private static Exercise breaking(String topic) {
        return breaking().filter(one -> one.topic().equals(topic)).findFirst().orElseThrow();
    }
}
