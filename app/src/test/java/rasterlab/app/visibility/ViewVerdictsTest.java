package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.visibility.scene.HazardView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

@Tag("slow")
@Timeout(300)
class ViewVerdictsTest {
    private static Map<String, Verdict.Kind> found(HazardView view) {
        var told = new CompletableFuture<Map<String, Verdict.Kind>>();
        try (var verdicts = new ViewVerdicts(Runnable::run, told::completeExceptionally)) {
            verdicts.ask(request(view), told::complete);
            return told.join();
        }
    }

    private static RenderRequest request(HazardView view) {
        return view.shown(VisibilityChoice.first()).plain(160, 120);
    }

    @ParameterizedTest(name = "{1} is said to be another than {2} in the view {0}")
    @CsvSource({
        "CYCLIC, painter, WRONG",
        "CYCLIC, newell, EXACT",
        "CYCLIC, bsp, EXACT",
        "PIERCING, painter, WRONG",
        "COARSE, z16, WRONG",
        "COARSE, raycast, EXACT",
        "COURSEWORK, convex, REFUSED"
    })
    void saysWhichMethodsFail(HazardView view, String method, Verdict.Kind kind)
            throws InterruptedException {
        assertEquals(kind, found(view).get(method));
    }

    @Test
    void tellsEveryMethodInTeachingOrder() throws InterruptedException {
        List<String> names = Renderer.visibilityMethods().stream().map(Method::name).toList();
        assertEquals(names, List.copyOf(found(HazardView.MEAN).keySet()));
        assertTrue(names.size() > 10);
    }
}
