package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.least.PlanBill;
import rasterlab.app.plan.least.PlanWish;
import rasterlab.app.plan.least.PlannedPicture;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.plan.ToleratedDifference;

/** The least picture in the lab of hidden surfaces. */
@Timeout(300)
class LeastVisibilityTest {
    private static final PlanWish WISH = new PlanWish(true, 1, 6, false);

    private final ModelThread thread = new ModelThread();
    private final Renderer renderer = new Renderer();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), renderer::render, thread, failures::add);

    @BeforeEach
    void showTorus() {
        model.resize(96, 72);
        model.choose(choice -> choice.withScene("torus"));
        settle();
    }

    @AfterEach
    void close() {
        model.close();
        renderer.close();
        assertEquals(List.of(), failures);
    }

    /** Waits for what a bill asks for anew too. */
    private void settle() {
        thread.settle(model::settle);
        thread.settle(model::settle);
    }

    private void wish(PlanWish wish) {
        model.choose(choice -> choice.with(wish));
        settle();
    }

    private PlannedPicture planned() {
        return model.state().picture().flatMap(Picture::planned).orElseThrow();
    }

    private PlanBill bill() {
        assertTrue(model.bills().planned().current(), "the bill is of an earlier picture");
        return model.bills().planned().bill().orElseThrow();
    }

    @Test
    @DisplayName("the lab opens with the least picture, or draws the method's though it is wished")
    void leastPictureIsDrawnWhereItIsWished() {
        assertTrue(model.state().picture().orElseThrow().planned().isEmpty());
        wish(WISH);
        PlannedPicture picture = planned();
        assertTrue(picture.plan().saves());
        var full = renderer.render(picture.plan().full(), () -> false);
        assertTrue(
                ToleratedDifference.of(full, picture.raster(), picture.plan().tolerance())
                        .within(picture.plan().tolerance()));
        assertSame(picture.plan(), bill().trial().plan());
        assertTrue(bill().holds());
        wish(WISH.with(false));
        assertTrue(model.state().picture().orElseThrow().planned().isEmpty());
    }

    @Test
    @DisplayName("a drag is measured at each picture, or its plan is made anew for each")
    void dragKeepsThePlanAndMeasuresAtItsEnd() {
        wish(WISH);
        PlannedPicture before = planned();
        model.beginDrag();
        for (int k = 0; k < 3; k++) {
            model.turn(before.plan().range().turn() / 5, 0);
            settle();
            assertSame(before.plan(), planned().plan());
            assertFalse(model.bills().planned().current(), "measured while it turns");
        }
        model.endDrag();
        settle();
        assertEquals(4, planned().pictures());
        assertEquals(model.state().choice().camera(), planned().camera());
        assertEquals(planned().raster().argb().length, bill().difference().raster().argb().length);
    }

    @Test
    @DisplayName("a method or view that is chosen by hand does not show, since the plan stays on")
    void whatIsChosenByHandIsShown() {
        List<Runnable> byHand =
                List.of(
                        () -> model.choose(choice -> choice.withVisibility("zfloat")),
                        () -> model.choose(choice -> choice.withComparison("bsp")),
                        () -> model.choose(choice -> choice.withShading("flat")),
                        () -> model.choose(choice -> choice.withView(StageView.DEPTHS)),
                        () -> model.choose(choice -> choice.withDifference(true)),
                        () -> model.watchSteps(true));
        for (Runnable choosing : byHand) {
            wish(WISH);
            planned();
            choosing.run();
            settle();
            assertTrue(model.state().picture().orElseThrow().planned().isEmpty());
            assertFalse(model.state().choice().least().on());
            model.reset();
        }
    }

    @Test
    @DisplayName("the wish is not undone, or what it took away does not come back")
    void wishIsPartOfTheHistory() {
        model.choose(choice -> choice.withComparison("bsp"));
        wish(WISH);
        assertEquals("", model.state().choice().comparison());
        model.history().undo();
        settle();
        assertEquals(PlanWish.FIRST, model.state().choice().least());
        assertEquals("bsp", model.state().choice().comparison());
    }

    @Test
    @DisplayName("the magnified difference is of an earlier view, or shown though not asked for")
    void differenceIsShownOfThePresentView() {
        wish(WISH);
        assertTrue(model.bills().magnified(model.state()).isEmpty());
        wish(WISH.withMagnified(true));
        assertSame(bill().difference(), model.bills().magnified(model.state()).orElseThrow());
        model.beginDrag();
        model.turn(0.01, 0);
        settle();
        assertTrue(model.bills().magnified(model.state()).isEmpty());
    }

    @Test
    @DisplayName("edges and two eyes, which no plan is made for, lose their picture")
    void whatHasNoPlanIsDrawnByItsMethod() {
        model.choose(choice -> choice.withShading("wire").with(WISH));
        settle();
        assertTrue(model.state().picture().orElseThrow().refusal().isEmpty());
        assertTrue(model.state().picture().orElseThrow().planned().isEmpty());
    }

    @Test
    @DisplayName("the copied command draws the method's picture in place of the least one")
    void commandDrawsTheSamePicture() {
        wish(WISH);
        String command = VisibilityCommand.now(model).text();
        assertTrue(
                command.contains("--visibility auto --tolerance 1.0 --levels 6.0 --projection"),
                command);
    }
}
