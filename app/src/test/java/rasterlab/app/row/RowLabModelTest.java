package rasterlab.app.row;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.mapping.MappingTopic;
import rasterlab.engine.visibility.depth.DepthBufferTopic;

@Tag("slow")
class RowLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final RowLabModel depths =
            RowLabModel.ofDepths(new OwnMethods(), thread, failures::add);
    private final RowLabModel textures =
            RowLabModel.ofTextures(new OwnMethods(), thread, failures::add);

    @AfterEach
    void end() {
        depths.end();
        textures.end();
        assertEquals(List.of(), failures);
    }

    static Stream<Arguments> cells() {
        return Stream.of(new DepthBufferTopic(), new MappingTopic(), new FilterTopic())
                .flatMap(RowLabModelTest::cells);
    }

    private static <C, I, O> Stream<Arguments> cells(Topic<C, I, O> topic) {
        return topic.hazards().stream()
                .flatMap(
                        hazard ->
                                topic.methods().stream()
                                        .map(each -> Arguments.of(topic.name(), hazard, each)));
    }

    private RowLabModel shown(String topic, String hazard, String method) {
        RowLabModel model = depths.topics().contains(topic) ? depths : textures;
        model.show(topic, hazard, method);
        settle(model);
        return model;
    }

    /** Waits for what is asked for and hands the answer to the model. */
    private void settle(RowLabModel model) {
        model.shown();
        thread.settle(model::settle);
    }

    private static RowScene scene(RowLabModel model) {
        return model.shown().orElseThrow();
    }

    @ParameterizedTest(name = "{0} {1} {2}")
    @MethodSource("cells")
    void whatIsRecordedIsSeen(String topic, Hazard<?> hazard, Method<?> method) {
        RowScene scene = scene(shown(topic, hazard.name(), method.name()));
        Verdict.Kind recorded = hazard.recorded().get(method.name());
        assertEquals(recorded, scene.verdict().kind());
        boolean refused = recorded == Verdict.Kind.REFUSED;
        assertEquals(refused, scene.bands().size() == 1);
        assertEquals(refused, scene.errors().length == 0);
        if (recorded == Verdict.Kind.WRONG) assertTrue(scene.wrongPixels() > 0);
        if (recorded == Verdict.Kind.EXACT) assertEquals(0, scene.wrongPixels());
    }

    @ParameterizedTest(name = "{0} {1} {2}")
    @MethodSource("cells")
    void exactRowLooksLikeTheRightOneButWhereTwoSurfacesAreLevel(
            String topic, Hazard<?> hazard, Method<?> method) {
        RowScene scene = scene(shown(topic, hazard.name(), method.name()));
        if (scene.verdict().kind() != Verdict.Kind.EXACT || topic.equals("texture-filter")) return;
        if (hazard.name().equals("twice-the-same")) return;
        for (RowScene.ColorBand band : scene.bands())
            assertArrayEquals(scene.bands().get(0).argb(), band.argb(), band.key());
    }

    @Test
    void depthsThatAreToldApartByNoCodeAreSeenByTheOrderOfDrawing() {
        RowScene scene = scene(shown("depth-buffer", "far-near-million", "z24"));
        assertEquals(scene.bands().get(0).argb()[0], scene.bands().get(1).argb()[0]);
        assertFalse(scene.bands().get(0).argb()[0] == scene.bands().get(2).argb()[0]);
    }

    @Test
    void numbersAreThoseOfTheChosenPixel() {
        RowLabModel model = shown("texture-mapping", "floor", "affine");
        model.choosePixel(299);
        RowScene.NumberRow t = scene(model).numbers().apply(299).lines().get(1);
        assertEquals("t", t.name());
        assertArrayEquals(new double[] {1, 1}, t.values());
        model.choosePixel(150);
        double[] middle = scene(model).numbers().apply(150).lines().get(1).values();
        assertTrue(middle[0] < 0.2 && middle[1] > 0.5, middle[0] + " " + middle[1]);
    }

    @Test
    void rowOpensAtItsFirstWrongPixel() {
        RowLabModel model = shown("depth-buffer", "drift-8192", "incremental-float");
        assertTrue(scene(model).wrong()[model.choice().pixel()]);
        assertFalse(scene(model).wrong()[model.choice().pixel() - 1]);
        model.choosePixel(1 << 20);
        assertEquals(8191, model.choice().pixel());
    }

    @Test
    void anotherTopicStartsAnewAndIsUndone() {
        textures.show("texture-mapping", "long-row", "stepped-float");
        RowChoice before = textures.choice();
        textures.open("texture-filter");
        assertEquals("texture-filter", textures.choice().topic());
        textures.history().undo();
        assertEquals(before, textures.choice());
        assertTrue(textures.open());
        textures.close();
        assertFalse(textures.open());
    }

    @Test
    void choiceOfAnotherTimeIsRefusedAndWhatWasShownStays() {
        RowChoice before = depths.choice();
        for (RowChoice bad :
                new RowChoice[] {
                    new RowChoice("depth-buffer", "crossing", "z24", 8192),
                    new RowChoice("depth-buffer", "crossing", "z48", 0),
                    new RowChoice("depth-buffer", "none", "z24", 0),
                    new RowChoice("line", "crossing", "z24", 0)
                }) assertThrows(IllegalArgumentException.class, () -> depths.restore(bad));
        assertEquals(before, depths.choice());
    }

    @Test
    void nothingIsShownOfAnotherRowWhileAnAnswerIsFound() {
        textures.show("texture-filter", "turned", "summed-area");
        assertEquals(Optional.empty(), textures.shown(), "the event thread is held up");
        assertEquals("turned", textures.choice().hazard());
        settle(textures);
        RowScene first = scene(textures);
        textures.chooseMethod("linear");
        assertEquals(Optional.empty(), textures.shown(), "the row of another method");
        settle(textures);
        assertNotSame(first, scene(textures));
        textures.choosePixel(3);
        assertTrue(textures.shown().isPresent(), "another pixel is no other row");
    }

    @Test
    void pixelThatIsChosenMeanwhileStays() {
        depths.show("depth-buffer", "drift-8192", "incremental-float");
        depths.choosePixel(7);
        settle(depths);
        assertEquals(7, depths.choice().pixel());
    }

    @Test
    void answerToAnEarlierChoiceIsNotShownAsThePresentOnes() {
        depths.show("depth-buffer", "drift-8192", "z16");
        depths.shown();
        depths.show("depth-buffer", "crossing", "z24");
        settle(depths);
        RowScene scene = scene(depths);
        assertEquals(depths.pixels(), scene.pixels());
        assertEquals("crossing", depths.choice().hazard());
    }

    @Test
    void hazardAndThePixelThatIsLookedForInItAreOneChange() {
        settle(depths);
        RowChoice before = depths.choice();
        depths.show("depth-buffer", "drift-8192", "incremental-float");
        settle(depths);
        assertTrue(depths.choice().pixel() > 0, "no pixel was looked for");
        depths.history().undo();
        assertEquals(before, depths.choice());
    }

    @Test
    void redoneRowIsShownFromItsFirstWrongPixel() {
        depths.show("depth-buffer", "drift-8192", "incremental-float");
        depths.history().undo();
        settle(depths);
        depths.history().redo();
        settle(depths);
        assertEquals("drift-8192", depths.choice().hazard());
        assertTrue(scene(depths).wrong()[depths.choice().pixel()], "before its answer was there");
        int found = depths.choice().pixel();
        depths.history().undo();
        settle(depths);
        depths.history().redo();
        settle(depths);
        assertEquals(found, depths.choice().pixel());
    }

    @Test
    void copyWaitsForTheRowItIsOf() {
        var copied = new ArrayList<RowScene>();
        depths.show("depth-buffer", "drift-8192", "z16");
        depths.whenShown(() -> copied.add(scene(depths)));
        depths.show("depth-buffer", "crossing", "z24");
        depths.whenShown(() -> copied.add(scene(depths)));
        assertEquals(List.of(), copied, "before the answer");
        settle(depths);
        assertEquals(List.of(scene(depths)), copied, "the present row alone");
        depths.whenShown(() -> copied.add(scene(depths)));
        assertEquals(2, copied.size());
    }

    @Test
    void methodThatCrashesIsSaidToAndTheNextRowIsShown() {
        var kind = new DepthKind(new CrashingDepths("z24"));
        var model = new RowLabModel(List.of(kind), thread, failures::add);
        try {
            model.show("depth-buffer", "crossing", "z24");
            settle(model);
            assertEquals(Verdict.Kind.CRASHED, scene(model).verdict().kind());
            assertTrue(scene(model).verdict().detail().contains("broken"));
            assertEquals(1, scene(model).bands().size(), "what is right");
            model.chooseMethod("z16");
            settle(model);
            assertEquals(3, scene(model).bands().size());
        } finally {
            model.end();
        }
    }
}
