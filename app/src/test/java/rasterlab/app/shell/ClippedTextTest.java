package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.LabLayout;
import rasterlab.app.language.Language;

class ClippedTextTest {
    @AfterAll
    static void typeIsOfUsualSizeAgain() throws InterruptedException {
        OffscreenPainter.onEventThread(UsualLook::install);
    }

    static Stream<Arguments> sizes() {
        return Stream.of(Language.values())
                .flatMap(
                        language ->
                                Stream.of(
                                        Arguments.of(language, LabTheme.LIGHT, 100, 900, 538),
                                        Arguments.of(language, LabTheme.LIGHT, 100, 1280, 680),
                                        Arguments.of(language, LabTheme.LIGHT, 100, 2560, 1380),
                                        Arguments.of(language, LabTheme.LIGHT, 150, 900, 538),
                                        Arguments.of(language, LabTheme.LIGHT, 150, 1280, 680),
                                        Arguments.of(language, LabTheme.PROJECTOR, 100, 900, 538),
                                        Arguments.of(
                                                language, LabTheme.PROJECTOR, 100, 1280, 680)));
    }

    @ParameterizedTest(
            name = "a label is cut off or a picture too small: {0}, {1}, {2} % in {3}×{4}")
    @MethodSource("sizes")
    void everyTextAndPictureHasTheRoomItNeeds(
            Language language, LabTheme theme, int textPercent, int width, int height)
            throws InterruptedException {
        var tabs = new AtomicReference<LabTabs>();
        var models = new AtomicReference<LabModels>();
        var failures = new CopyOnWriteArrayList<Throwable>();
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(theme, textPercent);
                    LabLayout.showCrowdingInspectors(true);
                    models.set(LabModels.first(failures::add));
                    models.get().line().compareWith("naive-textbook");
                    tabs.set(LabTabs.create(models.get(), language, failures::add));
                    tabs.get().all().forEach(LabTab::panel);
                });
        for (LabTab tab : tabs.get().all()) {
            OffscreenPainter.paint(tab.panel(), width, height);
            assertEquals(List.of(), clipped(tab.panel()), tab.name());
            assertEquals(List.of(), UsefulSize.faults(tab.panel()), tab.name());
        }
        for (LabStates.Other other : LabStates.others()) {
            JComponent panel = tabs.get().named(other.tab()).panel();
            OffscreenPainter.onEventThread(() -> other.change().accept(models.get()));
            for (int round = 0; round < 2; round++) OffscreenPainter.paint(panel, width, height);
            String where = other.tab() + ": " + other.name();
            assertEquals(List.of(), clipped(panel), where);
            assertEquals(List.of(), UsefulSize.faults(panel), where);
        }
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.get().close();
                    models.get().close();
                });
        assertEquals(List.of(), failures, "what a lab could not do");
    }

    private static List<String> clipped(Container container) {
        var found = new ArrayList<String>();
        for (Component child : container.getComponents()) {
            if (!child.isVisible()) continue;
            CutText.of(child).ifPresent(found::add);
            if (child instanceof Container inner && !(child instanceof JComboBox))
                found.addAll(clipped(inner));
        }
        return found;
    }
}
