package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.tab.LabTab;

@Tag("slow")
class InspectorWidthTest {
    private static final int WIDTH = 1280;

    /** About a third: the longest buttons of some tabs need a little more. */
    private static final double SHARE = 0.35;

    @AfterAll
    static void typeIsOfUsualSizeAgain() throws InterruptedException {
        OffscreenPainter.onEventThread(LabTheme.LIGHT::install);
    }

    @ParameterizedTest(name = "the projector''s large type leaves the stage too little: {0}")
    @EnumSource(Language.class)
    void inspectorTakesAThirdAndStaysInTheWindow(Language language) throws InterruptedException {
        var failures = new CopyOnWriteArrayList<Throwable>();
        var models = new AtomicReference<LabModels>();
        var tabs = new AtomicReference<LabTabs>();
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.PROJECTOR.install();
                    models.set(LabModels.first(failures::add));
                    tabs.set(LabTabs.create(models.get(), language, failures::add));
                    tabs.get().all().forEach(LabTab::panel);
                });
        for (LabTab tab : tabs.get().all()) {
            OffscreenPainter.paint(tab.panel(), WIDTH, 680);
            for (Component column : inspectors(tab.panel())) {
                int left = SwingUtilities.convertPoint(column, 0, 0, tab.panel()).x;
                assertTrue(
                        left + column.getWidth() <= WIDTH,
                        tab.name() + " ends at " + (left + column.getWidth()));
                assertTrue(
                        column.getWidth() <= SHARE * WIDTH,
                        tab.name() + " takes " + column.getWidth());
            }
        }
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.get().close();
                    models.get().close();
                });
        assertEquals(List.of(), failures, "what a lab could not do");
    }

    private static List<Component> inspectors(Container root) {
        var found = new ArrayList<Component>();
        for (Component child : root.getComponents()) {
            if (!child.isVisible()) continue;
            if ("inspector.scroll".equals(child.getName())) found.add(child);
            if (child instanceof Container inner) found.addAll(inspectors(inner));
        }
        return found;
    }
}
