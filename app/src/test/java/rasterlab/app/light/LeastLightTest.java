package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.least.PlanBill;
import rasterlab.app.plan.least.PlanWish;
import rasterlab.engine.light.Substance;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.plan.ToleratedDifference;
import rasterlab.engine.raster.Raster;

/** The least light that is enough in the lab of lighting. */
@Timeout(300)
class LeastLightTest {
    private static final PlanWish WISH = new PlanWish(true, 0.5, 8, true);

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final Renderer renderer = new Renderer();
    private final LightLabModel model =
            new LightLabModel(this::picture, new OwnMethods(), thread, failures::add);

    @BeforeEach
    void lightASphere() {
        model.resize(90, 100);
        model.choose(choice -> choice.with(MaterialChoice.of(Substance.named("chalk"))));
        settle();
    }

    @AfterEach
    void close() {
        model.close();
        renderer.close();
        assertEquals(List.of(), failures);
    }

    /** Waits for the pictures, then for what is measured of them. */
    private void settle() {
        thread.settle(model::settle);
        thread.settle(model::settle);
    }

    private LitPlans.ComparedPictures wish(PlanWish wish) {
        model.choose(choice -> choice.with(wish));
        settle();
        return pair();
    }

    private LitPlans.ComparedPictures pair() {
        return model.state().drawn().flatMap(LightFrame.DrawnFrame::least).orElseThrow();
    }

    private List<String> names() {
        return model.state().drawn().orElseThrow().pictures().stream()
                .map(LightFrame.ShadedPicture::name)
                .toList();
    }

    private PlanBill bill() {
        assertTrue(model.plans.bills().current(), "the bill is of an earlier picture");
        return model.plans.bills().bill().orElseThrow();
    }

    @Test
    @DisplayName("the lab opens without its three shadings, or the least light is not beside them")
    void leastLightStandsBesideTheFullOne() {
        assertEquals(List.of("flat", "gouraud", "phong"), names());
        LitPlans.ComparedPictures pair = wish(WISH);
        assertEquals(List.of("full", "least", "off"), names());
        assertTrue(pair.picture().plan().saves());
        Tolerance within = pair.picture().plan().tolerance();
        assertTrue(
                ToleratedDifference.of(pair.full(), pair.picture().raster(), within)
                        .within(within));
        assertTrue(bill().holds());
        model.choose(choice -> choice.with(WISH.with(false)));
        settle();
        assertEquals(List.of("flat", "gouraud", "phong"), names());
    }

    @Test
    @DisplayName("the plan is made anew for each view, or measured while the scene turns")
    void dragKeepsThePlanAndMeasuresAtItsEnd() {
        LitPlans.ComparedPictures before = wish(WISH);
        model.beginDrag();
        for (int k = 0; k < 3; k++) {
            model.turn(before.picture().plan().range().turn() / 5, 0);
            settle();
            assertSame(before.picture().plan(), pair().picture().plan());
            assertFalse(model.plans.bills().current(), "measured while it turns");
        }
        model.endDrag();
        settle();
        assertEquals(4, pair().picture().pictures());
        assertSame(pair().picture().plan(), bill().trial().plan());
    }

    @Test
    @DisplayName("the light before stays in the picture, for the plan is kept")
    void otherLightIsPlannedAnew() {
        LitPlans.ComparedPictures before = wish(WISH);
        model.choose(choice -> choice.withAmbient(0.9));
        settle();
        assertFalse(Arrays.equals(before.full().argb(), pair().full().argb()));
        assertArrayEquals(
                pair().full().argb(),
                model.state().drawn().orElseThrow().pictures().get(0).raster().argb());
        Tolerance within = pair().picture().plan().tolerance();
        assertTrue(
                ToleratedDifference.of(pair().full(), pair().picture().raster(), within)
                        .within(within));
    }

    @Test
    @DisplayName("the difference is magnified though that is not wished")
    void differenceIsMagnifiedWhereItIsWished() {
        LitPlans.ComparedPictures magnified = wish(WISH);
        assertEquals(3, magnified.difference().largest());
        assertEquals(64, magnified.difference().factor());
        LitPlans.ComparedPictures plain = wish(WISH.withMagnified(false));
        assertEquals(3, plain.difference().largest());
        assertEquals(1, plain.difference().factor());
    }

    /** Makes whatever leaves anything out too blue, within the tolerance. */
    private Raster picture(RenderRequest request, BooleanSupplier cancelled) {
        Raster raster = renderer.render(request, cancelled);
        if (request.look().savings().equals(Savings.NONE)) return raster;
        for (int i = 0; i < raster.argb().length; i++) {
            int blue = raster.argb()[i] & 255;
            raster.argb()[i] += blue < 128 ? 3 : -3;
        }
        return raster;
    }
}
