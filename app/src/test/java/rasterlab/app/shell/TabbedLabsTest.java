package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.LabPanel;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** Tabs of a window that is open; skipped without a display. */
@Timeout(60)
class TabbedLabsTest {
    private final List<String> events = new CopyOnWriteArrayList<>();
    private final CountDownLatch mayGoOn = new CountDownLatch(1);
    private final List<LabTab> tabs =
            List.of(
                    tab("first", Optional.empty()),
                    tab("plain", Optional.empty()),
                    tab("slow", Optional.of(this::prepare)),
                    tab("broken", Optional.of(this::fail)));
    private TabbedLabs pane;
    private JFrame frame;

    @BeforeEach
    void open() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    pane = new TabbedLabs(tabs, Texts.of("shell", Language.ENGLISH));
                    pane.fill();
                    frame = new JFrame();
                    frame.setContentPane(pane);
                    frame.setSize(400, 300);
                    frame.setVisible(true);
                    events.clear();
                });
    }

    @AfterEach
    void close() throws Exception {
        if (frame != null) EventQueue.invokeAndWait(frame::dispose);
    }

    private LabTab tab(String name, Optional<Runnable> preparation) {
        return new LabTab(name, name, preparation, () -> new Lab(name));
    }

    private final class Lab extends LabPanel {
        private static final long serialVersionUID = 1L;

        Lab(String name) {
            events.add(name + " is made");
        }

        @Override
        public void focusPicture() {}

        @Override
        public void close() {}
    }

    private void prepare() {
        try {
            mayGoOn.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        events.add("prepared " + (EventQueue.isDispatchThread() ? "by events" : "beside events"));
    }

    private void fail() {
        throw new IllegalStateException("not prepared");
    }

    private void choose(String... names) throws Exception {
        EventQueue.invokeAndWait(() -> List.of(names).forEach(pane::show));
    }

    private int selected() throws Exception {
        var selected = new int[1];
        EventQueue.invokeAndWait(() -> selected[0] = pane.getSelectedIndex());
        return selected[0];
    }

    /** Waits until that tab is shown. */
    private void await(int index) throws Exception {
        while (selected() != index) Thread.onSpinWait();
        EventQueue.invokeAndWait(() -> {});
    }

    @Test
    void panelIsMadeLaidOutAndShownInEventsOfTheirOwn() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    pane.show("plain");
                    note();
                });
        await(1);
        assertEquals(List.of("before", "plain is made", "before", "laid out", "shown"), events);
    }

    /** In each event, until the plain tab is shown. */
    private void note() {
        if (pane.getSelectedIndex() == 1) {
            events.add("shown");
            return;
        }
        var place = (Container) pane.getComponentAt(1);
        boolean large = place.getComponentCount() == 1 && place.getComponent(0).getWidth() > 0;
        events.add(large ? "laid out" : "before");
        EventQueue.invokeLater(this::note);
    }

    @Test
    void windowAnswersWhileATabIsPrepared() throws Exception {
        choose("slow");
        for (int k = 0; k < 9; k++) assertEquals(0, selected());
        assertEquals(List.of(), events);
        mayGoOn.countDown();
        await(2);
        assertEquals(List.of("prepared beside events", "slow is made"), events);
    }

    @Test
    void panelIsMadeThoughItsPreparationFailed() throws Exception {
        choose("broken");
        await(3);
        assertEquals(List.of("broken is made"), events);
    }

    @Test
    void tabThatIsNotWantedAnyMoreIsNotMade() throws Exception {
        choose("slow", "plain", "first", "broken");
        mayGoOn.countDown();
        await(3);
        while (!events.contains("prepared beside events")) selected();
        for (int k = 0; k < 9; k++) assertEquals(3, selected());
        assertEquals(
                List.of("broken is made", "prepared beside events"),
                events.stream().sorted().toList());
    }

    @Test
    void windowClosedMeanwhileMakesNoPanel() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    pane.show("plain");
                    frame.dispose();
                });
        for (int k = 0; k < 9; k++) assertEquals(0, selected());
        assertEquals(List.of(), events);
    }
}
