package rasterlab.app.shell.labs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.COLOR_CUT;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.CORNER_MOVED;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.FACES_ALL;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.FACES_FOUND;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.FACES_WITHOUT_AREA;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.FACE_NORMAL;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.LAMP_BESIDE;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.NORMALS_LENGTHENED;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.NORMAL_LENGTH;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.PAINTED_AS_GIVEN;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.PAINTED_IN_ORDER;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.PICTURE_SIZE;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.POINT_ASIDE;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.SCALED;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.STRETCHED;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.NotShown;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.app.card.TopicCard;
import rasterlab.app.card.TopicInput;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.list.Trial;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.line.LineRoom;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.Topics;
import rasterlab.engine.line.Segment;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

@Tag("slow")
class LabOpeningTest {
    /** The hazards that a tab shows otherwise than they are, by some method, and in what. */
    private static final Map<String, Set<ShownDifference.ShownDifferenceKind>> UNLIKE =
            Map.ofEntries(
                    Map.entry("hidden-surfaces one-pixel", EnumSet.of(PICTURE_SIZE)),
                    Map.entry(
                            "hidden-surfaces long-span-drift", EnumSet.of(PICTURE_SIZE, STRETCHED)),
                    Map.entry(
                            "visible-faces inner-point-before-a-face",
                            EnumSet.of(FACES_FOUND, FACES_ALL)),
                    Map.entry(
                            "visible-faces inner-point-outside",
                            EnumSet.of(FACES_FOUND, FACES_ALL)),
                    Map.entry("visible-faces not-convex-but-star-shaped", EnumSet.of(FACES_FOUND)),
                    Map.entry("visible-faces parallel", EnumSet.of(FACES_FOUND, FACES_ALL)),
                    Map.entry("visible-faces not-convex", EnumSet.of(FACES_FOUND, FACES_ALL)),
                    Map.entry(
                            "visible-faces no-area",
                            EnumSet.of(FACES_FOUND, FACES_ALL, FACES_WITHOUT_AREA)),
                    Map.entry("visible-faces huge", EnumSet.of(FACES_FOUND, SCALED)),
                    Map.entry("visible-faces tiny", EnumSet.of(FACES_FOUND, SCALED)),
                    Map.entry(
                            "visible-faces wall-at-the-largest",
                            EnumSet.of(FACES_FOUND, FACES_ALL, SCALED)),
                    Map.entry("depth-order huge", EnumSet.of(PAINTED_IN_ORDER, SCALED)),
                    Map.entry("depth-order tiny", EnumSet.of(PAINTED_IN_ORDER, SCALED)),
                    Map.entry("depth-order too-near-the-eye", EnumSet.of(PAINTED_AS_GIVEN, SCALED)),
                    Map.entry("vertex-normals smallest-face", EnumSet.of(SCALED, FACE_NORMAL)),
                    Map.entry("vertex-normals tiny-faces", EnumSet.of(SCALED, FACE_NORMAL)),
                    Map.entry(
                            "vertex-normals zero-area-face",
                            EnumSet.of(FACES_WITHOUT_AREA, FACE_NORMAL)),
                    Map.entry("vertex-normals cube-cut-one-way", EnumSet.of(NORMALS_LENGTHENED)),
                    Map.entry(
                            "vertex-normals roof-with-a-long-side", EnumSet.of(NORMALS_LENGTHENED)),
                    Map.entry("vertex-normals both-sides-of-a-sheet", EnumSet.of(FACE_NORMAL)),
                    Map.entry("shade-face zero-area-face", EnumSet.of(CORNER_MOVED)),
                    Map.entry("shade light-in-the-plane", EnumSet.of(NORMAL_LENGTH)),
                    Map.entry("shade interpolated-normal", EnumSet.of(NORMAL_LENGTH)),
                    Map.entry("shade eye-across-the-mirror", EnumSet.of(NORMAL_LENGTH)),
                    Map.entry("shade mirrored-light-a-hair-this-side", EnumSet.of(NORMAL_LENGTH)),
                    Map.entry("shade huge-normal", EnumSet.of(NORMAL_LENGTH)),
                    Map.entry("shade tiny-normal", EnumSet.of(NORMAL_LENGTH)),
                    Map.entry("shade zero-area-face", EnumSet.of(NORMAL_LENGTH)),
                    Map.entry("shade light-in-the-point", EnumSet.of(LAMP_BESIDE)),
                    Map.entry("shade outside-the-cone", EnumSet.of(POINT_ASIDE)),
                    Map.entry("color brighter-than-white", EnumSet.of(COLOR_CUT)),
                    Map.entry("color too-dark-for-digits", EnumSet.of(COLOR_CUT)),
                    Map.entry("color outside-the-cube", EnumSet.of(COLOR_CUT)));

    /** Drops pictures of the background: an older answer would undo a choice. */
    private final LabModels models =
            LabModels.first(
                    answer -> {},
                    failure -> {
                        throw new AssertionError(failure);
                    });

    private final Deque<Runnable> background = new ArrayDeque<>();
    private final LabOpening opening =
            new LabOpening(
                    models,
                    work -> background.add(work),
                    Runnable::run,
                    failure -> {
                        throw new AssertionError(failure);
                    });
    private final List<String> tabs = new ArrayList<>();

    @AfterEach
    void close() {
        models.close();
    }

    private LabOpening shown() {
        opening.showTabsBy(tabs::add);
        return opening;
    }

    private void open(String topic, String hazard, String method) {
        shown().showHazard(topic, hazard, method);
        runBackground();
    }

    private void runBackground() {
        while (!background.isEmpty()) background.remove().run();
    }

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    private List<ShownDifference> differences(
            Topic<?, ?, ?> topic, Hazard<?> hazard, Method<?> method) {
        var input = new TopicInput(topic.name(), hazard.name(), hazard.input());
        return differences(LabRooms.card(topic.name()), input, method.name());
    }

    private <M> List<ShownDifference> differences(
            TopicCard<M> card, TopicInput input, String method) {
        return card.way()
                .notes()
                .map(notes -> notes.differences().differences(models.of(card.lab()), input, method))
                .orElse(List.of());
    }

    @Test
    void whatTabsShowOtherwiseThanItIsIsKnown() {
        var found = new TreeMap<String, Set<ShownDifference.ShownDifferenceKind>>();
        for (Topic<?, ?, ?> topic : Topics.all())
            for (Hazard<?> hazard : topic.hazards())
                for (Method<?> method : topic.methods())
                    for (ShownDifference each : differences(topic, hazard, method))
                        found.computeIfAbsent(
                                        topic.name() + " " + hazard.name(),
                                        name ->
                                                EnumSet.noneOf(
                                                        ShownDifference.ShownDifferenceKind.class))
                                .add(each.kind());
        assertEquals(new TreeMap<>(UNLIKE), found);
    }

    @ParameterizedTest
    @MethodSource("topics")
    void noteSaysWhatTheMethodDoesWithTheHazardItself(Topic<?, ?, ?> topic) {
        for (Hazard<?> hazard : topic.hazards())
            for (Method<?> method : topic.methods()) {
                List<ShownDifference> differences = differences(topic, hazard, method);
                if (differences.isEmpty()) continue;
                Verdict verdict = LabOpening.verdict(topic, hazard.name(), method.name());
                String name = hazard.name() + " " + method.name();
                assertEquals(
                        hazard.recorded().getOrDefault(method.name(), Verdict.Kind.EXACT),
                        verdict.kind(),
                        name);
                var note = new HazardNote(hazard.name(), method.name(), verdict, differences);
                assertTrue(note.in(Language.ENGLISH).contains(method.name()), name);
                String russian = note.in(Language.RUSSIAN);
                if (verdict.kind() != Verdict.Kind.EXACT)
                    assertFalse(
                            russian.contains(verdict.detail()), name + " in English: " + russian);
            }
    }

    @Test
    void noteIsToldToTheTabAndGoesWithTheScene() {
        open("visible-faces", "tiny", "convex-segment-textbook");
        HazardNote note = models.of(new VisibilityRoom()).state().note().orElseThrow();
        assertEquals("tiny", note.hazard());
        assertEquals(Verdict.Kind.WRONG, note.verdict().kind());
        open("visible-faces", "cube", "convex-segment-textbook");
        assertEquals(Optional.empty(), models.of(new VisibilityRoom()).state().note());
    }

    @ParameterizedTest(
            name = "a picture that is right is shown for a wrong method unsaid: {0}, {2}")
    @CsvSource({
        "shade, light-behind, phong-textbook, true",
        "shade, facing, lambert, false",
        "shade-face, curved, flat-textbook, true",
        "shade-face, curved, flat, false",
        "color, grey, formula-textbook, true",
        "color, pure-colours, eight-bit, true",
        "color, grey, formula, false"
    })
    void methodThatTheLabHasNotIsNamed(String topic, String hazard, String method, boolean named) {
        open(topic, hazard, method);
        boolean said =
                models.of(new LightRoom()).state().note().stream()
                        .flatMap(note -> note.differences().stream())
                        .anyMatch(
                                each ->
                                        each.kind()
                                                == ShownDifference.ShownDifferenceKind
                                                        .OTHER_METHOD);
        assertEquals(named, said);
    }

    @Test
    void methodIsTriedInTheBackgroundAndOnlyTheNewestHazardIsShown() {
        shown().showHazard("visible-faces", "tiny", "convex-segment-textbook");
        assertEquals(1, background.size());
        assertEquals(List.of(), tabs);
        opening.showHazard("line", "leftward", "bresenham");
        runBackground();
        assertEquals(List.of("line"), tabs);
    }

    @Test
    void rowsOpenInTheirTabsAndScenesCloseThem() {
        open("depth-buffer", "far-near-million", "z24");
        assertTrue(models.of(new VisibilityRoom()).rows().open());
        assertEquals("z24", models.of(new VisibilityRoom()).rows().choice().method());
        open("visible-faces", "cube", "back-face");
        assertFalse(models.of(new VisibilityRoom()).rows().open());
        open("texture-filter", "turned", "summed-area");
        assertTrue(models.of(new LightRoom()).rows().open());
        open("color", "grey", "formula");
        assertFalse(models.of(new LightRoom()).rows().open());
        assertEquals(List.of("visibility", "visibility", "light", "light"), tabs);
    }

    /** The labs' choices as they are kept, by name. */
    private Map<String, Object> choices() {
        var choices = new TreeMap<String, Object>();
        for (Map.Entry<String, Kept<?>> lab : models.kept().entrySet())
            choices.put(lab.getKey(), lab.getValue().kept());
        choices.put("visibility", models.of(new VisibilityRoom()).state().choice().scene());
        return choices;
    }

    @ParameterizedTest(name = "points are shown by another method than the cell''s: {0}")
    @ValueSource(strings = {"transform", "rotate-axis", "view"})
    void pointsAreTriedByTheMethodOfTheCell(String name) {
        Topic<?, ?, ?> topic =
                topics().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
        for (Hazard<?> hazard : topic.hazards())
            for (Method<?> method : topic.methods()) {
                open(name, hazard.name(), method.name());
                assertEquals(
                        CoordinatesMode.TRANSFORMATIONS, models.of(new CoordinatesRoom()).mode());
                assertEquals(
                        Optional.of(new Trial(name, hazard.name(), method.name())),
                        models.of(new CoordinatesRoom()).transformations().choice().trial());
            }
    }

    @ParameterizedTest
    @MethodSource("topics")
    void eachHazardIsShownUnlikeTheOthersOfItsTopic(Topic<?, ?, ?> topic) {
        var seen = new TreeMap<String, String>();
        String method = topic.methods().get(0).name();
        for (Hazard<?> hazard : topic.hazards()) {
            open(topic.name(), hazard.name(), method);
            String before = seen.put(choices().toString(), hazard.name());
            assertEquals(null, before, hazard.name() + " looks like " + before);
        }
    }

    @ParameterizedTest
    @EnumSource(NotShown.class)
    void reasonIsSaidInBothLanguages(NotShown why) {
        for (Language language : Language.values())
            assertFalse(why.in(Texts.of("canvas", language), "line").isBlank());
    }

    @Test
    void hazardOfLinesIsShownWithItsMethod() {
        models.of(new LineRoom()).chooseMode(LineMode.PEN);
        open("line", "leftward", "naive-textbook");
        assertEquals(LineMode.SEGMENT, models.of(new LineRoom()).mode());
        assertEquals("naive-textbook", models.of(new LineRoom()).state().choice().method());
        Segment segment = models.of(new LineRoom()).state().choice().segment();
        assertTrue(segment.x1() < segment.x0(), segment.toString());
        assertEquals(List.of("line"), tabs);
    }

    @Test
    void hazardIsShownInItsMode() {
        open("clip-polygon", "comb", "weiler-atherton");
        assertEquals(ClipMode.POLYGON, models.of(new ClipRoom()).state().choice().scene().mode());
        open("spline-function", spline(), "monotone");
        assertEquals(SplineMode.FUNCTION, models.of(new SplineRoom()).mode());
        assertEquals(List.of("clip", "spline"), tabs);
    }

    private String spline() {
        return models.of(new SplineRoom()).function().hazards().get(0).name();
    }
}
