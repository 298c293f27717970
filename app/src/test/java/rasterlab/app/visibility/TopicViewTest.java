package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.hidden.SurfaceView;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.Sight;

class TopicViewTest {
    private static final int WIDTH = 480;
    private static final int HEIGHT = 360;

    static Stream<Hazard<SurfaceView>> surfaces() {
        return new HiddenSurfacesTopic()
                .hazards().stream()
                        .filter(one -> TopicView.of("it", one.input()).obstacle().isEmpty());
    }

    static Stream<Hazard<Sight>> sights() {
        return new DepthOrderTopic()
                .hazards().stream()
                        .filter(one -> TopicView.of("it", one.input()).obstacle().isEmpty());
    }

    private static long wrongPixels(TopicView view, String method) {
        VisibilityChoice choice = view.shown(VisibilityChoice.first(), method);
        try (var renderer = new Renderer()) {
            return Compared.of(choice.plain(WIDTH, HEIGHT), renderer::render, () -> false)
                    .wrongPixels();
        }
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void whatIsRecordedAsWrongIsWrongInTheLabToo(Hazard<SurfaceView> hazard) {
        TopicView view = TopicView.of(hazard.name(), hazard.input()).view().orElseThrow();
        hazard.recorded()
                .forEach(
                        (method, kind) -> {
                            if (kind == Verdict.Kind.WRONG)
                                assertTrue(wrongPixels(view, method) > 0, method);
                        });
    }

    @ParameterizedTest
    @MethodSource("sights")
    void orderThatIsRecordedAsWrongIsPaintedWrong(Hazard<Sight> hazard) {
        TopicView view = TopicView.of(hazard.name(), hazard.input()).view().orElseThrow();
        Map.of("mean-z-textbook", "painter-textbook", "mean-z", "painter")
                .forEach(
                        (method, painter) -> {
                            if (hazard.recorded().get(method) == Verdict.Kind.WRONG)
                                assertTrue(wrongPixels(view, painter) > 0, painter);
                        });
    }

    @ParameterizedTest
    @MethodSource("sights")
    void somethingIsSeen(Hazard<Sight> hazard) {
        assertTrue(seen(TopicView.of(hazard.name(), hazard.input()).view().orElseThrow()) > 2000);
    }

    private static long seen(TopicView view) {
        VisibilityChoice choice = view.shown(VisibilityChoice.first(), Renderer.REFERENCE);
        try (var renderer = new Renderer()) {
            return java.util.Arrays.stream(
                            renderer.render(choice.plain(WIDTH, HEIGHT), () -> false).argb())
                    .filter(pixel -> pixel != 0xFFFFFFFF)
                    .count();
        }
    }

    @ParameterizedTest
    @MethodSource("bodies")
    void bodyIsSeenFromItsEye(TopicView view) {
        assertTrue(seen(view) > 2000);
    }

    static Stream<TopicView> bodies() {
        return new VisibleFacesTopic()
                .hazards().stream()
                        .flatMap(one -> TopicView.of(one.name(), one.input()).view().stream());
    }
}
