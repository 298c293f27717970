package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.canvas.Unshown.BROKEN_FACE;
import static rasterlab.app.canvas.Unshown.INNER_POINT;
import static rasterlab.app.canvas.Unshown.LAMP;
import static rasterlab.app.canvas.Unshown.MAGNITUDE;
import static rasterlab.app.canvas.Unshown.NORMAL_LENGTH;
import static rasterlab.app.canvas.Unshown.OUTSIDE_CUBE;
import static rasterlab.app.canvas.Unshown.PICTURE_SIZE;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.Kept;
import rasterlab.app.canvas.Unshown;
import rasterlab.app.clip.ClipMode;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.LineMode;
import rasterlab.app.spline.SplineMode;
import rasterlab.engine.Topics;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.topic.TopicGradings;

class LabOpeningTest {
    /** Topics of which no tab draws anything. */
    private static final Set<String> WITHOUT_TAB =
            Set.of("depth-buffer", "texture-mapping", "texture-filter");

    /** What else a tab cannot show, and why. */
    private static final Map<String, Unshown> UNSHOWN =
            Map.ofEntries(
                    Map.entry("hidden-surfaces one-pixel", PICTURE_SIZE),
                    Map.entry("hidden-surfaces long-span-drift", PICTURE_SIZE),
                    Map.entry("visible-faces inner-point-before-a-face", INNER_POINT),
                    Map.entry("visible-faces inner-point-outside", INNER_POINT),
                    Map.entry("visible-faces not-convex-but-star-shaped", INNER_POINT),
                    Map.entry("visible-faces parallel", INNER_POINT),
                    Map.entry("visible-faces not-convex", BROKEN_FACE),
                    Map.entry("visible-faces no-area", BROKEN_FACE),
                    Map.entry("visible-faces huge", MAGNITUDE),
                    Map.entry("visible-faces tiny", MAGNITUDE),
                    Map.entry("depth-order huge", MAGNITUDE),
                    Map.entry("depth-order tiny", MAGNITUDE),
                    Map.entry("vertex-normals tiny-faces", MAGNITUDE),
                    Map.entry("vertex-normals zero-area-face", BROKEN_FACE),
                    Map.entry("shade-face zero-area-face", BROKEN_FACE),
                    Map.entry("shade interpolated-normal", NORMAL_LENGTH),
                    Map.entry("shade huge-normal", NORMAL_LENGTH),
                    Map.entry("shade tiny-normal", NORMAL_LENGTH),
                    Map.entry("shade zero-area-face", NORMAL_LENGTH),
                    Map.entry("shade light-in-the-point", LAMP),
                    Map.entry("shade outside-the-cone", LAMP),
                    Map.entry("color brighter-than-white", OUTSIDE_CUBE),
                    Map.entry("color outside-the-cube", OUTSIDE_CUBE));

    /** Draws the generated cases. */
    private static final long SEED = 7;

    /** What is drawn in the background comes to nobody: an older answer would undo a choice. */
    private final LabModels models =
            LabModels.first(
                    answer -> {},
                    failure -> {
                        throw new AssertionError(failure);
                    });

    private final LabOpening opening = new LabOpening(models);
    private final List<String> tabs = new ArrayList<>();

    @AfterEach
    void close() {
        models.close();
    }

    private LabOpening shown() {
        opening.showTabsBy(tabs::add);
        return opening;
    }

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @Test
    void hazardsThatNoTabShowsAreKnown() {
        var unshown = new TreeMap<String, Unshown>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards())
                if (!WITHOUT_TAB.contains(topic.name()))
                    opening.obstacleTo(topic.name(), hazard.name())
                            .ifPresent(why -> unshown.put(topic.name() + " " + hazard.name(), why));
        assertEquals(new TreeMap<>(UNSHOWN), unshown);
    }

    /** The labs' choices as they are kept, by name. */
    private Map<String, Object> choices() {
        var choices = new TreeMap<String, Object>();
        for (Map.Entry<String, Kept<?>> lab : models.kept().entrySet())
            choices.put(lab.getKey(), lab.getValue().kept());
        choices.put("visibility", models.visibility().state().choice().scene());
        return choices;
    }

    @ParameterizedTest
    @MethodSource("topics")
    void everyHazardIsShownByEveryMethodOrSaysWhyNot(Topic<?, ?, ?> topic) {
        shown();
        for (Hazard<?> hazard : topic.hazards()) {
            Optional<Unshown> obstacle = opening.obstacleTo(topic.name(), hazard.name());
            for (var method : topic.methods()) {
                tabs.clear();
                Runnable show =
                        () -> opening.showHazard(topic.name(), hazard.name(), method.name());
                if (obstacle.isPresent()) {
                    assertThrows(IllegalArgumentException.class, show::run, hazard.name());
                    assertEquals(List.of(), tabs);
                } else {
                    show.run();
                    assertEquals(1, tabs.size());
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("topics")
    void eachHazardIsShownUnlikeTheOthersOfItsTopic(Topic<?, ?, ?> topic) {
        var seen = new TreeMap<String, String>();
        String method = topic.methods().get(0).name();
        for (Hazard<?> hazard : topic.hazards()) {
            if (opening.obstacleTo(topic.name(), hazard.name()).isPresent()) continue;
            shown().showHazard(topic.name(), hazard.name(), method);
            String before = seen.put(choices().toString(), hazard.name());
            assertEquals(null, before, hazard.name() + " looks like " + before);
        }
    }

    @ParameterizedTest
    @MethodSource("topics")
    void reasonIsSaidInBothLanguages(Topic<?, ?, ?> topic) {
        var reasons = new TreeSet<Unshown>();
        for (Hazard<?> hazard : topic.hazards())
            opening.obstacleTo(topic.name(), hazard.name()).ifPresent(reasons::add);
        for (Unshown why : reasons)
            for (Language language : Language.values())
                assertFalse(why.in(Texts.of("canvas", language), topic.name()).isBlank());
    }

    @Test
    void hazardOfLinesIsShownWithItsMethod() {
        models.line().chooseMode(LineMode.PEN);
        shown().showHazard("line", "leftward", "naive-textbook");
        assertEquals(LineMode.SEGMENT, models.line().mode());
        assertEquals("naive-textbook", models.line().state().choice().method());
        Segment segment = models.line().state().choice().segment();
        assertTrue(segment.x1() < segment.x0(), segment.toString());
        assertEquals(List.of("line"), tabs);
    }

    @Test
    void hazardIsShownInItsMode() {
        shown().showHazard("clip-polygon", "comb", "weiler-atherton");
        assertEquals(ClipMode.POLYGON, models.clip().state().choice().scene().mode());
        opening.showHazard("spline-function", spline(), "monotone");
        assertEquals(SplineMode.FUNCTION, models.spline().mode());
        assertEquals(List.of("clip", "spline"), tabs);
    }

    private String spline() {
        return models.spline().function().hazards().get(0).name();
    }

    @Test
    void inputOfLinesIsReadWithItsWindow() {
        shown().showInput(
                        "line", "{\"from\":[1,2],\"to\":[-3,4],\"window\":[0,0,9,9]}", "bresenham");
        assertEquals(
                new Segment(1, 2, -3, 4).in(new PixelWindow(0, 0, 9, 9)),
                models.line().state().choice().segment());
    }

    @Test
    void brokenInputIsRefusedWithItsPlaceAndNoTabIsShown() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> shown().showInput("line", "{\"from\":[1,2],\"to\":[3]}", ""));
        assertTrue(refused.getMessage().contains("'to'"), refused.getMessage());
        assertEquals(List.of(), tabs);
    }

    @Test
    void casesOfEveryExerciseAreShown() {
        shown();
        for (Exercise exercise : Catalogue.builtIn().all()) {
            TopicGrading grading = TopicGradings.named(exercise.topic());
            assertEquals(Optional.empty(), opening.obstacleToInputs(exercise.topic()));
            for (Exercise.Case one : exercise.cases())
                for (var call : grading.calls(one, exercise.tolerance(), SEED)) {
                    var scene = (MethodCase) SceneFile.read(call.scene());
                    tabs.clear();
                    opening.showInput(scene.topic(), scene.input(), scene.method().orElse(""));
                    assertEquals(1, tabs.size(), exercise.id() + " " + one.name());
                }
        }
    }

    @Test
    void casesOfATopicWithoutExercisesAreRefused() {
        assertEquals(Optional.of(Unshown.NO_READER), opening.obstacleToInputs("matrix"));
        assertThrows(
                IllegalArgumentException.class, () -> shown().showInput("matrix", "{}", "formula"));
    }
}
