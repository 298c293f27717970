package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.bill.BillTable;
import rasterlab.app.plan.bill.PictureBill;
import rasterlab.app.plan.least.PlanWish;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.Planner;
import rasterlab.engine.plan.WorkCount;
import rasterlab.engine.plan.WorkEstimate;

@Timeout(120)
class WorkBillTest {
    private final ModelThread thread = new ModelThread();
    private final Renderer renderer = new Renderer();
    private final List<Throwable> failures = new ArrayList<>();
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), renderer::render, thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private PictureBill bill() {
        return model.bills().counted().bill().orElseThrow();
    }

    /** Chooses the cube by a method and waits for what is told of it. */
    private RenderRequest shown(String method) {
        model.resize(60, 45);
        model.choose(choice -> choice.withScene("cube").withVisibility(method));
        thread.settle(model::settle);
        return model.state().picture().orElseThrow().request();
    }

    @Test
    @DisplayName("the work of another picture than the shown one is told")
    void workIsOfTheShownPicture() {
        for (String method : List.of("zfloat", "painter")) {
            RenderRequest request = shown(method);
            assertEquals(WorkCount.of(request, () -> false), bill().counted().work(), method);
            assertTrue(model.bills().counted().current(), method);
        }
    }

    @Test
    @DisplayName("shares leave out a stage, or the plan is of another size")
    void sharesAreOfAllThatIsTold() {
        RenderRequest request = shown("zfloat");
        double shares = bill().rows().stream().mapToDouble(PictureBill.BillRow::share).sum();
        assertEquals(1, shares, 1e-9);
        assertEquals(request.width(), bill().plan().least().width());
        assertEquals(request.camera(), bill().plan().full().camera());
    }

    @Test
    @DisplayName("a drag is counted at each frame, or an old count is told as if it were new")
    void dragMakesTheCountOld() {
        shown("zfloat");
        PictureBill before = bill();
        model.beginDrag();
        model.turn(0.3, 0);
        thread.settle(model::settle);
        assertFalse(model.bills().counted().current(), "counted while it turns");
        assertEquals(before, bill());
        model.endDrag();
        thread.settle(model::settle);
        assertTrue(model.bills().counted().current());
        assertEquals(
                model.state().choice().camera(), bill().plan().full().camera(), "of another view");
    }

    @Test
    @DisplayName("a picture that nobody waits for any more is counted to its end")
    void countingStopsWhenItIsCancelled() {
        RenderRequest request = shown("zfloat");
        assertThrows(
                CancellationException.class,
                () ->
                        PictureBill.of(
                                new PictureBill.BilledPicture(request, Optional.empty()),
                                new Planner(),
                                () -> true));
    }

    @Test
    @DisplayName("while the least picture is shown, another one's work is told, or another plan")
    void workIsOfTheLeastPictureThatIsShown() {
        shown("zfloat");
        model.choose(choice -> choice.withScene("torus").with(new PlanWish(true, 1, 8, false)));
        thread.settle(model::settle);
        // The least picture's bill is asked for once it is drawn.
        thread.settle(model::settle);
        Plan plan = model.state().least().orElseThrow().plan();
        assertTrue(plan.saves(), "nothing is left out of the torus");
        assertEquals(WorkCount.of(plan.least(), () -> false), bill().counted().work());
        assertEquals(plan, bill().plan());
        assertEquals(plan.cost().work(), bill().counted().estimate());
    }

    @Test
    @DisplayName("what was predicted of the shown picture is left out, or another's")
    void predictionStandsBesideTheCount() {
        RenderRequest request = shown("zfloat");
        assertEquals(WorkEstimate.of(request), bill().counted().estimate());
        for (PictureBill.BillRow row : bill().rows())
            assertEquals(
                    Optional.ofNullable(WorkEstimate.of(request).stages().get(row.stage())),
                    row.estimated());
    }

    @Test
    @DisplayName("the exact picture, whose work has no prices, keeps the count of another method")
    void methodsWithoutPricesHaveNoBill() {
        shown("zfloat");
        model.choose(choice -> choice.withShading("wire"));
        thread.settle(model::settle);
        assertTrue(model.bills().counted().current());
        assertTrue(model.bills().counted().bill().isEmpty());
    }

    @Test
    @DisplayName("the table leaves out a stage, its sum, or a language's way to write numbers")
    void tableHasEachStageAndTheirSum() {
        shown("zfloat");
        for (Language language : List.of(Language.ENGLISH, Language.RUSSIAN)) {
            var table = new BillTable(language);
            table.show(model.bills().counted());
            int last = table.getRowCount() - 1;
            assertEquals(bill().rows().size(), last);
            boolean english = language == Language.ENGLISH;
            assertEquals(english ? "all" : "всего", table.getValueAt(last, 0));
            assertEquals(english ? "100 %" : "100\u00a0%", table.getValueAt(last, 4));
            assertEquals(english ? "cleared" : "очистка", cell(table, -1, 0));
            assertEquals(english ? "2,700" : "2\u00a0700", cell(table, -1, 1));
        }
    }

    @Test
    @DisplayName("a count of six digits ends in dots")
    void numbersAreNeverCut() {
        model.resize(1000, 800);
        model.choose(choice -> choice.withScene("cube").withVisibility("zfloat"));
        thread.settle(model::settle);
        for (Language language : Language.values()) {
            var table = new BillTable(language);
            table.setFont(table.getFont().deriveFont(17f));
            table.show(model.bills().counted());
            table.setSize(460, table.getPreferredSize().height);
            table.doLayout();
            for (int row = 0; row < table.getRowCount(); row++)
                for (int column = 1; column < table.getColumnCount(); column++) {
                    int needed =
                            table.prepareRenderer(table.getCellRenderer(row, column), row, column)
                                    .getPreferredSize()
                                    .width;
                    int given = table.getCellRect(row, column, false).width;
                    assertTrue(needed <= given, table.getValueAt(row, column) + ": " + given);
                }
            assertTrue(table.getColumnModel().getColumn(0).getWidth() >= 60, "no stage is named");
        }
    }

    /**
     * @param row counted from the sum's
     */
    private static Object cell(BillTable table, int row, int column) {
        return table.getValueAt(table.getRowCount() - 1 + row, column);
    }
}
