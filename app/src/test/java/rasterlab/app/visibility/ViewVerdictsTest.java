package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
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
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    private Map<String, Verdict.Kind> found(HazardView view) throws InterruptedException {
        var told = new AtomicReference<Map<String, Verdict.Kind>>();
        try (var verdicts = new ViewVerdicts(Runnable::run, failures::add)) {
            verdicts.ask(request(view), told::set);
            verdicts.settle();
        }
        assertEquals(List.of(), failures);
        return told.get();
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
