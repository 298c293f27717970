package rasterlab.app.visibility.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.app.visibility.Compared;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.hidden.SurfaceView;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.Sight;

class TopicViewTest {
    private static final int WIDTH = 480;
    private static final int HEIGHT = 360;

    static Stream<Hazard<SurfaceView>> surfaces() {
        return new HiddenSurfacesTopic().hazards().stream();
    }

    static Stream<Hazard<Sight>> sights() {
        return new DepthOrderTopic().hazards().stream();
    }

    private static long wrongPixels(TopicView view) {
        VisibilityChoice choice = view.shown(VisibilityChoice.first());
        try (var renderer = new Renderer()) {
            return Compared.of(choice.plain(WIDTH, HEIGHT), renderer::render, () -> false)
                    .wrongPixels();
        }
    }

    /** Sums of 24 bits drift only over more pixels than the tab's picture has, as its note says. */
    private static boolean needsALongerRow(Hazard<?> hazard, String method) {
        return hazard.name().equals("long-span-drift") && method.equals("z24");
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void whatIsRecordedAsWrongIsWrongInTheLabToo(Hazard<SurfaceView> hazard) {
        hazard.recorded()
                .forEach(
                        (method, kind) -> {
                            TopicView view = TopicView.of(hazard.name(), hazard.input(), method);
                            if (kind == Verdict.Kind.WRONG && !needsALongerRow(hazard, method))
                                assertTrue(wrongPixels(view) > 0, method);
                        });
    }

    @ParameterizedTest
    @MethodSource("sights")
    void orderThatIsRecordedAsWrongIsPaintedWrong(Hazard<Sight> hazard) {
        Map.of("mean-z-textbook", "painter-textbook", "mean-z", "painter")
                .forEach(
                        (method, painter) -> {
                            TopicView view =
                                    TopicView.of(hazard.name(), hazard.input(), method, painter);
                            if (hazard.recorded().get(method) == Verdict.Kind.WRONG)
                                assertTrue(wrongPixels(view) > 0, painter);
                        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"huge", "tiny"})
    void rightOrderOfAnyMagnitudeIsPaintedRight(String name) {
        Hazard<Sight> hazard = named(new DepthOrderTopic().hazards(), name);
        for (String method : List.of("newell", "bsp"))
            assertTrue(
                    wrongPixels(TopicView.of(name, hazard.input(), method, method)) < 20, method);
    }

    private static <I> Hazard<I> named(List<Hazard<I>> hazards, String name) {
        return hazards.stream().filter(one -> one.name().equals(name)).findFirst().orElseThrow();
    }

    /**
     * The sights but for those that every method refuses: what is out of range may be out of sight.
     */
    static Stream<Hazard<Sight>> sightsInRange() {
        return sights().filter(
                        hazard ->
                                hazard.recorded().values().stream()
                                        .anyMatch(kind -> kind != Verdict.Kind.REFUSED));
    }

    @ParameterizedTest
    @MethodSource("sightsInRange")
    void somethingIsSeen(Hazard<Sight> hazard) {
        assertTrue(seen(TopicView.of(hazard.name(), hazard.input(), "newell", "newell")) > 2000);
    }

    private static long seen(TopicView view) {
        return Arrays.stream(pixels(view)).filter(pixel -> pixel != 0xFFFFFFFF).count();
    }

    private static int[] pixels(TopicView view) {
        VisibilityChoice choice = view.shown(VisibilityChoice.first());
        try (var renderer = new Renderer()) {
            return renderer.render(choice.plain(WIDTH, HEIGHT), () -> false).argb();
        }
    }

    @ParameterizedTest
    @MethodSource("bodies")
    void bodyIsSeenFromItsEye(Hazard<Body> hazard) {
        assertTrue(
                seen(TopicView.of(hazard.name(), hazard.input(), "back-face", Renderer.REFERENCE))
                        > 2000);
    }

    static Stream<Hazard<Body>> bodies() {
        return new VisibleFacesTopic().hazards().stream();
    }

    /**
     * An input that cannot be given to the tab's methods is drawn as the topic's method has found
     * it.
     */
    @ParameterizedTest
    @MethodSource("bodies")
    void facesThatAMethodGetsWrongLookWrong(Hazard<Body> hazard) {
        String method = "convex-segment-textbook";
        TopicView found = TopicView.of(hazard.name(), hazard.input(), method, "convex");
        TopicView right = TopicView.of(hazard.name(), hazard.input(), "back-face", "convex");
        if (found.differences().isEmpty()) return;
        boolean wrong = hazard.recorded().get(method) == Verdict.Kind.WRONG;
        assertEquals(wrong, Arrays.mismatch(pixels(found), pixels(right)) >= 0, hazard.name());
    }

    @Test
    void refusedBodyIsDrawnWhole() {
        Hazard<Body> hazard = named(new VisibleFacesTopic().hazards(), "inner-point-outside");
        TopicView refused = TopicView.of("it", hazard.input(), "convex-segment", "convex");
        assertEquals(6, refused.scene().mesh().faceCount());
        assertEquals(List.of(ShownDifference.ShownDifferenceKind.FACES_ALL), kinds(refused));
        TopicView found = TopicView.of("it", hazard.input(), "back-face", "convex");
        assertEquals(3, found.scene().mesh().faceCount());
        assertEquals(List.of(ShownDifference.ShownDifferenceKind.FACES_FOUND), kinds(found));
    }

    private static List<ShownDifference.ShownDifferenceKind> kinds(TopicView view) {
        return view.differences().stream().map(ShownDifference::kind).toList();
    }
}
