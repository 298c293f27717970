package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JSpinner;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabStates;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.SplineRoom;
import rasterlab.contract.SplineEnds;

@Tag("slow")
class LongNumbersTest {
    /** Numbers as long as the labs have them. */
    private static final List<LabStates.Other> LONG =
            List.of(
                    new LabStates.Other(
                            "line", "last column", models -> showHazard(models, "last-column")),
                    new LabStates.Other(
                            "line", "beyond 2³⁰", models -> showHazard(models, "beyond-2-30")),
                    new LabStates.Other("spline", "steep ends", LongNumbersTest::showSteepEnds));

    @AfterAll
    static void typeIsOfUsualSizeAgain() throws InterruptedException {
        OffscreenPainter.onEventThread(LabTheme.LIGHT::install);
    }

    private static void showHazard(LabModels models, String name) {
        models.of(new LineRoom()).hazards().stream()
                .filter(hazard -> hazard.name().equals(name))
                .forEach(hazard -> models.of(new LineRoom()).show(hazard.input()));
    }

    private static void showSteepEnds(LabModels models) {
        models.of(new SplineRoom()).show(SplineMode.FUNCTION);
        models.of(new SplineRoom())
                .function()
                .chooseEnds(SplineEnds.slopes(-123456.1234, 9876543.4321));
    }

    @ParameterizedTest(name = "a long number is cut off and reads as another: {0}, {1} %")
    @CsvSource({"PROJECTOR, 100", "PROJECTOR, 200", "DARK, 100", "DARK, 125", "DARK, 150"})
    void wholeNumberIsSeen(LabTheme theme, int textPercent) throws InterruptedException {
        var tabs = new AtomicReference<LabTabs>();
        var models = new AtomicReference<LabModels>();
        var failures = new CopyOnWriteArrayList<Throwable>();
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(theme, textPercent);
                    models.set(LabModels.first(failures::add));
                    tabs.set(LabTabs.create(models.get(), Language.ENGLISH, failures::add));
                });
        for (LabStates.Other other : LONG) {
            JComponent panel = tabs.get().named(other.tab()).panel();
            OffscreenPainter.onEventThread(() -> other.change().accept(models.get()));
            for (int round = 0; round < 2; round++) OffscreenPainter.paint(panel, 1280, 680);
            var cut = new ArrayList<String>();
            inSpinners(panel, field -> CutText.of(field).ifPresent(cut::add));
            assertEquals(List.of(), cut, other.name());
        }
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.get().close();
                    models.get().close();
                });
        assertEquals(List.of(), failures, "what a lab could not do");
    }

    private static void inSpinners(Container container, Consumer<JSpinner> look) {
        for (Component child : container.getComponents()) {
            if (!child.isVisible()) continue;
            if (child instanceof JSpinner spinner) look.accept(spinner);
            else if (child instanceof Container inner) inSpinners(inner, look);
        }
    }
}
