package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabStates;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.tab.LabTab;

/**
 * Texts and pictures in the smallest window and in a large one, in a laptop's as well with {@code
 * -Drasterlab.full=true}.
 */
@Tag("slow")
class ClippedTextTest {
    private static final Dimension SMALLEST = new Dimension(900, 538);
    private static final Dimension LAPTOP = new Dimension(1280, 680);
    private static final Dimension LARGE = new Dimension(2560, 1380);

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private LabModels models;
    private LabTabs tabs;

    @AfterAll
    static void typeIsOfUsualSizeAgain() throws InterruptedException {
        OffscreenPainter.onEventThread(UsualLook::install);
    }

    static Stream<Arguments> looks() {
        return Stream.of(Language.values())
                .flatMap(
                        language ->
                                Stream.of(
                                        Arguments.of(
                                                language,
                                                LabTheme.LIGHT,
                                                100,
                                                sizes(SMALLEST, LARGE)),
                                        Arguments.of(
                                                language, LabTheme.LIGHT, 150, sizes(SMALLEST)),
                                        Arguments.of(
                                                language,
                                                LabTheme.PROJECTOR,
                                                100,
                                                sizes(SMALLEST))));
    }

    private static List<Dimension> sizes(Dimension... always) {
        Stream<Dimension> laptop =
                Boolean.getBoolean("rasterlab.full") ? Stream.of(LAPTOP) : Stream.empty();
        return Stream.concat(Stream.of(always), laptop).toList();
    }

    @ParameterizedTest(name = "a label is cut off or a picture too small: {0}, {1}, {2} %")
    @MethodSource("looks")
    void everyTextAndPictureHasTheRoomItNeeds(
            Language language, LabTheme theme, int textPercent, List<Dimension> sizes)
            throws InterruptedException {
        open(language, theme, textPercent);
        for (LabTab tab : tabs.all())
            for (Dimension size : sizes) requireRoom(tab.panel(), size, 1, tab.name());
        for (LabStates.Other other : LabStates.others()) {
            OffscreenPainter.onEventThread(() -> other.change().accept(models));
            JComponent panel = tabs.named(other.tab()).panel();
            for (Dimension size : sizes)
                requireRoom(panel, size, 2, other.tab() + ": " + other.name());
        }
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.close();
                    models.close();
                });
        assertEquals(List.of(), failures, "what a lab could not do");
    }

    private void open(Language language, LabTheme theme, int textPercent)
            throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    DesktopType.install(theme, textPercent);
                    LabLayout.showCrowdingInspectors(true);
                    models = LabModels.first(failures::add);
                    models.of(new LineRoom()).compareWith("naive-textbook");
                    tabs = LabTabs.create(models, language, failures::add);
                    tabs.all().forEach(LabTab::panel);
                });
    }

    /**
     * @param rounds in which the panel is painted before it has settled
     */
    private static void requireRoom(JComponent panel, Dimension size, int rounds, String what)
            throws InterruptedException {
        for (int round = 0; round < rounds; round++)
            OffscreenPainter.paint(panel, size.width, size.height);
        String where = what + " in " + size.width + "×" + size.height;
        assertEquals(List.of(), clipped(panel), where);
        assertEquals(List.of(), UsefulSize.faults(panel), where);
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
